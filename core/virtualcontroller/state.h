// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/error.h"
#include "virtualcontroller/memory.h"

namespace virtualcontroller {

/// Changes a memory to what a JSON object says; what it does not name stays as it is. A file that is given replaces the
/// one of that name, lists (alarms, histories) replace the whole list.
///
///     { "status": {"mode": "play", "remote": true, "servo": false, "cycle": "oneCycle", "hold": ["pendant"],
///                  "speedLimited": false, "error": false},
///       "interlocks": {"safetyChainClosed": true, "editing": false, "filesInUse": false, "dataLocked": false,
///                      "panelLocked": false, "startLocked": false, "homeConfirmed": true, "teachLocked": false,
///                      "jobSelectPermitted": true, "masterCallPermitted": true, "masterCalled": false},
///       "files": {"A.JBI": "/JOB\r\n..."},
///       "job": {"name": "WELD_A12", "line": 3, "override": 10000, "running": true},
///       "positions": {"R1": [0, 0, 0, 0, 0, 0], "S1": [0]},      pulses; more groups and axes are configured so
///       "alarms": [{"code": 4416, "data": 2, "type": 3, "time": "2026/01/12 08:30", "name": "...", "subText": "...",
///                   "extra": "[SV#1]", "cause": true}],          the newest first
///       "histories": {"major": [], "minor": [], "userSystem": [], "user": [], "offline": []},
///       "io": {"2701": 5},
///       "registers": {"0": 12},
///       "variables": {"B000": 1, "I000": -1, "D000": 1, "R000": 1.5, "S000": "text", "EX000": {"axes": [0]},
///                     "P000": {"type": 16, "tool": 0, "userFrame": 0, "form": 0, "extendedForm": 0, "axes": [0, 0]},
///                     "BP000": null},                             null: never taught
///       "times": {"1": {"start": "2025/03/14 09:26", "seconds": 3600}},
///       "systemInformation": {"11": {"software": "...", "model": "...", "parameters": "..."}},
///       "encoderTemperatures": {"1": [38, 41]}, "converterTemperatures": {"1": 44} }
///
/// BadInput with a sentence that names the key by its path, as "variables.B000"; the memory is then unchanged.
[[nodiscard]] values::Result<void> applyState(const QByteArray &json, Memory &memory);

} // namespace virtualcontroller
