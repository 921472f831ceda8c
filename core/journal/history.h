// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/alarm.h"
#include <QList>

/// How a controller's list of past alarms (reference §3.2) grows into the history that is kept for ever. All lists have
/// the newest entry first.
///
/// The controller keeps the last 100 and tells a time to the minute only, so equal entries may follow each other and
/// each of them counts. Where the kept history begins in a list is certain as soon as the two agree down to an entry of
/// another minute than the newest one kept; see isEnough().
namespace journal {

/// Two readings of one entry. The name is not compared: it changes with the pendant's language.
[[nodiscard]] bool isSameEntry(const values::AlarmWithTexts &a, const values::AlarmWithTexts &b);

/// The entries read so far show beyond doubt which of them are new. To be asked after each entry; while it is false,
/// read on, to an empty entry or the last one. `known`: the newest of the kept history, at least as many as a
/// controller keeps, or all of them.
[[nodiscard]] bool isEnough(const QList<values::AlarmWithTexts> &read, const QList<values::AlarmWithTexts> &known);

/// How many of the entries read are not in the kept history; they are the first ones. `read` goes down to where
/// isEnough() became true, or is the whole list without empty entries. Where so many equal alarms came within a minute
/// that the list no longer reaches down to another one, the controller does not tell how many: then the smallest
/// number.
[[nodiscard]] qsizetype newCount(const QList<values::AlarmWithTexts> &read, const QList<values::AlarmWithTexts> &known);

/// How many entries at the top must be read again to see that the list did not move while it was read: those equal to
/// the newest one, and one more.
[[nodiscard]] qsizetype checkCount(const QList<values::AlarmWithTexts> &read);

} // namespace journal
