// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "journal/record.h"
#include <optional>
#include <unordered_map>

namespace journal {

/// How often one alarm code is in the history.
struct CodeStatistics {
    quint32 code = 0;
    values::FixedText<32> name; ///< As in the newest entry.
    int count = 0;
    std::optional<std::chrono::minutes> meanBetween; ///< By the controller's clock; empty if it cannot be told.
    QDateTime last; ///< The controller's time of the newest entry, without zone; invalid if it is none.

    bool operator==(const CodeStatistics &) const = default;
};

/// The count of one code in one list of one controller. It grows entry by entry and is kept beside the history, so that
/// no question has to read the history again. Times that are no dates, steps back and the step from a clock that was
/// never set (before 2000) to one that was tell nothing of the time between two alarms and are left out.
struct AlarmTally {
    quint32 code = 0;
    values::FixedText<32> name; ///< As in the newest entry.
    qint64 count = 0;
    qint64 steps = 0; ///< Differences between two entries that tell something.
    qint64 minutes = 0; ///< Their sum.
    QDateTime last; ///< The controller's time of the newest entry; invalid if it is no date.
    qint64 newest = 0; ///< Grows with time: of two tallies the one with the higher number ends later.

    /// The next entry of the list.
    void add(const values::AlarmWithTexts &entry);
};

/// One row a code, from the tallies of all lists and controllers asked for: the most frequent first, of equal ones the
/// smaller code, at most `count`.
[[nodiscard]] QList<CodeStatistics> topCodes(const QList<AlarmTally> &tallies, qsizetype count);

/// The time in an alarm, "YYYY/MM/DD hh:mm", as a time without zone; invalid if it is none.
[[nodiscard]] QDateTime controllerTime(const values::FixedText<16> &time);

} // namespace journal
