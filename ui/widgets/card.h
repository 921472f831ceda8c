// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/widgets/line.h"
#include "ui/widgets/text.h"
#include <QVBoxLayout>

namespace widgets {

/// A flat sheet with a title, a note at the right and a body.
class Card : public QWidget
{
    Q_OBJECT

public:
    explicit Card(const QString &title, QWidget *parent = nullptr);

    [[nodiscard]] QVBoxLayout *body() const { return m_body; }
    void setTitle(const QString &title);
    void setNote(const QString &note);
    /// Why the values of this card are missing, or how the last order ended: a line under the title, whose room is
    /// kept.
    void setReason(const QString &reason);

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QLabel *m_title;
    QLabel *m_note;
    Line *m_reason;
    QVBoxLayout *m_body;
};

} // namespace widgets
