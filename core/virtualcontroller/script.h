// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/error.h"
#include "virtualcontroller/memory.h"
#include <functional>

namespace virtualcontroller {

/// A timeline of what happens to a controller by itself, for demonstrations, training and tests:
///
///     [ {"at": 2.5, "alarm": 4416, "name": "PULSE LIMIT(MIN/MAX)", "cause": true},
///       {"at": 4, "removeCause": 4416},        the next reset clears it
///       {"at": 5, "error": true},              an error message at the pendant
///       {"at": 6, "input": 3, "on": true},     user input IN#(3)
///       {"at": 7, "mode": "teach"},            or "play", "remote", "local"
///       {"at": 8, "hold": "pendant", "on": true},   or "external", "command"
///       {"at": 9, "servo": false},
///       {"at": 9, "safety": false},            the safety chain opens: servo power goes off and cannot come back
///       {"at": 10, "silence": 3} ]             nothing is answered for three seconds
///
/// Times are seconds since switching on.
class Script
{
public:
    struct Event {
        Time at {};
        std::function<void(Memory &)> happen;
    };

    Script() = default;
    explicit Script(std::vector<Event> events);

    /// BadInput says which event and which key are wrong.
    [[nodiscard]] static values::Result<Script> parse(const QByteArray &json);

    /// Advances the memory to each event that is due and lets it happen. Each one happens once.
    void run(Memory &memory, Time now);
    /// When the next event is due; nullopt if there is none left.
    [[nodiscard]] std::optional<Time> next() const;

private:
    std::vector<Event> m_events; ///< By time.
    std::size_t m_done = 0;
};

} // namespace virtualcontroller
