// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cell/comparison.h"

#include "cell/comparisons.h"
#include "cellfiles/filetypes.h"
#include "inform/linediff.h"
#include <algorithm>

using cellfiles::FileClass;
using cellfiles::FileType;

namespace cell {

namespace {

Statements comparePanelBoxes(const Context &context);

struct Comparer {
    QByteArrayView pattern; ///< As in cellfiles::fileTypes().
    Statements (*compare)(const Context &);
};
constexpr std::array comparers {
    Comparer {"TOOL.CND", compareTools},
    Comparer {"UFRAME.CND", compareUserFrames},
    Comparer {"CUBEINTF.CND", compareCubes},
    Comparer {"SHOCKLVL.CND", compareShock},
    Comparer {"VAR.DAT", compareVariables},
    Comparer {"VARNAME.DAT", compareVariableNames},
    Comparer {"IONAME.DAT", compareSignalNames},
    Comparer {"EXIONAME.DAT", compareSignalNames},
    Comparer {"*.PRM", compareParameters},
    Comparer {"CIOPRG.LST", compareLadders},
    Comparer {"ABSO.DAT", compareEncoderOffsets},
    Comparer {"HOME2.DAT", compareHomePositions},
    Comparer {"OPEORG.DAT", compareHomePositions},
    Comparer {"PSEUDOIN.DAT", comparePseudoInputs},
    Comparer {"SYSTEM.SYS", compareSystems},
    Comparer {"PANELBOX.LOG", comparePanelBoxes},
    Comparer {"LOGDATA.DAT", compareLogs},
    Comparer {"ALMHIST.DAT", compareAlarms},
};

/// A row by its key; the same key again gets a number, so that none is lost.
using KeyedRows = QMap<QString, const cellfiles::Row *>;

KeyedRows keyed(const cellfiles::Table &table)
{
    KeyedRows rows;
    QHash<QString, int> seen;
    for (const cellfiles::Row &row : table.rows) {
        QString key = row.cells.mid(0, table.keys).join(u' ');
        if (const int count = ++seen[key]; count > 1)
            key += QStringLiteral(" (%1)").arg(count);
        rows.insert(key, &row);
    }
    return rows;
}

QStringList cellChanges(const cellfiles::Table &table, const cellfiles::Row &older, const cellfiles::Row &newer)
{
    QStringList parts;
    for (qsizetype column = table.keys; column < std::max(older.cells.size(), newer.cells.size()); ++column) {
        const QString before = older.cells.value(column);
        const QString after = newer.cells.value(column);
        if (before == after)
            continue;
        const QString name = column < table.columns.size() ? cellfiles::title(table.columns[column].title) : QString {};
        parts << (older.isSecret || newer.isSecret ? Sentences::tr("%1 changed").arg(name)
                                                   : QStringLiteral("%1 %2").arg(name, change(before, after)));
    }
    return parts;
}

void compareRows(const cellfiles::Table &older, const cellfiles::Table &newer, bool isSafety, Statements &statements)
{
    const KeyedRows before = keyed(older);
    const KeyedRows after = keyed(newer);
    for (auto row = after.begin(); row != after.end(); ++row) {
        const auto known = before.find(row.key());
        const QStringList parts =
            known == before.end() ? QStringList {Sentences::tr("new")} : cellChanges(newer, **known, **row);
        if (!parts.isEmpty())
            statements << Statement {
                QStringLiteral("%1: %2.").arg(row.key(), parts.join(QStringLiteral("; "))), isSafety};
    }
    for (auto row = before.begin(); row != before.end(); ++row) {
        if (!after.contains(row.key()))
            statements << Statement {Sentences::tr("%1: gone.").arg(row.key()), isSafety};
    }
}

/// Its head is that of SYSTEM.SYS with the same date and hours; options and settings follow.
Statements comparePanelBoxes(const Context &context)
{
    constexpr qsizetype headTables = 3;
    const auto older = cellfiles::viewOf("PANELBOX.LOG", context.versions.older, context.codec).tables;
    const auto newer = cellfiles::viewOf("PANELBOX.LOG", context.versions.newer, context.codec).tables;
    Statements statements = compareSystems(context);
    for (qsizetype table = headTables; table < std::min(older.size(), newer.size()); ++table)
        compareRows(older[table], newer[table], false, statements);
    return statements;
}

/// Without what an editor or the controller changes without meaning it: line ends and blanks before them.
QByteArrayList plainLines(const QByteArray &file)
{
    QByteArrayList lines;
    for (const QByteArray &line : file.split('\n'))
        lines << line.trimmed();
    while (!lines.isEmpty() && lines.last().isEmpty())
        lines.removeLast();
    return lines;
}

/// Where the words found nothing although the bytes differ: is there anything but blanks and line ends?
Statements compareLines(const Context &context, bool isSafety)
{
    int changed = 0;
    const auto hunks = inform::diffLines(plainLines(context.versions.older), plainLines(context.versions.newer));
    for (const inform::Hunk &hunk : hunks)
        changed += std::max(hunk.oldCount, hunk.newCount);
    if (changed == 0)
        return {};
    return {Statement {
        Sentences::tr("%n line(s) differ, from line %1 on.", nullptr, changed).arg(hunks.first().newFrom + 1),
        isSafety}};
}

std::optional<Statement> damage(const Context &context)
{
    if (context.versions.newer.isEmpty() && !context.versions.older.isEmpty())
        return Statement {Sentences::tr("The newer file is empty; what stood in it is not known to be deleted.")};
    if (context.versions.older.isEmpty() && !context.versions.newer.isEmpty())
        return Statement {Sentences::tr("The older file is empty.")};
    return std::nullopt;
}

/// Lines that differ in these are what the controller writes anew at every save, or are read in words wholly.
bool isReadWholly(const FileType &type)
{
    const QByteArrayView pattern = type.pattern;
    return pattern == "*.PRM" || pattern == "SYSTEM.SYS" || pattern == "PANELBOX.LOG"
        || type.fileClass == FileClass::Log;
}

Statements inWords(const QByteArray &name, const FileType &type, const Context &context)
{
    const auto comparer = std::ranges::find(comparers, QByteArrayView {type.pattern}, &Comparer::pattern);
    Statements statements = comparer != comparers.end() ? comparer->compare(context) : compareTables(name, context);
    if (statements.isEmpty() && !isReadWholly(type))
        statements = compareLines(context, type.isSafety);
    return statements;
}

void cut(Statements &statements)
{
    std::ranges::stable_sort(statements, std::ranges::greater {}, &Statement::isSafety);
    if (statements.size() <= mostStatements)
        return;
    const int more = int(statements.size()) - mostStatements + 1;
    statements.resize(mostStatements - 1);
    statements << Statement {Sentences::tr("And %n more difference(s).", nullptr, more)};
}

} // namespace

Statements compareTables(const QByteArray &name, const Context &context)
{
    const bool isSafety = cellfiles::fileTypeOf(name).isSafety;
    const auto older = cellfiles::viewOf(name, context.versions.older, context.codec);
    const auto newer = cellfiles::viewOf(name, context.versions.newer, context.codec);
    Statements statements;
    for (qsizetype table = 0; table < std::min(older.tables.size(), newer.tables.size()); ++table)
        compareRows(older.tables[table], newer.tables[table], isSafety, statements);
    return statements;
}

Statements statementsOf(
    const QByteArray &name, const Versions &versions, const Knowledge &knowledge, const protocol::TextCodec &codec)
{
    if (versions.older == versions.newer)
        return {};
    const Context context {versions, knowledge, codec};
    if (const auto damaged = damage(context))
        return {*damaged};
    if (!cellfiles::isText(versions.older) || !cellfiles::isText(versions.newer))
        return {Statement {
            Sentences::tr("%1 bytes; the content differs.")
                .arg(change(QString::number(versions.older.size()), QString::number(versions.newer.size())))}};
    const FileType &type = cellfiles::fileTypeOf(name);
    Statements statements = inWords(name, type, context);
    const bool isNoise = type.fileClass == FileClass::Counter || type.fileClass == FileClass::Log;
    for (Statement &statement : statements)
        statement.isNoise = statement.isNoise || isNoise;
    cut(statements);
    return statements;
}

bool hasWords(const QByteArray &name)
{
    const QByteArrayView pattern = cellfiles::fileTypeOf(name).pattern;
    return std::ranges::find(comparers, pattern, &Comparer::pattern) != comparers.end();
}

bool isDifference(const Statements &statements)
{
    return std::ranges::any_of(statements, [](const Statement &statement) { return !statement.isNoise; });
}

} // namespace cell
