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

/// Counts a history. Times that are no dates, steps back and the step from a clock that was never set (before 2000) to
/// one that was tell nothing of the time between two alarms and are left out.
class AlarmStatistics
{
public:
    /// The next entry of a list; the oldest first.
    void add(const values::AlarmWithTexts &entry);
    /// The most frequent first; of equal ones the smaller code.
    [[nodiscard]] QList<CodeStatistics> top(qsizetype count) const;

private:
    struct Tally {
        CodeStatistics statistics;
        qint64 minutes = 0; ///< Sum of `steps` differences.
        int steps = 0;
    };
    std::unordered_map<quint32, Tally> m_tallies;
};

/// The time in an alarm, "YYYY/MM/DD hh:mm", as a time without zone; invalid if it is none.
[[nodiscard]] QDateTime controllerTime(const values::FixedText<16> &time);

} // namespace journal
