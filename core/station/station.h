// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/alarmlog.h"
#include "robot/namebook.h"
#include "robot/numbering.h"
#include "robot/orders.h"
#include "settings/profilestore.h"
#include "trend/recorder.h"

namespace station {

/// What all stations of this program have in common.
struct Shared {
    settings::ProfileStore &store;
    robot::AccessRules &rules;
    robot::Arming &arming; ///< One for the whole program, so that one station is armed at most.
    journal::Store &journal;
};

/// One controller, and all that this program knows of it and does with it. It has no widget: windows, pages and
/// languages come and go around it, and the link, what was read and what was ordered go on.
struct Station {
    /// What is shared must outlive the station.
    Station(const settings::Profile &known, Shared common);

    [[nodiscard]] const settings::Profile &profile() const { return controller.profile(); }
    [[nodiscard]] const robot::RobotState &state() const { return controller.state(); }
    [[nodiscard]] bool isArmed() const { return orders.isArmed(); }
    /// What people keep about this controller at this computer.
    [[nodiscard]] settings::Notes notes() const { return shared.store.notes(profile().name); }

    Shared shared;
    robot::Controller controller; ///< For its life and its link.
    robot::Access access; ///< What may be done at this controller from here: Monitor in the beginning.
    robot::Orders orders; ///< For everything that changes something, and for reads that belong to a procedure.
    robot::NameBook names; ///< Of its signals and variables.
    robot::NumberingGuard numbering; ///< Lets variables be written once their numbering is known.
    trend::Recorder recorder; ///< What is plotted and kept of this controller.
    robot::AlarmLog alarms; ///< The alarms of this controller, as people and the journal know them.
};

} // namespace station
