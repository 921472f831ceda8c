// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/filespage.h"

#include "files/durable.h"
#include "files/localname.h"
#include "files/preflight.h"
#include "protocol/codes.h"
#include "ui/dialogs/comparedialog.h"
#include "ui/dialogs/jobeditor.h"
#include "ui/models/queuemodel.h"
#include "ui/pages/files/filepane.h"
#include "ui/widgets/orderbutton.h"
#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QHeaderView>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>
#include <QTableView>

using files::OperationState;
using robot::Act;
using values::FileName;
using values::Result;

namespace pages {

namespace {

QPushButton *button(const QString &text, const char *name)
{
    auto *result = new QPushButton(text);
    result->setObjectName(QLatin1String(name));
    result->setAutoDefault(false);
    return result;
}

QString documents() { return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation); }

} // namespace

FilesPage::FilesPage(const Context &context, QWidget *parent)
    : Page(context, parent),
      m_context {context},
      m_orders {context.orders},
      m_local {new FilePane(tr("This computer"), QStringLiteral("localFiles"))},
      m_remote {new FilePane(tr("Controller"), QStringLiteral("remoteFiles"))},
      m_type {new QComboBox},
      m_path {widgets::sentence({}, ui::Role::Text2)},
      m_refresh {button(tr("Read again"), "refreshFiles")},
      m_fetch {button(tr("← Fetch"), "fetchFiles")},
      m_editButton {button(tr("Edit…"), "editFile")},
      m_send {new widgets::OrderButton(context.orders, Act::Upload)},
      m_remove {new widgets::OrderButton(context.orders, Act::DeleteFile)},
      m_table {new QTableView}
{
    auto *content = new QWidget;
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(ui::space::page, ui::space::page, ui::space::page, ui::space::page);
    column->setSpacing(ui::space::gap);
    column->addWidget(panes(), 3);
    column->addWidget(queueCard(), 2);
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
    openFolder(documents());
    updateButtons();
}

QWidget *FilesPage::panes()
{
    auto *folder = button(tr("Folder…"), "chooseFolder");
    connect(folder, &QPushButton::clicked, this, [this] {
        const QString chosen = QFileDialog::getExistingDirectory(this, tr("Folder of the files"), m_folder);
        if (!chosen.isEmpty())
            openFolder(chosen);
    });
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
    m_send->setText(tr("Send →"));
    m_remove->setText(tr("Delete…"));

    auto *between = new QVBoxLayout;
    between->setSpacing(ui::space::gap);
    between->addStretch();
    for (QWidget *each : {static_cast<QWidget *>(m_send), static_cast<QWidget *>(m_fetch),
             static_cast<QWidget *>(m_editButton), static_cast<QWidget *>(m_remove)})
        between->addWidget(each);
    between->addStretch();
    auto *middle = new QWidget;
    middle->setLayout(between);
    middle->setFixedWidth(200);
    auto *result = new QWidget;
    auto *row = new QHBoxLayout(result);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(ui::space::gap);
    row->addWidget(m_local, 1);
    row->addWidget(middle);
    row->addWidget(m_remote, 1);
    return result;
}

