// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "disk/worker.h"
#include "files/collection.h"
#include "ui/pages/files/offers.h"
#include "ui/pages/files/remotechanges.h"
#include <QFileSystemWatcher>

class QComboBox;
class QLabel;
class QPushButton;

namespace widgets {
class OrderButton;
}

namespace pages {

class FilePane;

/// Computer and controller beside each other, and the transfers between them.
class FilesPage : public Page
{
    Q_OBJECT

public:
    explicit FilesPage(const Context &context, QWidget *parent = nullptr);

    [[nodiscard]] QList<robot::TopicRange> topics() const override;
    void showLink(const ui::LinkView &link) override;

    /// The folder of this computer that the left pane shows.
    void openFolder(const QString &folder);
    /// Reads the list of the chosen type from the controller.
    void refresh();

private:
    QWidget *panes();
    QWidget *between();
    void updateButtons();
    void onListed();
    void onFinished(const files::Task *task);
    /// Reads the local folder again.
    void showFolder();
    void showLocal(const QStringList &locals);
    void chooseFolder();
    void fetchChosen();
    void sendChosen();
    void removeChosen();
    void editChosen();
    /// What is chosen in the right pane.
    [[nodiscard]] QList<values::FileName> chosenNames() const;

    const Context m_context;
    files::TransferQueue &m_queue;
    Offers m_offers;
    RemoteChanges m_changes;
    std::unique_ptr<files::Collection> m_listing;
    QString m_folder;
    QFileSystemWatcher m_watcher; ///< Others put files into the folder too.
    QList<values::FileName> m_names; ///< What the controller listed last.
    bool m_isListed = false;
    bool m_isUp = false;
    disk::Worker m_disk; ///< The local folder may be in the network.

    FilePane *m_local;
    FilePane *m_remote;
    QComboBox *m_type;
    QLabel *m_path;
    QPushButton *m_refresh;
    QPushButton *m_fetch;
    QPushButton *m_editButton;
    widgets::OrderButton *m_send;
    widgets::OrderButton *m_remove;
};

} // namespace pages
