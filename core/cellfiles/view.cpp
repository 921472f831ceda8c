// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cellfiles/view.h"

#include "cellfiles/sentences.h"
#include <QJsonObject>

namespace cellfiles {

namespace {

QJsonValue cellValue(const Column &column, const QString &cell)
{
    bool isNumber = false;
    const double number = column.isNumber ? cell.toDouble(&isNumber) : 0;
    return isNumber ? QJsonValue {number} : QJsonValue {cell};
}

QJsonObject rowValue(const Table &table, const Row &row)
{
    const QStringList cells = shownCells(table, row);
    QJsonObject json;
    for (qsizetype column = 0; column < table.columns.size() && column < cells.size(); ++column)
        json[QLatin1StringView(table.columns[column].title)] = cellValue(table.columns[column], cells[column]);
    return json;
}

} // namespace

QString title(const char *source) { return Sentences::tr(source); }

QString mask() { return QStringLiteral("•••"); }

QStringList shownCells(const Table &table, const Row &row)
{
    QStringList cells = row.cells;
    for (qsizetype column = table.keys; row.isSecret && column < cells.size(); ++column) {
        if (!table.columns[column].isPublic && !cells[column].isEmpty())
            cells[column] = mask();
    }
    return cells;
}

QJsonObject toJson(const View &view)
{
    QJsonObject tables;
    for (const Table &table : view.tables) {
        QJsonArray rows;
        for (const Row &row : table.rows)
            rows << rowValue(table, row);
        tables[QLatin1StringView(table.title)] = rows;
    }
    QJsonArray warnings;
    for (const Warning &warning : view.warnings.list())
        warnings << QJsonObject {{QStringLiteral("line"), warning.line}, {QStringLiteral("reason"), warning.reason}};
    return {{QStringLiteral("tables"), tables}, {QStringLiteral("warnings"), warnings}};
}

} // namespace cellfiles
