// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/collection.h"
#include "ui/dialogs/overwritedialog.h"
#include "ui/pages/files/fileorders.h"
#include "ui/pages/page.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTableView;

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
    using Choice = dialogs::OverwriteDialog::Choice;

    /// A file that may be sent or fetched.
    struct Offer {
        files::Direction direction;
        values::FileName name;
        QString localPath;
        bool isTaken = false; ///< The name exists where it is to go.
    };

    QWidget *panes();
    QWidget *queueCard();
    void updateButtons();
    void onListed();
    void onFinished(const files::Task *task);
    void showFolder();
    void fetchChosen();
    void sendChosen();
    void removeChosen();
    void edit(const values::FileName &name, const QByteArray &content);
    void send(const values::FileName &name, const QByteArray &older, const QByteArray &newer, QWidget *parent);
    void editChosen();
    /// Looks at files before they are sent, tells what was found, and offers those that may be sent.
    void lookAndOffer(const QList<Offer> &offers);
    /// Asks about one after the other where its name is taken.
    void offer(const QList<Offer> &offers);
    void askNext();
    void decide(Choice choice);
    void carryOut(const Offer &offer);
    /// Reads what the controller has of a file.
    void readRemote(const values::FileName &name, const std::function<void(const QByteArray &)> &handler);
    /// Shows what the person is asked about, and asks again.
    void compare(const Offer &offer);
    void tell(const QString &title, const QString &text);
    [[nodiscard]] QString text(const values::FileName &name) const;

    const Context m_context;
    FileOrders m_orders;
    files::TransferQueue m_queue;
    std::unique_ptr<files::Collection> m_listing;
    QString m_folder;
    QList<values::FileName> m_names; ///< What the controller listed last.
    bool m_isListed = false;
    bool m_isUp = false;
    QList<Offer> m_offers; ///< Still to be decided about.
    std::optional<Choice> m_forAll;

    FilePane *m_local;
    FilePane *m_remote;
    QComboBox *m_type;
    QLabel *m_path;
    QPushButton *m_refresh;
    QPushButton *m_fetch;
    QPushButton *m_editButton;
    widgets::OrderButton *m_send;
    widgets::OrderButton *m_remove;
    QTableView *m_table;
};

} // namespace pages
