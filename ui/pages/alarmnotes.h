// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "journal/store.h"
#include <QMap>
#include <QWidget>

class QLabel;
class QListWidget;
class QPlainTextEdit;
class QPushButton;
class QSpinBox;

namespace pages {

/// What people noted about alarm codes: cause, and what they did. What was typed is kept when another code is chosen.
class AlarmNotes : public QWidget
{
    Q_OBJECT

public:
    /// `store` must outlive the widget.
    explicit AlarmNotes(journal::Store &store, QWidget *parent = nullptr);
    ~AlarmNotes() override;

    void chooseCode(quint32 code);
    /// The note of a code; an empty one if there is none.
    [[nodiscard]] journal::Note note(quint32 code) const { return m_notes.value(code); }

Q_SIGNALS:
    void changed();

private:
    void lay();
    void load();
    void showNote();
    void save();
    void showChanged();
    void fillList();
    [[nodiscard]] bool isEdited() const;

    journal::Store &m_store;
    QMap<quint32, journal::Note> m_notes;
    quint32 m_code = 1;
    QListWidget *m_list;
    QSpinBox *m_codeBox;
    QPlainTextEdit *m_cause;
    QPlainTextEdit *m_remedy;
    QLabel *m_by;
    QPushButton *m_save;
    QPushButton *m_export;
};

} // namespace pages
