// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

namespace robot {

/// What the person at this computer may do. Each level may do what the one before it may.
enum class Level {
    Monitor, ///< Watch, hold and switch servo off.
    Operate, ///< Start and what belongs to it.
    Engineer, ///< Change data and files, move the arm.
};

/// As in the journal, never translated: "Operate".
constexpr const char *key(Level level)
{
    switch (level) {
    case Level::Monitor: return "Monitor";
    case Level::Operate: return "Operate";
    case Level::Engineer: return "Engineer";
    }
    return "";
}

} // namespace robot
