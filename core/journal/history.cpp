// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "journal/history.h"

#include <algorithm>

using values::AlarmWithTexts;

namespace journal {

namespace {

using List = QList<AlarmWithTexts>;

/// The kept history continues `read` from entry `at` on, as far as both are there.
bool fits(const List &read, const List &known, qsizetype at)
{
    const qsizetype overlap = std::min(read.size() - at, known.size());
    return std::equal(read.cbegin() + at, read.cbegin() + at + overlap, known.cbegin(), isSameEntry);
}

/// The first entry of another minute than the newest one; the size if there is none.
qsizetype firstOfAnotherMinute(const List &list)
{
    const auto found = std::ranges::find_if(
        list, [&](const AlarmWithTexts &entry) { return !(entry.alarm.time == list.first().alarm.time); });
    return found - list.begin();
}

} // namespace

bool isSameEntry(const AlarmWithTexts &a, const AlarmWithTexts &b)
{
    return a.alarm.code == b.alarm.code && a.alarm.data == b.alarm.data && a.alarm.time == b.alarm.time;
}

bool isEnough(const List &read, const List &known)
{
    const qsizetype witness = known.isEmpty() ? 0 : firstOfAnotherMinute(known);
    const qsizetype at = read.size() - 1 - witness;
    return witness < known.size() && at >= 0 && fits(read, known, at);
}

qsizetype newCount(const List &read, const List &known)
{
    qsizetype at = std::max<qsizetype>(read.size() - known.size(), 0); // nothing older than what is kept can appear
    while (!fits(read, known, at))
        ++at;
    return at;
}

qsizetype checkCount(const List &read)
{
    const auto differs = [&](const AlarmWithTexts &entry) { return !isSameEntry(entry, read.first()); };
    const auto found = std::ranges::find_if(read, differs);
    return std::min<qsizetype>(found - read.begin() + 1, read.size());
}

} // namespace journal
