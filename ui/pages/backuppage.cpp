// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/backuppage.h"

#include "protocol/codes.h"
#include "ui/dialogs/restoredialog.h"
#include "ui/widgets/card.h"
#include "ui/widgets/diffview.h"
#include "ui/widgets/orderbutton.h"
#include "ui/widgets/rowdelegate.h"
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QStandardPaths>
#include <QTreeWidget>
#include <QtConcurrent>

using files::ArchiveEntry;
using files::Change;
using robot::Act;
using values::FileName;

namespace pages {

namespace {

constexpr int idRole = Qt::UserRole;
enum Column { Taken, Files, Changed, State };

QPushButton *button(const QString &text, const char *name)
{
    auto *result = new QPushButton(text);
    result->setObjectName(QLatin1String(name));
    result->setAutoDefault(false);
    return result;
}

QTreeWidget *table(const QStringList &titles, const char *name, const QString &accessibleName)
{
    auto *result = new QTreeWidget;
    result->setObjectName(QLatin1String(name));
    result->setAccessibleName(accessibleName);
    result->setHeaderLabels(titles);
    result->setRootIsDecorated(false);
    result->setUniformRowHeights(true);
    result->header()->setFont(ui::font(ui::Type::Label));
    widgets::RowDelegate::dress(result);
    return result;
}

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

/// How many files differ from the backup before, by id. Reads bags; runs in another thread.
QHash<QString, int> changesOf(const QList<ArchiveEntry> &newestFirst)
{
    QHash<QString, int> result;
    for (int index = 0; index + 1 < newestFirst.size(); ++index) {
        const auto newer = files::Bag::open(newestFirst[index].path);
        const auto older = files::Bag::open(newestFirst[index + 1].path);
        if (newer && older)
            result[newestFirst[index].id] = differences(compare(older->files(), newer->files(), {}));
    }
    return result;
}

values::Result<files::Bag> noBag() { return values::failure(values::ErrorKind::LocalFile); }

} // namespace

BackupPage::BackupPage(const Context &context, QWidget *parent)
    : Page(context, parent),
      m_context {context},
      m_orders {context.orders},
      m_timeline {table({tr("Taken"), tr("Files"), tr("Changed"), tr("State")}, "timeline", tr("Backups"))},
      m_state {widgets::sentence({}, ui::Role::Text2)},
      m_keep {spin(tr(" newest"), "keepCount", tr("Keep any number"))},
      m_keepDays {spin(tr(" days"), "keepDays", tr("Keep any age"))},
      m_backUp {button(tr("Back up now"), "backUp")},
      m_verify {button(tr("Verify"), "verifyBackup")},
      m_pin {button(tr("Pin"), "pinBackup")},
      m_with {new QComboBox},
      m_compare {button(tr("Compare"), "compareBackups")},
      m_restore {new widgets::OrderButton(context.orders, Act::Restore)},
      m_files {table({tr("File"), tr("Change")}, "changedFiles", tr("Files that differ"))},
      m_diff {new widgets::DiffView(protocol::TextCodec {context.profile.encoding})}
{
    auto *content = new QWidget;
    auto *row = new QHBoxLayout(content);
    row->setContentsMargins(ui::space::page, ui::space::page, ui::space::page, ui::space::page);
    row->setSpacing(ui::space::gap);
    row->addWidget(timelineCard(), 2);
    row->addWidget(comparisonCard(), 3);
    setContent(content);
    connect(m_timeline, &QTreeWidget::itemSelectionChanged, this, &BackupPage::updateButtons);
    connect(m_backUp, &QPushButton::clicked, this, &BackupPage::backUp);
    connect(m_verify, &QPushButton::clicked, this, &BackupPage::verifyChosen);
    connect(m_pin, &QPushButton::clicked, this, &BackupPage::togglePin);
    connect(m_compare, &QPushButton::clicked, this, &BackupPage::compareChosen);
    connect(m_restore, &widgets::OrderButton::clicked, this, &BackupPage::planRestore);
    connect(m_files, &QTreeWidget::currentItemChanged, this, &BackupPage::showFile);
    connect(&m_counting, &QFutureWatcherBase::finished, this, [this] {
        m_changes = m_counting.result();
        showEntries(m_entries);
    });
    connect(&m_verifying, &QFutureWatcherBase::finished, this, [this] {
        const files::Verification found = m_verifying.result();
        say(found.isGood() ? tr("Good: every byte of %n file(s) is as it was written.", nullptr, found.files)
                           : tr("▲ Not good: %1").arg(explain(found.faults.first())));
        updateButtons();
    });
    setRoot(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + QStringLiteral("/Pendesk backups"));
}

QWidget *BackupPage::timelineCard()
{
    auto *card = new widgets::Card(tr("Backups"));
    m_timeline->setColumnWidth(Taken, 150);
    m_timeline->setColumnWidth(Files, 60);
    m_timeline->setColumnWidth(Changed, 75);
    m_state->setObjectName(QStringLiteral("backupState"));
    auto *buttons = new QHBoxLayout;
    for (QPushButton *each : {m_backUp, m_verify, m_pin})
        buttons->addWidget(each);
    buttons->addStretch();
    auto *keeping = new QHBoxLayout;
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

QWidget *BackupPage::comparisonCard()
{
    m_comparison = new widgets::Card(tr("Comparison"));
    m_with->setObjectName(QStringLiteral("compareWith"));
    m_with->setAccessibleName(tr("Compare with"));
    m_with->addItems({tr("with the backup before"), tr("with the newest backup"), tr("with the controller now")});
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(m_compare);
    buttons->addWidget(m_with);
    buttons->addStretch();
    m_restore->setText(tr("Restore…"));
    auto *rules = new QGridLayout;
    rules->addWidget(widgets::text(tr("Not counted as a difference:"), ui::Type::Label, ui::Role::Text2), 0, 0, 1, 2);
    for (const files::NoiseRule &rule : files::noiseRules()) {
        auto *box = new QCheckBox(title(rule));
        box->setObjectName(QLatin1String("noise-") + QLatin1String(rule.key));
        box->setChecked(true);
        connect(box, &QCheckBox::toggled, this, [this] { showComparison(m_older, m_newer); });
        rules->addWidget(box, 1 + int(m_noise.size()) / 2, int(m_noise.size()) % 2);
        m_noise << box;
    }
    m_files->setColumnWidth(0, 260);
    m_comparison->body()->addLayout(buttons);
    m_comparison->body()->addLayout(rules);
    m_comparison->body()->addWidget(m_files, 2);
    m_comparison->body()->addWidget(m_diff, 3);
    m_comparison->body()->addWidget(m_restore);
    m_diff->showSentence(tr("Choose a backup and compare it."));
    return m_comparison;
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

files::Archive BackupPage::archive() const { return {m_root, m_context.profile.name}; }

QString BackupPage::text(const FileName &name) const
{
    return protocol::TextCodec {m_context.profile.encoding}.decode(name.bytes());
}

void BackupPage::say(const QString &sentence) { m_state->setText(sentence); }

void BackupPage::setRoot(const QString &root)
{
    m_root = root;
    say(tr("In %1").arg(QDir::toNativeSeparators(archive().folder())));
    reload();
}

void BackupPage::reload()
{
    showEntries(archive().entries());
    m_counting.setFuture(QtConcurrent::run(changesOf, m_entries));
}

/// Rows are changed in place, so that the chosen one stays.
void BackupPage::showEntries(const QList<ArchiveEntry> &entries)
{
    QSet<QString> ids;
    for (const ArchiveEntry &entry : entries)
        ids << entry.id;
    for (int row = m_timeline->topLevelItemCount() - 1; row >= 0; --row) {
        if (!ids.contains(m_timeline->topLevelItem(row)->data(0, idRole).toString()))
            delete m_timeline->takeTopLevelItem(row);
    }
    m_entries = entries;
    for (int row = 0; row < entries.size(); ++row) {
        const ArchiveEntry &entry = entries[row];
        QTreeWidgetItem *item = m_timeline->topLevelItem(row);
        if (!item || item->data(0, idRole).toString() != entry.id) {
            item = new QTreeWidgetItem;
            item->setData(0, idRole, entry.id);
            m_timeline->insertTopLevelItem(row, item);
        }
        item->setText(Taken, QLocale().toString(entry.taken.toLocalTime(), QLocale::ShortFormat));
        item->setText(Files, entry.isReadable ? QString::number(entry.files) : QStringLiteral("—"));
        item->setText(
            Changed, m_changes.contains(entry.id) ? QString::number(m_changes[entry.id]) : QStringLiteral("—"));
        const QString state = !entry.isReadable ? tr("▲ no backup any more")
            : entry.failures > 0                ? tr("▲ %n file(s) missing", nullptr, entry.failures)
                                                : tr("complete");
        item->setText(State, entry.isPinned ? tr("%1, pinned").arg(state) : state);
    }
    updateButtons();
}

std::optional<ArchiveEntry> BackupPage::chosen() const
{
    const auto items = m_timeline->selectedItems();
    const int row = items.isEmpty() ? -1 : m_timeline->indexOfTopLevelItem(items.first());
    return row < 0 ? std::nullopt : std::optional {m_entries[row]};
}

void BackupPage::updateButtons()
{
    const auto entry = chosen();
    const bool isBusy = (m_backup && !m_backup->isOver()) || (m_snapshot && !m_snapshot->isOver());
    m_backUp->setEnabled(m_isUp && !isBusy);
    m_verify->setEnabled(entry && !m_verifying.isRunning());
    m_pin->setEnabled(entry.has_value());
    m_pin->setText(entry && entry->isPinned ? tr("Unpin") : tr("Pin"));
    m_compare->setEnabled(entry && entry->isReadable && !isBusy);
    m_restore->setComplaint(!entry ? tr("Choose a backup first.") : isBusy ? tr("Files are being read.") : QString());
}

files::Retention BackupPage::retention() const { return {m_keep->value(), m_keepDays->value()}; }

files::BackupOrder BackupPage::order() const
{
    files::BackupOrder order;
    order.root = m_root;
    order.info.controller = m_context.profile.name;
    order.info.host = m_context.profile.host;
    if (const auto &system = m_context.state.systemInformation().value) {
        order.info.model = QString::fromLatin1(system->model.bytes());
        order.info.software = QString::fromLatin1(system->software.bytes());
        order.info.parameterVersion = QString::fromLatin1(system->parameters.bytes());
    }
    return order;
}

void BackupPage::backUp()
{
    session::FileSession *session = m_context.controller.files();
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

void BackupPage::verifyChosen()
{
    const auto entry = chosen();
    if (!entry)
        return;
    say(tr("Reading every byte…"));
    m_verifying.setFuture(QtConcurrent::run(files::verify, entry->path));
    updateButtons();
}

void BackupPage::togglePin()
{
    const auto entry = chosen();
    if (!entry)
        return;
    if (const auto pinned = archive().setPinned(entry->id, !entry->isPinned); !pinned)
        say(protocol::explain(pinned.error()));
    reload();
}

files::NoiseFilter BackupPage::noise() const
{
    QSet<QString> keys;
    for (const QCheckBox *box : m_noise) {
        if (box->isChecked())
            keys << box->objectName().sliced(6);
    }
    return files::NoiseFilter {keys};
}

void BackupPage::compareChosen()
{
    const auto entry = chosen();
    const auto bag = entry ? files::Bag::open(entry->path) : noBag();
    if (!bag)
        return;
    if (m_with->currentIndex() == 2)
        return readController([this, set = bag->files()](const files::FileSet &now) { showComparison(set, now); });
    const int row = m_timeline->indexOfTopLevelItem(m_timeline->selectedItems().first());
    const int other = m_with->currentIndex() == 0 ? row + 1 : 0;
    const auto second = other < m_entries.size() ? files::Bag::open(m_entries[other].path) : bag;
    if (!second || other >= m_entries.size() || other == row)
        return m_diff->showSentence(tr("There is no other backup to compare with."));
    if (other > row)
        showComparison(second->files(), bag->files());
    else
        showComparison(bag->files(), second->files());
}

void BackupPage::readController(const std::function<void(const files::FileSet &)> &handler)
{
    session::FileSession *session = m_context.controller.files();
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

void BackupPage::showComparison(const files::FileSet &older, const files::FileSet &newer)
{
    m_older = older;
    m_newer = newer;
    m_files->clear();
    if (!older.content || !newer.content)
        return;
    const auto changes = compare(older, newer, noise());
    const QHash<Change, QString> words {{Change::Changed, tr("≠ changed")}, {Change::New, tr("+ new")},
        {Change::Gone, tr("− gone")}, {Change::Unread, tr("▲ not read, nobody knows")}};
    for (const files::FileChange &change : changes) {
        if (!words.contains(change.change))
            continue;
        auto *item = new QTreeWidgetItem({text(change.name), words[change.change]});
        item->setData(0, idRole, change.name.bytes());
        m_files->addTopLevelItem(item);
    }
    const int found = m_files->topLevelItemCount();
    m_comparison->setNote(tr("%n file(s) differ", nullptr, found));
    m_diff->showSentence(found > 0 ? tr("Choose a file above.") : tr("Nothing differs."));
    if (found > 0)
        m_files->setCurrentItem(m_files->topLevelItem(0));
}

void BackupPage::showFile()
{
    const auto *item = m_files->currentItem();
    const auto name = item ? FileName::create(item->data(0, idRole).toByteArray())
                           : values::Result<FileName>(values::failure(values::ErrorKind::BadInput));
    if (!name)
        return;
    const bool isInBoth = m_older.hashes.contains(*name) && m_newer.hashes.contains(*name);
    const auto older = m_older.content(*name);
    const auto newer = m_newer.content(*name);
    if (isInBoth && (!older || !newer))
        return m_diff->showSentence(tr("This file is not in the backup as it was written."));
    m_diff->showFiles(older.value_or(QByteArray()), newer.value_or(QByteArray()), noise());
}

void BackupPage::planRestore()
{
    const auto entry = chosen();
    const auto bag = entry ? files::Bag::open(entry->path) : noBag();
    if (!bag)
        return;
    readController([this, bag = *bag](const files::FileSet &now) {
        session::FileSession *session = m_context.controller.files();
        if (!session)
            return;
        const auto plan = files::planRestore(bag.files(), now, {}, m_orders.jobsInUse());
        auto *dialog = new dialogs::RestoreDialog(m_context.profile, bag.info().taken, plan, this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        connect(dialog, &dialogs::RestoreDialog::confirmed, this, [this, bag, dialog](const auto &chosenPlan) {
            if (session::FileSession *files = m_context.controller.files())
                dialog->follow(std::make_unique<files::Restore>(
                    *files, bag.files(), chosenPlan, order(), m_orders.guard(Act::Restore)));
        });
        connect(dialog, &dialogs::RestoreDialog::tried, this,
            [this](const files::Upload *upload) { m_orders.note(*upload, Act::Upload); });
        connect(dialog, &QDialog::finished, this, &BackupPage::reload);
        dialog->open();
    });
}

} // namespace pages
