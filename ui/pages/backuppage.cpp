// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/backuppage.h"

#include "files/zip.h"
#include "protocol/codes.h"
#include "settings/profilestore.h"
#include "ui/dialogs/restoredialog.h"
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

using Contents = values::Result<files::FileSet>;

/// Every file of a backup; may block.
Contents contentsOf(const QString &path)
{
    return files::Bag::open(path).map([](const files::Bag &bag) { return bag.files(); });
}

Contents none() { return values::failure(values::ErrorKind::LocalFile); }

/// As the list of backups calls it.
QString nameOf(const files::ArchiveEntry &entry)
{
    return QLocale().toString(entry.taken.toLocalTime(), QLocale::ShortFormat);
}

} // namespace

BackupPage::BackupPage(const Context &context, QWidget *parent)
    : Page(context, parent),
      m_context {context},
      m_backups {context.station.backups},
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
    row->setContentsMargins(ui::space::page, 0, ui::space::page, ui::space::page);
    row->setSpacing(ui::space::gap);
    row->addWidget(timelineCard(), 2);
    row->addWidget(m_comparison, 3);
    fillComparison();
    setContent(content);
    connect(m_timeline, &QTreeWidget::itemSelectionChanged, this, &BackupPage::updateButtons);
    connect(m_timeline, &QTreeWidget::itemSelectionChanged, m_comparison, &ComparisonCard::forget);
    connect(m_with, &QComboBox::currentIndexChanged, m_comparison, &ComparisonCard::forget);
    connect(m_backUp, &QPushButton::clicked, &m_backups, &station::Backups::backUp);
    connect(&m_backups, &station::Backups::progressed, this, &BackupPage::showProgress);
    connect(&m_backups, &station::Backups::backedUp, this, &BackupPage::onBackedUp);
    connect(m_verify, &QPushButton::clicked, this, &BackupPage::verifyChosen);
    connect(m_pin, &QPushButton::clicked, this, &BackupPage::togglePin);
    connect(m_export, &QPushButton::clicked, this, &BackupPage::exportChosen);
    connect(m_compare, &QPushButton::clicked, this, &BackupPage::compareChosen);
    connect(m_restore, &widgets::OrderButton::clicked, this, &BackupPage::planRestore);
    connect(this, &Page::visibilityChanged, this, [this] {
        if (isVisible())
            reload(); // others write backups too
    });
    m_keep->setValue(m_backups.choices().retention.count);
    m_keepDays->setValue(m_backups.choices().retention.days);
    say(tr("In %1").arg(QDir::toNativeSeparators(m_backups.archive().folder())));
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

void BackupPage::say(const QString &sentence) { m_state->setText(sentence); }

void BackupPage::setRoot(const QString &root)
{
    station::BackupChoices choices = m_backups.choices();
    choices.folder = root;
    m_backups.setChoices(choices);
    say(tr("In %1").arg(QDir::toNativeSeparators(m_backups.archive().folder())));
    reload();
}

void BackupPage::chooseFolder()
{
    widgets::askForPath(
        {"backupFolderDialog", widgets::PathKind::Folder, tr("Folder of the backups"), m_backups.choices().folder},
        this, [this](const QString &chosen) { setRoot(chosen); });
}

void BackupPage::keepChoices()
{
    m_backups.setChoices({m_backups.choices().folder, {m_keep->value(), m_keepDays->value()}});
}

void BackupPage::reload()
{
    m_disk.run(
        this, [archive = m_backups.archive()] { return archive.entries(); },
        [this](const QList<files::ArchiveEntry> &entries) {
            m_timeline->showEntries(entries);
            updateButtons();
        });
    updateButtons();
}

void BackupPage::updateButtons()
{
    const auto entry = m_timeline->chosen();
    m_backUp->setEnabled(m_isUp && !m_backups.isBusy());
    m_verify->setEnabled(entry && !m_isVerifying);
    m_export->setEnabled(entry && !m_isExporting);
    m_pin->setEnabled(entry.has_value());
    m_pin->setText(entry && entry->isPinned ? tr("Unpin") : tr("Pin"));
    m_compare->setEnabled(entry && entry->isReadable && !m_backups.isBusy());
    m_restore->setComplaint(!entry ? tr("Choose a backup first.")
            : m_backups.isBusy()   ? tr("Files are being read.")
                                   : QString());
}

/// Of whatever reads the controller's files now, whoever began it.
void BackupPage::showProgress()
{
    updateButtons();
    const auto *backup = m_backups.backup();
    const auto *snapshot = m_backups.snapshot();
    const auto isRunning = [](const files::Operation *one) {
        return one && one->state() == files::OperationState::Running;
    };
    if (isRunning(backup))
        say(backup->filesTotal() > 0
                ? tr("Reading file %1 of %2…").arg(backup->filesDone() + 1).arg(backup->filesTotal())
                : tr("Reading the lists…"));
    else if (isRunning(snapshot))
        say(tr("Reading file %1 of %2…").arg(snapshot->filesDone()).arg(snapshot->filesTotal()));
}

