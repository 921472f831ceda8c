// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/filespage.h"

#include "files/localname.h"
#include "files/preflight.h"
#include "protocol/codes.h"
#include "ui/pages/files/filepane.h"
#include "ui/pages/files/parts.h"
#include "ui/pages/files/queuecard.h"
#include "ui/pages/files/remotefile.h"
#include "ui/widgets/filesheet.h"
#include "ui/widgets/orderbutton.h"
#include <QComboBox>
#include <QDir>
#include <QPushButton>
#include <QStandardPaths>

using robot::Act;
using values::FileName;

namespace pages {

namespace {

QString documents() { return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation); }

} // namespace

FilesPage::FilesPage(const Context &context, QWidget *parent)
    : Page(context, parent),
      m_context {context},
      m_queue {context.station.transfers},
      m_offers {context, this},
      m_changes {context, this},
      m_local {new FilePane(tr("This computer"), QStringLiteral("localFiles"))},
      m_remote {new FilePane(tr("Controller"), QStringLiteral("remoteFiles"))},
      m_type {new QComboBox},
      m_path {widgets::sentence({}, ui::Role::Text2)},
      m_refresh {button(tr("Read again"), "refreshFiles")},
      m_fetch {button(tr("← Fetch"), "fetchFiles")},
      m_editButton {button(tr("Edit…"), "editFile")},
      m_send {new widgets::OrderButton(context.station.orders, Act::Upload)},
      m_remove {new widgets::OrderButton(context.station.orders, Act::DeleteFile)}
{
    auto *content = new QWidget;
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(ui::space::page, 0, ui::space::page, ui::space::page);
    column->setSpacing(ui::space::gap);
    column->addWidget(panes(), 3);
    column->addWidget(new QueueCard(m_queue, protocol::TextCodec {context.station.profile().encoding}), 2);
    setContent(content);
    connect(m_local, &FilePane::chosenChanged, this, &FilesPage::updateButtons);
    connect(m_remote, &FilePane::chosenChanged, this, &FilesPage::updateButtons);
    connect(m_local, &FilePane::dropped, this, &FilesPage::fetchChosen);
    connect(m_remote, &FilePane::dropped, this, &FilesPage::sendChosen);
    connect(m_remote, &FilePane::activated, this, &FilesPage::editChosen);
    connect(m_refresh, &QPushButton::clicked, this, &FilesPage::refresh);
    connect(m_fetch, &QPushButton::clicked, this, &FilesPage::fetchChosen);
    connect(m_editButton, &QPushButton::clicked, this, &FilesPage::editChosen);
    connect(m_send, &widgets::OrderButton::clicked, this, &FilesPage::sendChosen);
    connect(m_remove, &widgets::OrderButton::clicked, this, &FilesPage::removeChosen);
    connect(m_type, &QComboBox::currentIndexChanged, this, &FilesPage::refresh);
    connect(&m_queue, &files::TransferQueue::finished, this, &FilesPage::onFinished);
    connect(this, &Page::visibilityChanged, this, [this] {
        if (isVisible() && !m_isListed)
            refresh();
    });
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, &FilesPage::showFolder);
    openFolder(documents());
    updateButtons();
}

QWidget *FilesPage::panes()
{
    auto *folder = button(tr("Folder…"), "chooseFolder");
    connect(folder, &QPushButton::clicked, this, &FilesPage::chooseFolder);
    m_path->setObjectName(QStringLiteral("localFolder"));
    m_local->tools()->addWidget(m_path, 1);
    m_local->tools()->addWidget(folder);
    m_type->setObjectName(QStringLiteral("fileType"));
    m_type->setAccessibleName(tr("Type of the files"));
    for (const QByteArray &pattern : files::Collection::allPatterns())
        m_type->addItem(QString::fromLatin1(pattern.sliced(2)), pattern);
    m_remote->tools()->addWidget(m_type);
    m_remote->tools()->addStretch();
    m_remote->tools()->addWidget(m_refresh);
    auto *result = new QWidget;
    auto *row = new QHBoxLayout(result);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(ui::space::gap);
    row->addWidget(m_local, 1);
    row->addWidget(between());
    row->addWidget(m_remote, 1);
    return result;
}

QWidget *FilesPage::between()
{
    m_send->setText(tr("Send →"));
    m_remove->setText(tr("Delete…"));
    auto *result = new QWidget;
    auto *column = new QVBoxLayout(result);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(ui::space::gap);
    column->addStretch();
    for (QWidget *each : std::initializer_list<QWidget *> {m_send, m_fetch, m_editButton, m_remove})
        column->addWidget(each);
    column->addStretch();
    return result;
}

QList<robot::TopicRange> FilesPage::topics() const { return {robot::topics::status, robot::topics::masterJob}; }

void FilesPage::showLink(const ui::LinkView &link)
{
    Page::showLink(link);
    m_isUp = link.state == robot::LinkState::Monitoring;
    m_refresh->setEnabled(m_isUp);
    m_remote->setStale(!m_isUp);
    if (!m_isUp)
        m_isListed = false;
    else if (isVisible() && !m_isListed)
        refresh();
    updateButtons();
}

