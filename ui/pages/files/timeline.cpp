// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/files/timeline.h"

#include "files/compare.h"
#include "ui/pages/files/parts.h"

using files::ArchiveEntry;

namespace pages {

namespace {

constexpr int idRole = Qt::UserRole;
enum Column { Taken, Files, Changed, Condition };

/// How many files differ from the backup before, by id. Reads bags; runs in another thread.
QHash<QString, int> changesOf(const QList<ArchiveEntry> &newestFirst, const disk::IsWanted &isWanted)
{
    QHash<QString, int> result;
    for (int index = 0; index + 1 < newestFirst.size() && isWanted(); ++index) {
        const auto newer = files::Bag::open(newestFirst[index].path);
        const auto older = files::Bag::open(newestFirst[index + 1].path);
        if (newer && older)
            result[newestFirst[index].id] = differences(compare(older->files(), newer->files(), {}));
    }
    return result;
}

QString stateWord(const ArchiveEntry &entry)
{
    const QString state = !entry.isReadable ? Timeline::tr("▲ no backup any more")
        : entry.failures > 0                ? Timeline::tr("▲ %n file(s) missing", nullptr, entry.failures)
                                            : Timeline::tr("complete");
    return entry.isPinned ? Timeline::tr("%1, pinned").arg(state) : state;
}

} // namespace

Timeline::Timeline(QWidget *parent) : QTreeWidget(parent)
{
    dressTable(
        this, {tr("Taken"), tr("Files"), tr("Changed", "number of files"), tr("State")}, "timeline", tr("Backups"));
    setColumnWidth(Taken, 150);
    setColumnWidth(Files, 60);
    setColumnWidth(Changed, 75);
}

void Timeline::showEntries(const QList<ArchiveEntry> &entries)
{
    QSet<QString> ids;
    for (const ArchiveEntry &entry : entries)
        ids << entry.id;
    for (int row = topLevelItemCount() - 1; row >= 0; --row) {
        if (!ids.contains(topLevelItem(row)->data(0, idRole).toString()))
            delete takeTopLevelItem(row);
    }
    m_entries = entries;
    showRows();
    m_count = std::make_unique<QObject>(); // an earlier count is of no use
    m_counting.run(
        m_count.get(), [entries](const disk::IsWanted &isWanted) { return changesOf(entries, isWanted); },
        [this](const QHash<QString, int> &changes) {
            m_changes = changes;
            showRows();
        });
}

void Timeline::showRows()
{
    for (int row = 0; row < m_entries.size(); ++row) {
        const ArchiveEntry &entry = m_entries[row];
        QTreeWidgetItem *item = topLevelItem(row);
        if (!item || item->data(0, idRole).toString() != entry.id) {
            item = new QTreeWidgetItem;
            item->setData(0, idRole, entry.id);
            insertTopLevelItem(row, item);
        }
        item->setText(Taken, QLocale().toString(entry.taken.toLocalTime(), QLocale::ShortFormat));
        item->setText(Files, entry.isReadable ? QString::number(entry.files) : QStringLiteral("—"));
        const auto changes = m_changes.find(entry.id);
        item->setText(Changed, changes == m_changes.end() ? QStringLiteral("—") : QString::number(*changes));
        item->setText(Condition, stateWord(entry));
    }
}

int Timeline::chosenRow() const
{
    const auto items = selectedItems();
    return items.isEmpty() ? -1 : indexOfTopLevelItem(items.first());
}

std::optional<ArchiveEntry> Timeline::chosen() const
{
    const int row = chosenRow();
    return row < 0 ? std::nullopt : std::optional {m_entries[row]};
}

} // namespace pages
