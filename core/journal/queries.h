// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "journal/filter.h"
#include "values/error.h"

/// The journal's questions and changes in SQL. They run in the store's worker.
namespace journal {

class Database;

[[nodiscard]] values::Result<void> write(Database &database, const OrderRecord &order);
[[nodiscard]] values::Result<void> write(Database &database, const Sighting &sighting);
/// Adds the entries that the history does not have yet.
[[nodiscard]] values::Result<void> write(Database &database, const HistoryReading &reading);
/// Replaces the note of that code; an empty note is removed.
[[nodiscard]] values::Result<void> write(Database &database, const Note &note);

/// Counts the alarms that came before there were tallies.
[[nodiscard]] values::Result<void> countKeptAlarms(Database &database);

[[nodiscard]] values::Result<Page<OrderRecord>> orders(
    Database &database, const OrderFilter &filter, const Cursor &from, int count);
/// All actions that the journal has, in the order of the alphabet.
[[nodiscard]] values::Result<QStringList> orderActions(Database &database);
[[nodiscard]] values::Result<QStringList> orderControllers(Database &database);
/// In the order in which they were found, the newest first.
[[nodiscard]] values::Result<Page<AlarmRecord>> alarms(
    Database &database, const AlarmFilter &filter, const Cursor &from, int count);
/// The one seen last first, at most `count`.
[[nodiscard]] values::Result<QList<Sighting>> sightings(Database &database, const QString &controller, int count);
[[nodiscard]] values::Result<QList<CodeStatistics>> statistics(
    Database &database, const AlarmFilter &filter, int count);
[[nodiscard]] values::Result<QList<Note>> notes(Database &database);

} // namespace journal
