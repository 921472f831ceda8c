// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "journal/tablewriter.h"

#include <QDateTime>
#include <QIODevice>
#include <QJsonDocument>
#include <QJsonObject>

namespace journal {

namespace {

QVariant plain(const QVariant &value)
{
    if (value.typeId() != QMetaType::QDateTime)
        return value;
    const QDateTime time = value.toDateTime().toUTC();
    return time.isValid() ? time.toString(Qt::ISODateWithMs) : QString();
}

QString quoted(QString cell)
{
    const bool needsQuotes = cell.contains(u',') || cell.contains(u'"') || cell.contains(u'\n') || cell.contains(u'\r');
    return needsQuotes ? u'"' + cell.replace(u'"', QStringLiteral("\"\"")) + u'"' : cell;
}

} // namespace

TableWriter::TableWriter(QIODevice &device, Format format, QStringList columns)
    : m_device {device}, m_format {format}, m_columns {std::move(columns)}
{
    if (m_format == Format::Csv)
        csvLine(m_columns);
    else
        m_device.write("[");
}

void TableWriter::row(const QVariantList &values)
{
    if (m_format == Format::Csv) {
        QStringList cells;
        for (const QVariant &value : values)
            cells += plain(value).toString();
        return csvLine(cells);
    }
    QJsonObject object;
    for (qsizetype i = 0; i < values.size(); ++i)
        object[m_columns[i]] = QJsonValue::fromVariant(plain(values[i]));
    m_device.write(m_hasRows ? ",\n" : "\n");
    m_device.write(QJsonDocument {object}.toJson(QJsonDocument::Compact));
    m_hasRows = true;
}

void TableWriter::end()
{
    if (m_format == Format::Json)
        m_device.write("\n]\n");
}

void TableWriter::csvLine(const QStringList &cells)
{
    QStringList line;
    for (const QString &cell : cells)
        line += quoted(cell);
    m_device.write(line.join(u',').toUtf8() + "\r\n");
}

} // namespace journal
