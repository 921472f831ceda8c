// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QStringList>
#include <QVariant>

class QIODevice;

namespace journal {

enum class Format { Csv, Json };

/// Writes rows as they come: CSV after RFC 4180 (UTF-8, one head line, CRLF) or a JSON array of objects. Numbers in the
/// C locale, times in UTC with milliseconds.
class TableWriter
{
public:
    /// `device` is open, and outlives the writer. `columns`: names of the head line, keys of the objects.
    TableWriter(QIODevice &device, Format format, QStringList columns);

    /// One value a column: text, whole number or QDateTime.
    void row(const QVariantList &values);
    void end();

private:
    void csvLine(const QStringList &cells);

    QIODevice &m_device;
    Format m_format;
    QStringList m_columns;
    bool m_hasRows = false;
};

} // namespace journal
