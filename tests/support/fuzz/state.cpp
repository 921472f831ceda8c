// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "virtualcontroller/state.h"

namespace fuzz {

namespace {

/// What `pendesk-sim --state` reads: any JSON is taken, or refused with the place of the fault.
void take(QByteArrayView data)
{
    using namespace virtualcontroller;
    static const Memory original;
    Memory memory = original;
    if (const auto applied = applyState(data.toByteArray(), memory); !applied)
        require(!applied.error().detail.isEmpty(), "a refusal without a sentence");
}

Seeds seeds()
{
    return {R"({"status": {"mode": "play", "remote": true, "servo": false, "cycle": "oneCycle", "hold": ["pendant"]}})",
        R"({"interlocks": {"safetyChainClosed": true, "editing": false}, "files": {"A.JBI": "/JOB"}})",
        R"({"positions": {"R1": [0, 0, 0, 0, 0, 0], "S1": [0]}, "io": {"2701": 5}, "registers": {"0": 12}})",
        R"({"alarms": [{"code": 4416, "data": 2, "type": 3, "time": "2026/01/12 08:30", "name": "A", "cause": true}]})",
        R"({"variables": {"B000": 1, "I000": -1, "R000": 1.5, "S000": "text", "EX000": {"axes": [0]}}})"};
}

} // namespace

extern const Target state;
const Target state {"state", take, seeds, 320, 2000};

} // namespace fuzz
