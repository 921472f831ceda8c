// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "journal/alarmstatistics.h"
#include "journal/record.h"
#include <limits>

namespace journal {

/// Which orders. What is left empty allows everything.
struct OrderFilter {
    QDateTime from; ///< UTC, inclusive.
    QDateTime to; ///< UTC, exclusive.
    QString controller;
    QString action;
    std::optional<Outcome> outcome;
    QString text; ///< Contained in any text of the record; case does not matter for ASCII.
    qint64 newerThan = 0; ///< Came into the journal after the record with this id; see Page::newest.
};

/// Which past alarms. What is left empty allows everything.
struct AlarmFilter {
    QString controller;
    std::optional<values::AlarmHistoryClass> list;
    qint64 newerThan = 0; ///< As above.
};

/// Where the next page begins. The default is the newest record.
struct Cursor {
    qint64 at = std::numeric_limits<qint64>::max();
    qint64 id = std::numeric_limits<qint64>::max();
    qint64 newest = std::numeric_limits<qint64>::max(); ///< What came after the first page is on none of them.

    bool operator==(const Cursor &) const = default;
};

/// Records, the newest first, and where it goes on; nullopt at the end.
template <typename Record> struct Page {
    QList<Record> records;
    std::optional<Cursor> next;
    qint64 newest = 0; ///< The highest id when the first page was asked for; 0 if there was no record.
};

} // namespace journal
