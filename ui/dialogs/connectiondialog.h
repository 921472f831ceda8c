// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "settings/profilestore.h"
#include "ui/widgets/dialogsheet.h"

class QLabel;
class QListWidget;
class QPushButton;

namespace dialogs {

class LadderView;
class ProfileForm;

/// The controllers that are known: add, copy, remove, change, and connect to one. Not modal; deletes itself when
/// closed.
class ConnectionDialog : public widgets::DialogSheet
{
    Q_OBJECT

public:
    /// `store` must outlive the dialog; `selected` is the name of the profile to begin with.
    ConnectionDialog(settings::ProfileStore &store, const QString &selected, QWidget *parent = nullptr);

Q_SIGNALS:
    /// The profile is valid and saved.
    void connectRequested(const settings::Profile &profile);

private:
    [[nodiscard]] QWidget *listColumn();
    [[nodiscard]] QWidget *formColumn();
    void fill(const QString &selected);
    [[nodiscard]] QString selectedName() const;
    void onSelected();
    void onEdited();
    void add();
    void duplicate();
    void remove();
    bool save();
    void connectNow();
    [[nodiscard]] QString unusedName(const QString &wish) const;
    [[nodiscard]] QString complaint(const settings::Profile &profile) const;

    settings::ProfileStore &m_store;
    QListWidget *m_list;
    QPushButton *m_duplicate;
    QPushButton *m_remove;
    ProfileForm *m_form;
    QLabel *m_complaint;
    QPushButton *m_save;
    QPushButton *m_connect;
    LadderView *m_ladder;
};

} // namespace dialogs