void FilesPage::openFolder(const QString &folder)
{
    if (!m_watcher.directories().isEmpty())
        m_watcher.removePaths(m_watcher.directories());
    m_watcher.addPath(folder);
    m_folder = folder;
    m_path->setText(QDir::toNativeSeparators(folder));
    showFolder();
}

void FilesPage::chooseFolder()
{
    widgets::askForPath({"folderDialog", widgets::PathKind::Folder, tr("Folder of the files"), m_folder}, this,
        [this](const QString &chosen) { openFolder(chosen); });
}

namespace {

/// Regular files and links to them: a pipe or a device is none that could be sent.
QStringList filesIn(const QString &folder) { return QDir {folder}.entryList(QDir::Files, QDir::Name); }

/// The offers with what each would replace here.
QList<Offer> withReplaced(QList<Offer> offers)
{
    for (Offer &offer : offers)
        offer.isTaken = QFileInfo::exists(offer.localPath);
    return offers;
}

} // namespace

void FilesPage::showFolder()
{
    m_disk.run(
        this, [folder = m_folder] { return filesIn(folder); },
        [this](const QStringList &locals) { showLocal(locals); });
}

void FilesPage::showLocal(const QStringList &locals)
{
    QList<QByteArray> keys;
    QStringList words;
    for (const QString &local : locals) {
        const auto name = files::fromLocalName(local);
        if (!name || !(files::isLoadable(*name) || name->extension() == "SYS"))
            continue;
        keys << local.toUtf8();
        words << text(m_context, *name);
    }
    m_local->showFiles(keys, words);
    m_local->setReason(keys.isEmpty() ? tr("There are no controller files in this folder.") : QString());
}

void FilesPage::refresh()
{
    session::FileSession *session = m_context.station.controller.files();
    if (!session)
        return;
    m_isListed = true;
    m_listing = std::make_unique<files::Collection>(*session, files::Collection::Sink {});
    m_listing->setPatterns({m_type->currentData().toByteArray()});
    m_listing->setListingOnly(true);
    m_remote->setReason({});
    m_remote->setNote(tr("Reading the list…"));
    connect(m_listing.get(), &files::Operation::finished, this, &FilesPage::onListed);
    m_listing->start();
}

void FilesPage::onListed()
{
    std::optional<values::Error> error = m_listing->error();
    QList<QByteArray> keys;
    QStringList words;
    m_names.clear();
    for (const files::FileResult &result : m_listing->results()) {
        const auto name = FileName::create(result.name);
        if (result.error && !name)
            error = result.error;
        if (result.error || !name)
            continue;
        m_names << *name;
        keys << name->bytes();
        words << text(m_context, *name);
    }
    m_remote->showFiles(keys, words);
    m_remote->setReason(error ? protocol::explain(*error)
            : keys.isEmpty()  ? tr("The controller lists no files of this type.")
                              : QString());
    updateButtons();
}

void FilesPage::updateButtons()
{
    const auto remote = m_remote->chosen().size();
    m_fetch->setEnabled(m_isUp && remote > 0);
    m_editButton->setEnabled(m_isUp && remote == 1);
    m_send->setComplaint(m_local->chosen().isEmpty() ? tr("Choose files on the left first.") : QString());
    m_remove->setComplaint(remote == 0 ? tr("Choose files on the right first.") : QString());
}

void FilesPage::onFinished(const files::Task *task)
{
    if (task->direction() == files::Direction::Download)
        showFolder();
    else if (m_queue.isIdle())
        refresh();
}

QList<FileName> FilesPage::chosenNames() const
{
    QList<FileName> names;
    for (const QByteArray &key : m_remote->chosen()) {
        if (const auto name = FileName::create(key))
            names << *name;
    }
    return names;
}

void FilesPage::fetchChosen()
{
    QList<Offer> offers;
    for (const FileName &name : chosenNames()) {
        const QString path = m_folder + u'/' + files::toLocalName(name.bytes());
        offers << Offer {files::Direction::Download, name, path, false};
    }
    m_disk.run(
        this, [offers] { return withReplaced(offers); }, [this](const QList<Offer> &looked) { m_offers.ask(looked); });
}

void FilesPage::sendChosen()
{
    QList<Offer> offers;
    for (const QByteArray &key : m_local->chosen()) {
        const QString local = QString::fromUtf8(key);
        if (const auto name = files::fromLocalName(local))
            offers << Offer {files::Direction::Upload, *name, m_folder + u'/' + local, m_names.contains(*name)};
    }
    m_offers.lookAndAsk(offers);
}

void FilesPage::removeChosen() { m_changes.remove(chosenNames(), m_folder + QStringLiteral("/deleted")); }

void FilesPage::editChosen()
{
    if (const auto names = chosenNames(); names.size() == 1)
        m_changes.edit(names.first());
}

} // namespace pages
