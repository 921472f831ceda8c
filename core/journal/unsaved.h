// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "journal/record.h"
#include "values/error.h"
#include <QUrl>
#include <variant>
#include <vector>

/// What a program could not write into the journal before it ended: orders and notes, in a small JSON file beside it
/// (for a server, among the application's data). What the controllers will tell again is not kept.
namespace journal {

class Database;

[[nodiscard]] QString unsavedPath(const QUrl &place);

/// Adds to the file. Answers in a sentence for the log what was kept or lost; may block.
[[nodiscard]] QString leaveUnsaved(
    const QUrl &place, const std::vector<std::variant<OrderRecord, Sighting, HistoryReading, Note>> &changes);
/// Brings the file into the database, if there is one, and removes it. An order that is there already does not come
/// twice. A file that cannot be understood is renamed.
[[nodiscard]] values::Result<void> takeInUnsaved(Database &database);

} // namespace journal
