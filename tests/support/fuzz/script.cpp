// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "virtualcontroller/script.h"

namespace fuzz {

namespace {

/// What `pendesk-sim --script` reads: any JSON is taken, or refused with the place of the fault; what was taken runs.
void take(QByteArrayView data)
{
    using namespace virtualcontroller;
    auto script = Script::parse(data.toByteArray());
    if (!script) {
        require(!script.error().detail.isEmpty(), "a refusal without a sentence");
        return;
    }
    static const Memory original;
    Memory memory = original;
    script->run(memory, memory.now + std::chrono::hours {1});
}

Seeds seeds()
{
    return {R"([{"at": 2.5, "alarm": 4416, "name": "PULSE LIMIT", "cause": true}, {"at": 4, "removeCause": 4416}])",
        R"([{"at": 5, "error": true}, {"at": 6, "input": 3, "on": true}, {"at": 7, "mode": "teach"}])",
        R"([{"at": 8, "hold": "pendant", "on": true}, {"at": 9, "servo": false}, {"at": 10, "silence": 3}])",
        R"([{"at": 1e300, "servo": true}, {"at": -1, "safety": false}])"};
}

} // namespace

extern const Target script;
const Target script {"script", take, seeds, 320, 2000};

} // namespace fuzz