QWidget *FilesPage::queueCard()
{
    auto *card = new widgets::Card(tr("Transfers"));
    auto *cancel = button(tr("Cancel"), "cancelTransfer");
    auto *retry = button(tr("Retry failed"), "retryTransfers");
    auto *clear = button(tr("Clear finished"), "clearTransfers");
    m_table->setModel(new models::QueueModel(m_queue, protocol::TextCodec {m_context.profile.encoding}, m_table));
    m_table->setObjectName(QStringLiteral("transfers"));
    m_table->setAccessibleName(tr("Transfers"));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setShowGrid(false);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(26);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->horizontalHeader()->setSectionResizeMode(models::QueueModel::State, QHeaderView::Stretch);
    m_table->horizontalHeader()->setFont(ui::font(ui::Type::Label));
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->setColumnWidth(models::QueueModel::Name, 180);
    m_table->setColumnWidth(models::QueueModel::Direction, 150);
    m_table->setColumnWidth(models::QueueModel::Bytes, 150);
    auto *row = new QHBoxLayout;
    row->addStretch();
    for (QPushButton *each : {cancel, retry, clear})
        row->addWidget(each);
    card->body()->addWidget(m_table, 1);
    card->body()->addLayout(row);
    connect(cancel, &QPushButton::clicked, this, [this] {
        for (const QModelIndex &index : m_table->selectionModel()->selectedRows())
            m_queue.cancel(index.row());
    });
    connect(retry, &QPushButton::clicked, &m_queue, &files::TransferQueue::retryFailed);
    connect(clear, &QPushButton::clicked, &m_queue, &files::TransferQueue::clearFinished);
    return card;
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

QString FilesPage::text(const FileName &name) const
{
    return protocol::TextCodec {m_context.profile.encoding}.decode(name.bytes());
}

void FilesPage::openFolder(const QString &folder)
{
    m_folder = folder;
    m_path->setText(QDir::toNativeSeparators(folder));
    showFolder();
}

void FilesPage::showFolder()
{
    QList<QByteArray> keys;
    QStringList words;
    for (const QString &local : QDir {m_folder}.entryList(QDir::Files, QDir::Name)) {
        const auto name = files::fromLocalName(local);
        if (!name || !(files::isLoadable(*name) || name->extension() == "SYS"))
            continue;
        keys << local.toUtf8();
        words << text(*name);
    }
    m_local->showFiles(keys, words);
    m_local->setReason(keys.isEmpty() ? tr("There are no controller files in this folder.") : QString());
}

void FilesPage::refresh()
{
    session::FileSession *session = m_context.controller.files();
    if (!session)
        return;
    m_isListed = true;
    m_listing = std::make_unique<files::Collection>(*session, files::Collection::Sink {});
    m_listing->setPatterns({m_type->currentData().toByteArray()});
    m_listing->setListingOnly(true);
    m_remote->setReason(tr("Reading the list…"));
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
        words << text(*name);
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

void FilesPage::fetchChosen()
{
    QList<Offer> offers;
    for (const QByteArray &key : m_remote->chosen()) {
        const auto name = FileName::create(key);
        const QString path = m_folder + u'/' + files::toLocalName(key);
        if (name)
            offers << Offer {files::Direction::Download, *name, path, QFileInfo::exists(path)};
    }
    offer(offers);
}

void FilesPage::sendChosen()
{
    QList<Offer> offers;
    for (const QByteArray &key : m_local->chosen()) {
        const QString local = QString::fromUtf8(key);
        if (const auto name = files::fromLocalName(local))
            offers << Offer {files::Direction::Upload, *name, m_folder + u'/' + local, m_names.contains(*name)};
    }
    lookAndOffer(offers);
}

void FilesPage::lookAndOffer(const QList<Offer> &offers)
{
    QList<Offer> passing;
    QStringList sentences;
    for (const Offer &each : offers) {
        const auto content = files::readFile(each.localPath);
        const auto findings = files::preflight(each.name, content.value_or(QByteArray()), m_orders.jobsInUse());
        if (files::mayBeSent(findings))
            passing << each;
        for (const files::Finding &finding : findings)
            sentences << QStringLiteral("%1 %2: %3")
                             .arg(finding.stops() ? QStringLiteral("▲") : QStringLiteral("·"), text(each.name),
                                 explain(finding));
    }
    if (sentences.isEmpty())
        return offer(passing);
    auto *box = new QMessageBox(QMessageBox::Warning, tr("Before sending"), sentences.join(u'\n'), {}, this);
    box->setObjectName(QStringLiteral("preflight"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->addButton(QMessageBox::Cancel);
    if (!passing.isEmpty())
        box->addButton(tr("Send %n file(s)", nullptr, int(passing.size())), QMessageBox::AcceptRole);
    box->setDefaultButton(QMessageBox::Cancel);
    connect(box, &QDialog::finished, this, [this, box, passing] {
        if (box->buttonRole(box->clickedButton()) == QMessageBox::AcceptRole)
            offer(passing);
    });
    box->open();
}

void FilesPage::offer(const QList<Offer> &offers)
{
    m_offers = offers;
    m_forAll.reset();
    askNext();
}

void FilesPage::askNext()
{
    while (!m_offers.isEmpty() && (!m_offers.first().isTaken || m_forAll))
        decide(m_offers.first().isTaken ? *m_forAll : Choice::Replace);
    if (m_offers.isEmpty())
        return;
    const Offer &first = m_offers.first();
    const bool isDownload = first.direction == files::Direction::Download;
    const QString where = isDownload ? tr("on this computer") : tr("on %1").arg(m_context.profile.name);
    auto *dialog = new dialogs::OverwriteDialog(text(first.name), where, isDownload, int(m_offers.size()) - 1, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::finished, this, [this, dialog] {
        if (dialog->choice() == Choice::Compare)
            return compare(m_offers.first());
        if (dialog->isForAll())
            m_forAll = dialog->choice();
        decide(dialog->choice());
        askNext();
    });
    dialog->open();
}

void FilesPage::decide(Choice choice)
{
    Offer offer = m_offers.takeFirst();
    if (choice == Choice::Skip)
        return;
    if (choice == Choice::KeepBoth)
        offer.localPath = files::freePath(m_folder, offer.name);
    carryOut(offer);
}

void FilesPage::carryOut(const Offer &offer)
{
    auto task = offer.direction == files::Direction::Download ? m_orders.download(offer.name, offer.localPath)
                                                              : m_orders.upload(offer.name, offer.localPath);
    if (task)
        m_queue.add(std::move(task));
}

void FilesPage::readRemote(const FileName &name, const std::function<void(const QByteArray &)> &handler)
{
    if (session::FileSession *session = m_context.controller.files())
        session->save(name, this, [this, name, handler](const Result<QByteArray> &content) {
            if (content)
                handler(*content);
            else
                tell(text(name), protocol::explain(content.error()));
        });
}

void FilesPage::compare(const Offer &offer)
{
    readRemote(offer.name, [this, offer](const QByteArray &remote) {
        const QByteArray local = files::readFile(offer.localPath).value_or(QByteArray());
        const bool isDownload = offer.direction == files::Direction::Download;
        const protocol::TextCodec codec {m_context.profile.encoding};
        auto *dialog = new dialogs::CompareDialog(tr("What would change in “%1”").arg(text(offer.name)),
            isDownload ? local : remote, isDownload ? remote : local, codec, {}, this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        connect(dialog, &QDialog::finished, this, &FilesPage::askNext);
        dialog->open();
    });
}

void FilesPage::tell(const QString &title, const QString &text)
{
    auto *box = new QMessageBox(QMessageBox::Information, title, text, QMessageBox::Close, this);
    box->setObjectName(QStringLiteral("fileMessage"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

void FilesPage::removeChosen()
{
    QList<FileName> names;
    QStringList words;
    for (const QByteArray &key : m_remote->chosen()) {
        if (const auto name = FileName::create(key)) {
            names << *name;
            words << text(*name);
        }
    }
    const QString folder = m_folder + QStringLiteral("/deleted");
    auto *box = new QMessageBox(QMessageBox::Warning, tr("Delete on %1").arg(m_context.profile.name),
        tr("These files are deleted on %1:\n%2\nBefore that each is copied to %3.")
            .arg(m_context.profile.name, words.join(u'\n'), QDir::toNativeSeparators(folder)),
        QMessageBox::Cancel, this);
    box->setObjectName(QStringLiteral("deleteFiles"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    auto *yes = box->addButton(tr("Delete %n file(s)", nullptr, int(names.size())), QMessageBox::DestructiveRole);
    yes->setObjectName(QStringLiteral("confirmDelete"));
    box->setDefaultButton(QMessageBox::Cancel);
    connect(yes, &QPushButton::clicked, this, [this, names, folder] {
        for (const FileName &name : names) {
            if (auto task = m_orders.remove(name, folder))
                m_queue.add(std::move(task));
        }
    });
    box->open();
}

void FilesPage::editChosen()
{
    const auto chosen = m_remote->chosen();
    const auto name = chosen.size() == 1 ? FileName::create(chosen.first())
                                         : Result<FileName>(values::failure(values::ErrorKind::BadInput));
    if (name)
        readRemote(*name, [this, name = *name](const QByteArray &content) { edit(name, content); });
}

void FilesPage::edit(const FileName &name, const QByteArray &content)
{
    auto *editor = new dialogs::JobEditor(name, content, protocol::TextCodec {m_context.profile.encoding}, this);
    editor->setAttribute(Qt::WA_DeleteOnClose);
    connect(editor, &dialogs::JobEditor::sendRequested, this,
        [this, editor, name, content](const QByteArray &edited) { send(name, content, edited, editor); });
    editor->open();
}

void FilesPage::send(const FileName &name, const QByteArray &older, const QByteArray &newer, QWidget *parent)
{
    const protocol::TextCodec codec {m_context.profile.encoding};
    const bool mayChange = older != newer && !m_context.orders.obstacle(Act::Upload);
    auto *dialog = new dialogs::CompareDialog(tr("What changes in “%1” on %2").arg(text(name), m_context.profile.name),
        older, newer, codec, mayChange ? tr("Send") : QString(), parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, name, newer, parent] {
        if (auto task = m_orders.upload(name, newer))
            m_queue.add(std::move(task));
        parent->close();
    });
    dialog->open();
}

} // namespace pages
