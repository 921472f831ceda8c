// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/identity.h"
#include "files/restore.h"
#include "settings/profile.h"
#include "ui/widgets/dialogsheet.h"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace dialogs {

/// What a restore would do, file by file; and, once it was confirmed, how it goes.
class RestoreDialog : public widgets::DialogSheet
{
    Q_OBJECT

public:
    RestoreDialog(const settings::Profile &profile, const QDateTime &taken, const QList<files::RestoreItem> &plan,
        QWidget *parent = nullptr);

    /// Holds the backup and the controller beside each other, above the plan.
    void showIdentity(const QList<files::IdentityRow> &rows);
    /// Begins it and shows how it goes; it goes on when the dialog is gone.
    void follow(std::shared_ptr<files::Restore> restore);
    /// Closing it while files are sent cancels that first, and the dialog stays to tell how far it came.
    void reject() override;

Q_SIGNALS:
    /// The person wants it so; what was taken off the list is not in it.
    void confirmed(const QList<files::RestoreItem> &plan);
    /// A file was put back, or could not be.
    void tried(const files::Upload *upload);

private:
    void addItem(const files::RestoreItem &item);
    [[nodiscard]] QList<files::RestoreItem> chosenPlan() const;
    void countChosen();
    void showProgress();
    void onFinished();
    [[nodiscard]] QString refusedText(const QList<files::FileResult> &refused) const;
    void putBack();

    settings::Profile m_profile;
    QList<files::RestoreItem> m_plan;
    QLabel *m_identity;
    QTreeWidget *m_items;
    QLabel *m_state;
    QPushButton *m_go;
    QPushButton *m_putBack;
    QPushButton *m_close;
    std::shared_ptr<files::Restore> m_restore;
    std::unique_ptr<files::Upload> m_back;
};

} // namespace dialogs