void BackupPage::onBackedUp()
{
    const int failures = m_backups.backup()->info().failures();
    const int all = int(m_backups.backup()->info().results.size());
    if (m_backups.backup()->error())
        say(tr("▲ There is no new backup: %1").arg(protocol::explain(*m_backups.backup()->error())));
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
    if (!entry || m_isExporting)
        return;
    say(tr("Exporting to %1…").arg(QDir::toNativeSeparators(target)));
    m_isExporting = true;
    m_long.run(
        this,
        [path = entry->path, target](
            const disk::IsWanted &isWanted) { return files::writeZip(path, target, isWanted); },
        [this](const values::Result<void> &written) {
            m_isExporting = false;
            say(written ? tr("Exported.") : tr("▲ Not exported: %1").arg(protocol::explain(written.error())));
            updateButtons();
        });
    updateButtons();
}

void BackupPage::verifyChosen()
{
    const auto entry = m_timeline->chosen();
    if (!entry)
        return;
    say(tr("Reading every byte…"));
    m_isVerifying = true;
    m_long.run(
        this, [path = entry->path] { return files::verify(path); },
        [this](const files::Verification &found) {
            m_isVerifying = false;
            say(found.isGood() ? tr("Good: every byte of %n file(s) is as it was written.", nullptr, found.files)
                               : tr("▲ Not good: %1").arg(explain(found.faults.first())));
            updateButtons();
        });
    updateButtons();
}

void BackupPage::togglePin()
{
    const auto entry = m_timeline->chosen();
    if (!entry)
        return;
    m_disk.run(
        this, [archive = m_backups.archive(), entry = *entry] { return archive.setPinned(entry.id, !entry.isPinned); },
        [this](const values::Result<void> &pinned) {
            if (!pinned)
                say(protocol::explain(pinned.error()));
            reload();
        });
}

void BackupPage::compareChosen()
{
    const auto entry = m_timeline->chosen();
    if (!entry)
        return;
    const QString name = nameOf(*entry);
    const int row = m_timeline->chosenRow();
    const bool isWithController = m_with->currentIndex() == Controller;
    const int other = m_with->currentIndex() == TheOneBefore ? row + 1 : 0;
    const auto &entries = m_timeline->entries();
    const bool hasOther = !isWithController && other < entries.size() && other != row;
    const QString second = hasOther ? entries[other].path : QString();
    const QString secondName = hasOther ? nameOf(entries[other]) : QString();
    const auto read = [first = entry->path, second] {
        return std::pair {contentsOf(first), second.isEmpty() ? none() : contentsOf(second)};
    };
    const auto show = [this, isWithController, isOlder = other > row, name, secondName](
                          const std::pair<Contents, Contents> &both) {
        const auto &[chosen, before] = both;
        if (!chosen)
            return say(protocol::explain(chosen.error()));
        if (!isWithController)
            return isOlder ? compare(before, chosen, secondName, name) : compare(chosen, before, name, secondName);
        readController([this, name, set = *chosen](const files::FileSet &now) {
            m_comparison->showSets(set, now, name, tr("the controller now"));
        });
    };
    m_disk.run(this, read, show);
}

void BackupPage::compare(
    const Contents &older, const Contents &newer, const QString &olderName, const QString &newerName)
{
    if (older && newer)
        m_comparison->showSets(*older, *newer, olderName, newerName);
    else
        m_comparison->showSentence(tr("There is no other backup to compare with."));
}

void BackupPage::readController(const std::function<void(const files::FileSet &)> &handler)
{
    m_backups.read(this, [this, handler](const values::Result<files::FileSet> &read) {
        updateButtons();
        if (!read)
            return say(protocol::explain(read.error()));
        say(tr("The controller's files were read."));
        handler(*read);
    });
}

void BackupPage::planRestore()
{
    const auto entry = m_timeline->chosen();
    if (!entry)
        return;
    using Read = values::Result<std::pair<files::Bag, files::FileSet>>;
    const auto read = [path = entry->path]() -> Read {
        return files::Bag::open(path).map([](const files::Bag &bag) { return std::pair {bag, bag.files()}; });
    };
    m_disk.run(this, read, [this](const Read &found) {
        if (!found)
            return say(protocol::explain(found.error()));
        offerRestore(found->first, found->second);
    });
}

void BackupPage::offerRestore(const files::Bag &bag, const files::FileSet &then)
{
    readController([this, bag, then](const files::FileSet &now) {
        const auto identity =
            files::compareIdentities(files::identityOf(bag.info(), then), files::identityOf(m_backups.info(), now));
        const bool isOther = files::isAnotherRobot(identity);
        const auto plan = files::planRestore(then, now, {{}, m_context.station.fileOrders.jobsInUse(), isOther});
        auto *dialog = new dialogs::RestoreDialog(m_context.station.profile(), bag.info().taken, plan, this);
        dialog->showIdentity(identity);
        connect(dialog, &dialogs::RestoreDialog::confirmed, this, [this, then, dialog](const auto &chosenPlan) {
            if (auto restore = m_backups.restore(then, chosenPlan))
                dialog->follow(std::move(restore));
        });
        connect(dialog, &dialogs::RestoreDialog::tried, this,
            [this](const files::Upload *upload) { m_context.station.fileOrders.note(*upload, Act::Upload); });
        connect(dialog, &QDialog::finished, this, &BackupPage::reload);
        dialog->show();
    });
}

} // namespace pages
