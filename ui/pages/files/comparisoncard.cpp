// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/files/comparisoncard.h"

#include "ui/pages/files/parts.h"
#include "ui/widgets/diffview.h"
#include "ui/widgets/flow.h"
#include "ui/widgets/tickbox.h"
#include <QTreeWidget>
#include <QtConcurrent>

using files::Change;
using values::FileName;

namespace pages {

namespace {

constexpr int nameRole = Qt::UserRole;

QString changeWord(Change change)
{
    switch (change) {
    case Change::Changed: return ComparisonCard::tr("≠ changed");
    case Change::New: return ComparisonCard::tr("+ new");
    case Change::Gone: return ComparisonCard::tr("− gone");
    case Change::Unread: return ComparisonCard::tr("▲ not read, nobody knows");
    case Change::OnlyNoise: return ComparisonCard::tr("not counted");
    case Change::Same: break;
    }
    return {};
}

} // namespace

ComparisonCard::ComparisonCard(const protocol::TextCodec &codec, QWidget *parent)
    : Card(tr("Comparison"), parent),
      m_codec {codec},
      m_tools {new widgets::Flow},
      m_files {new QTreeWidget},
      m_diff {new widgets::DiffView(codec)}
{
    dressTable(m_files, {tr("File"), tr("Change")}, "changedFiles", tr("Files that differ"));
    m_files->setColumnWidth(0, 260);
    body()->addLayout(m_tools);
    body()->addLayout(noiseRules());
    body()->addWidget(m_files, 2);
    body()->addWidget(m_diff, 3);
    forget();
    m_files->setRootIsDecorated(true);
    m_files->setWordWrap(true);
    connect(&m_comparing, &QFutureWatcherBase::finished, this, [this] { showDifferences(m_comparing.result()); });
    connect(m_files, &QTreeWidget::currentItemChanged, this, &ComparisonCard::showFile);
}

QLayout *ComparisonCard::noiseRules()
{
    auto *grid = new QGridLayout;
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);
    grid->addWidget(widgets::text(tr("Not counted as a difference:"), ui::Type::Label, ui::Role::Text2), 0, 0, 1, 2);
    for (const files::NoiseRule &rule : files::noiseRules()) {
        auto *box = new widgets::TickBox(title(rule));
        box->setObjectName(QLatin1String("noise-") + QLatin1String(rule.key));
        box->setProperty("rule", QLatin1String(rule.key));
        box->setChecked(true);
        connect(box, &QCheckBox::toggled, this, [this] { compareSets(); });
        grid->addWidget(box, 1 + int(m_noise.size()) / 2, int(m_noise.size()) % 2);
        m_noise << box;
    }
    return grid;
}

files::NoiseFilter ComparisonCard::noise() const
{
    QSet<QString> keys;
    for (const QCheckBox *box : m_noise) {
        if (box->isChecked())
            keys << box->property("rule").toString();
    }
    return files::NoiseFilter {keys};
}

void ComparisonCard::showSentence(const QString &sentence) { m_diff->showSentence(sentence); }

void ComparisonCard::forget()
{
    m_older = {};
    m_newer = {};
    m_files->clear();
    setTitle(tr("Comparison"));
    setNote({});
    m_diff->showSentence(tr("Choose a backup and compare it."));
}

void ComparisonCard::showSets(
    const files::FileSet &older, const files::FileSet &newer, const QString &olderName, const QString &newerName)
{
    m_older = older;
    m_newer = newer;
    setTitle(tr("Comparison: from %1 to %2").arg(olderName, newerName));
    compareSets();
}

void ComparisonCard::compareSets()
{
    m_files->clear();
    if (!m_older.content || !m_newer.content)
        return;
    m_diff->showSentence(tr("The files are being compared…"));
    m_comparing.setFuture(QtConcurrent::run([older = m_older, newer = m_newer, noise = noise(), codec = m_codec] {
        return station::differencesOf(older, newer, noise, codec);
    }));
}

QTreeWidgetItem *ComparisonCard::rowOf(const station::FileDifference &difference) const
{
    auto *row = new QTreeWidgetItem({m_codec.decode(difference.name.bytes()), changeWord(difference.change)});
    row->setData(0, nameRole, difference.name.bytes());
    for (const cell::Statement &statement : difference.statements) {
        auto *line = new QTreeWidgetItem({(statement.isSafety ? QStringLiteral("▲ ") : QString()) + statement.text});
        line->setData(0, nameRole, difference.name.bytes());
        line->setToolTip(0, statement.text);
        line->setFirstColumnSpanned(true);
        row->addChild(line);
    }
    return row;
}

void ComparisonCard::showDifferences(const QList<station::FileDifference> &differences)
{
    if (!m_older.content)
        return; // another backup was chosen meanwhile
    m_files->clear();
    QList<QTreeWidgetItem *> folded;
    for (const station::FileDifference &difference : differences) {
        QTreeWidgetItem *row = rowOf(difference);
        if (!difference.counts()) {
            folded << row;
            continue;
        }
        m_files->addTopLevelItem(row);
        row->setExpanded(true);
    }
    const int found = m_files->topLevelItemCount();
    if (!folded.isEmpty()) {
        const int count = int(folded.size());
        auto *rest = new QTreeWidgetItem({tr("Not counted: %n counter(s), log(s) and the like", nullptr, count)});
        rest->setFirstColumnSpanned(true);
        rest->addChildren(folded);
        m_files->addTopLevelItem(rest);
    }
    setNote(tr("%n file(s) differ", nullptr, found));
    m_diff->showSentence(found > 0 ? tr("Choose a file above.") : tr("Nothing differs."));
    if (found > 0)
        m_files->setCurrentItem(m_files->topLevelItem(0));
}

void ComparisonCard::showFile()
{
    const auto *item = m_files->currentItem();
    const auto name = FileName::create(item ? item->data(0, nameRole).toByteArray() : QByteArray());
    if (!name)
        return;
    const bool isInBoth = m_older.hashes.contains(*name) && m_newer.hashes.contains(*name);
    const auto older = m_older.content(*name);
    const auto newer = m_newer.content(*name);
    if (isInBoth && (!older || !newer))
        return m_diff->showSentence(tr("This file is not in the backup as it was written."));
    m_diff->showFiles(older.value_or(QByteArray()), newer.value_or(QByteArray()), noise());
}

} // namespace pages
