// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "virtualcontroller/memory.h"

/// Alarms and errors as the controller raises and resets them (reference §3.1, §3.2, §10.2).
namespace virtualcontroller {

/// Below 4000 an alarm is a major one, from 8000 on a user alarm of the system, from 9000 on one of the user.
[[nodiscard]] values::AlarmHistoryClass historyClass(quint32 code);

/// Sets the alarm bit, enters the history and stops what runs; a major alarm turns servo power off. An alarm without a
/// time gets the present one.
void raiseAlarm(Memory &memory, values::AlarmWithTexts alarm, bool hasCause = false);
void raiseAlarm(Memory &memory, quint32 code, QByteArrayView name, values::AlarmData data = {});
/// The cause of an alarm has gone: the next reset clears it.
void removeCause(Memory &memory, quint32 code);
/// Clears the alarms without a cause, and the error.
void resetAlarms(Memory &memory);

/// The error message at the pendant; it stops what runs.
void raiseError(Memory &memory);
void cancelError(Memory &memory);

} // namespace virtualcontroller
