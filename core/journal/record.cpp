// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "journal/record.h"

namespace journal {

const char *key(Outcome outcome)
{
    switch (outcome) {
    case Outcome::Done: return "done";
    case Outcome::Refused: return "refused";
    case Outcome::Unknown: return "unknown";
    case Outcome::Cancelled: return "cancelled";
    case Outcome::Withheld: break;
    }
    return "withheld";
}

const char *key(values::AlarmHistoryClass list)
{
    using values::AlarmHistoryClass;
    switch (list) {
    case AlarmHistoryClass::Major: return "major";
    case AlarmHistoryClass::Minor: return "minor";
    case AlarmHistoryClass::UserSystem: return "user-system";
    case AlarmHistoryClass::User: return "user";
    case AlarmHistoryClass::Offline: break;
    }
    return "offline";
}

} // namespace journal
