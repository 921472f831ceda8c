// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/backuppage.h"

#include "files/zip.h"
#include "protocol/codes.h"
#include "settings/profilestore.h"
#include "ui/dialogs/restoredialog.h"
#include "ui/pages/files/backupchoices.h"
#include "ui/pages/files/comparisoncard.h"
#include "ui/pages/files/parts.h"
#include "ui/pages/files/timeline.h"
#include "ui/widgets/filesheet.h"
#include "ui/widgets/flow.h"
#include "ui/widgets/orderbutton.h"
#include <QComboBox>
#include <QDir>
#include <QPushButton>
#include <QSpinBox>
#include <QtConcurrent>

using robot::Act;

namespace pages {

namespace {

/// What the chosen backup is compared with, in the order of the box.
enum With { TheOneBefore, Newest, Controller };

QSpinBox *spin(const QString &suffix, const char *name, const QString &unlimited)
{
    auto *result = new QSpinBox;
    result->setObjectName(QLatin1String(name));
    result->setAccessibleName(unlimited);
    result->setRange(0, 9999);
    result->setSuffix(suffix);
    result->setSpecialValueText(unlimited);
    return result;
}

values::Result<files::Bag> noBag() { return values::failure(values::ErrorKind::LocalFile); }

} // namespace

BackupPage::BackupPage(const Context &context, QWidget *parent)
    : Page(context, parent),
      m_context {context},
      m_orders {context.station.orders},
      m_timeline {new Timeline},
      m_state {widgets::sentence({}, ui::Role::Text2)},
      m_keep {spin(tr(" newest"), "keepCount", tr("Keep any number"))},
      m_keepDays {spin(tr(" days"), "keepDays", tr("Keep any age"))},
      m_backUp {button(tr("Back up now"), "backUp")},
      m_verify {button(tr("Verify"), "verifyBackup")},
      m_pin {button(tr("Pin"), "pinBackup")},
      m_export {button(tr("Export…"), "exportBackup")},
      m_with {new QComboBox},
      m_compare {button(tr("Compare"), "compareBackups")},
      m_restore {new widgets::OrderButton(context.station.orders, Act::Restore)},
      m_comparison {new ComparisonCard(protocol::TextCodec {context.station.profile().encoding})}
{
    auto *content = new QWidget;
    auto *row = new QHBoxLayout(content);
    row->setContentsMargins(ui::space::page, ui::space::page, ui::space::page, ui::space::page);
    row->setSpacing(ui::space::gap);
    row->addWidget(timelineCard(), 2);
    row->addWidget(m_comparison, 3);
    fillComparison();
    setContent(content);
    connect(m_timeline, &QTreeWidget::itemSelectionChanged, this, &BackupPage::updateButtons);
    connect(m_backUp, &QPushButton::clicked, this, &BackupPage::backUp);
    connect(m_verify, &QPushButton::clicked, this, &BackupPage::verifyChosen);
    connect(m_pin, &QPushButton::clicked, this, &BackupPage::togglePin);
    connect(m_export, &QPushButton::clicked, this, &BackupPage::exportChosen);
    connect(&m_exporting, &QFutureWatcherBase::finished, this, [this] {
        const auto written = m_exporting.result();
        say(written ? tr("Exported.") : tr("▲ Not exported: %1").arg(protocol::explain(written.error())));
        updateButtons();
    });
    connect(m_compare, &QPushButton::clicked, this, &BackupPage::compareChosen);
    connect(m_restore, &widgets::OrderButton::clicked, this, &BackupPage::planRestore);
    connect(&m_verifying, &QFutureWatcherBase::finished, this, [this] {
        const files::Verification found = m_verifying.result();
        say(found.isGood() ? tr("Good: every byte of %n file(s) is as it was written.", nullptr, found.files)
                           : tr("▲ Not good: %1").arg(explain(found.faults.first())));
        updateButtons();
    });
    connect(this, &Page::visibilityChanged, this, [this] {
        if (isVisible())
            reload(); // others write backups too
    });
    const BackupChoices choices = readBackupChoices(context.station.notes());
    m_keep->setValue(choices.retention.count);
    m_keepDays->setValue(choices.retention.days);
    m_root = choices.folder;
    say(tr("In %1").arg(QDir::toNativeSeparators(archive().folder())));
    reload();
    for (const QSpinBox *box : {m_keep, m_keepDays})
        connect(box, &QSpinBox::valueChanged, this, &BackupPage::keepChoices);
}

QWidget *BackupPage::timelineCard()
{
    auto *card = new widgets::Card(tr("Backups"));
    auto *folder = button(tr("Folder…"), "chooseBackupFolder");
    connect(folder, &QPushButton::clicked, this, &BackupPage::chooseFolder);
    m_state->setObjectName(QStringLiteral("backupState"));
    auto *buttons = new widgets::Flow;
    for (QPushButton *each : {m_backUp, m_verify, m_pin, m_export})
        buttons->addWidget(each);
    buttons->addStretch();
    buttons->addWidget(folder);
    auto *keeping = new widgets::Flow;
    keeping->addWidget(widgets::text(tr("After a backup keep"), ui::Type::Body, ui::Role::Text2));
    keeping->addWidget(m_keep);
    keeping->addWidget(m_keepDays);
    keeping->addStretch();
    card->body()->addLayout(buttons);
    card->body()->addWidget(m_state);
    card->body()->addWidget(m_timeline, 1);
    card->body()->addLayout(keeping);
    card->body()->addWidget(
        widgets::sentence(tr("The last good backup and pinned ones are never deleted."), ui::Role::Text2));
    return card;
}

void BackupPage::fillComparison()
{
    m_with->setObjectName(QStringLiteral("compareWith"));
    m_with->setAccessibleName(tr("Compare with"));
    m_with->addItems({tr("with the backup before"), tr("with the newest backup"), tr("with the controller now")});
    m_comparison->tools()->addWidget(m_compare);
    m_comparison->tools()->addWidget(m_with);
    m_comparison->tools()->addStretch();
    m_restore->setText(tr("Restore…"));
    m_comparison->body()->addWidget(m_restore);
}

QList<robot::TopicRange> BackupPage::topics() const
{
    return {robot::topics::status, robot::topics::masterJob, robot::topics::systemInformation};
}

void BackupPage::showLink(const ui::LinkView &link)
{
    Page::showLink(link);
    m_isUp = link.state == robot::LinkState::Monitoring;
    updateButtons();
}

files::Archive BackupPage::archive() const { return {m_root, m_context.station.profile().name}; }

void BackupPage::say(const QString &sentence) { m_state->setText(sentence); }

void BackupPage::setRoot(const QString &root)
{
    m_root = root;
    say(tr("In %1").arg(QDir::toNativeSeparators(archive().folder())));
    keepChoices();
    reload();
}

void BackupPage::chooseFolder()
{
    widgets::askForPath({"backupFolderDialog", widgets::PathKind::Folder, tr("Folder of the backups"), m_root}, this,
        [this](const QString &chosen) { setRoot(chosen); });
}

files::Retention BackupPage::retention() const { return {m_keep->value(), m_keepDays->value()}; }

void BackupPage::keepChoices() { writeBackupChoices(m_context.station.notes(), {m_root, retention()}); }

void BackupPage::reload()
{
    m_timeline->showEntries(archive().entries());
    updateButtons();
}

bool BackupPage::isBusy() const { return (m_backup && !m_backup->isOver()) || (m_snapshot && !m_snapshot->isOver()); }

QString BackupPage::unfinished() const
{
    return isBusy() ? tr("Files are still being read for a backup or a comparison.") : QString();
}

void BackupPage::updateButtons()
{
    const auto entry = m_timeline->chosen();
    m_backUp->setEnabled(m_isUp && !isBusy());
    m_verify->setEnabled(entry && !m_verifying.isRunning());
    m_export->setEnabled(entry && !m_exporting.isRunning());
    m_pin->setEnabled(entry.has_value());
    m_pin->setText(entry && entry->isPinned ? tr("Unpin") : tr("Pin"));
    m_compare->setEnabled(entry && entry->isReadable && !isBusy());
    m_restore->setComplaint(!entry ? tr("Choose a backup first.") : isBusy() ? tr("Files are being read.") : QString());
}

files::BackupOrder BackupPage::order() const
{
    files::BackupOrder order;
    order.root = m_root;
    order.info.controller = m_context.station.profile().name;
    order.info.host = m_context.station.profile().host;
    if (const auto &system = m_context.station.state().systemInformation().value) {
        order.info.model = QString::fromLatin1(system->model.bytes());
        order.info.software = QString::fromLatin1(system->software.bytes());
        order.info.parameterVersion = QString::fromLatin1(system->parameters.bytes());
    }
    return order;
}

void BackupPage::backUp()
{
    session::FileSession *session = m_context.station.controller.files();
    if (!session)
        return;
    files::BackupOrder order = this->order();
    order.retention = retention();
    m_backup = std::make_unique<files::Backup>(*session, order);
    connect(m_backup.get(), &files::Operation::progressed, this, [this] {
        say(m_backup->filesTotal() > 0
                ? tr("Reading file %1 of %2…").arg(m_backup->filesDone() + 1).arg(m_backup->filesTotal())
                : tr("Reading the lists…"));
    });
    connect(m_backup.get(), &files::Operation::finished, this, &BackupPage::onBackedUp);
    m_backup->start();
    say(tr("Reading the lists…"));
    updateButtons();
}

void BackupPage::onBackedUp()
{
    const int failures = m_backup->info().failures();
    const int all = int(m_backup->info().results.size());
    if (m_backup->error())
        say(tr("▲ There is no new backup: %1").arg(protocol::explain(*m_backup->error())));
    else if (failures > 0)
        say(tr("▲ %1 of %2 files were backed up.").arg(all - failures).arg(all));
    else
        say(tr("All %n file(s) were backed up.", nullptr, all));
    reload();
}

void BackupPage::exportChosen()
{
    const auto entry = m_timeline->chosen();
    if (!entry)
        return;
    const QString name = QDir::home().filePath(entry->id + QStringLiteral(".zip"));
    widgets::askForPath({"backupExportDialog", widgets::PathKind::NewFile, tr("Export the backup"), name,
                            {tr("Zip files (*.zip)")}, QStringLiteral("zip")},
        this, [this](const QString &target) { exportTo(target); });
}

void BackupPage::exportTo(const QString &target)
{
    const auto entry = m_timeline->chosen();
    if (!entry || m_exporting.isRunning())
        return;
    say(tr("Exporting to %1…").arg(QDir::toNativeSeparators(target)));
    m_exporting.setFuture(QtConcurrent::run(files::writeZip, entry->path, target));
    updateButtons();
}

void BackupPage::verifyChosen()
{
    const auto entry = m_timeline->chosen();
    if (!entry)
        return;
    say(tr("Reading every byte…"));
    m_verifying.setFuture(QtConcurrent::run(files::verify, entry->path));
    updateButtons();
}

void BackupPage::togglePin()
{
    const auto entry = m_timeline->chosen();
    if (!entry)
        return;
    if (const auto pinned = archive().setPinned(entry->id, !entry->isPinned); !pinned)
        say(protocol::explain(pinned.error()));
    reload();
}

void BackupPage::compareChosen()
{
    const auto entry = m_timeline->chosen();
    const auto bag = entry ? files::Bag::open(entry->path) : noBag();
    if (!bag)
        return;
    if (m_with->currentIndex() == Controller)
        return readController(
            [this, set = bag->files()](const files::FileSet &now) { m_comparison->showSets(set, now); });
    const int row = m_timeline->chosenRow();
    const int other = m_with->currentIndex() == TheOneBefore ? row + 1 : 0;
    const auto &entries = m_timeline->entries();
    const auto second = other < entries.size() && other != row ? files::Bag::open(entries[other].path) : noBag();
    if (!second)
        return m_comparison->showSentence(tr("There is no other backup to compare with."));
    if (other > row)
        m_comparison->showSets(second->files(), bag->files());
    else
        m_comparison->showSets(bag->files(), second->files());
}

void BackupPage::readController(const std::function<void(const files::FileSet &)> &handler)
{
    session::FileSession *session = m_context.station.controller.files();
    if (!session)
        return;
    m_snapshot = std::make_unique<files::Snapshot>(*session);
    connect(m_snapshot.get(), &files::Operation::progressed, this,
        [this] { say(tr("Reading file %1 of %2…").arg(m_snapshot->filesDone()).arg(m_snapshot->filesTotal())); });
    connect(m_snapshot.get(), &files::Operation::finished, this, [this, handler] {
        updateButtons();
        if (m_snapshot->error())
            return say(protocol::explain(*m_snapshot->error()));
        say(tr("The controller's files were read."));
        handler(m_snapshot->files());
    });
    m_snapshot->start();
    updateButtons();
}

void BackupPage::planRestore()
{
    const auto entry = m_timeline->chosen();
    const auto bag = entry ? files::Bag::open(entry->path) : noBag();
    if (!bag)
        return;
    readController([this, bag = *bag](const files::FileSet &now) {
        session::FileSession *session = m_context.station.controller.files();
        if (!session)
            return;
        const auto identity =
            files::compareIdentities(files::identityOf(bag.info(), bag.files()), files::identityOf(order().info, now));
        const bool isOther = files::isAnotherRobot(identity);
        const auto plan = files::planRestore(bag.files(), now, {{}, m_orders.jobsInUse(), isOther});
        auto *dialog = new dialogs::RestoreDialog(m_context.station.profile(), bag.info().taken, plan, this);
        dialog->showIdentity(identity);
        connect(dialog, &dialogs::RestoreDialog::confirmed, this, [this, bag, dialog](const auto &chosenPlan) {
            if (session::FileSession *files = m_context.station.controller.files())
                dialog->follow(std::make_unique<files::Restore>(
                    *files, bag.files(), chosenPlan, order(), m_orders.guard(Act::Restore)));
        });
        connect(dialog, &dialogs::RestoreDialog::tried, this,
            [this](const files::Upload *upload) { m_orders.note(*upload, Act::Upload); });
        connect(dialog, &QDialog::finished, this, &BackupPage::reload);
        dialog->show();
    });
}

} // namespace pages
