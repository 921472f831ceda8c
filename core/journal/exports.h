// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "journal/filter.h"
#include "journal/tablewriter.h"
#include "protocol/text.h"
#include "values/error.h"

namespace journal {
class Database;
}

/// The journal as files. They run in the store's worker; a file is replaced only when all of it was written. Each
/// answers how many rows it wrote.
namespace journal::exports {

[[nodiscard]] values::Result<qint64> orders(
    Database &database, const OrderFilter &filter, const QString &path, Format format);
[[nodiscard]] values::Result<qint64> alarms(Database &database, const AlarmFilter &filter,
    const protocol::TextCodec &codec, const QString &path, Format format);
[[nodiscard]] values::Result<qint64> notes(Database &database, const QString &path, Format format);

} // namespace journal::exports
