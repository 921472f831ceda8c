// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/alarmlog.h"
#include "robot/edits.h"
#include "robot/joblibrary.h"
#include "robot/jog.h"
#include "robot/namebook.h"
#include "robot/numbering.h"
#include "robot/signalwatch.h"
#include "robot/variablehistory.h"
#include "settings/profilestore.h"
#include "station/backups.h"
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
/// languages come and go around it, and the link, what was read, what is staged and what is under way go on.
struct Station {
    /// What is shared must outlive the station.
    Station(const settings::Profile &known, Shared common);

    [[nodiscard]] const QUuid &id() const { return controller.profile().id; }
    [[nodiscard]] const settings::Profile &profile() const { return controller.profile(); }
    [[nodiscard]] const robot::RobotState &state() const { return controller.state(); }
    [[nodiscard]] bool isOpen() const { return controller.linkState() != robot::LinkState::Disconnected; }
    /// What people keep about this controller at this computer.
    [[nodiscard]] settings::Notes notes() const { return shared.store.notes(profile()); }
    /// What would be lost if the station went away now, in whole sentences.
    [[nodiscard]] QStringList unfinished() const;

    Shared shared;
    robot::Controller controller; ///< For its life and its link.
    robot::Access access; ///< What may be done at this controller from here: Monitor in the beginning.
    robot::Orders orders; ///< For everything that changes something, and for reads that belong to a procedure.
    robot::NameBook names; ///< Of its signals and variables.
    robot::NumberingGuard numbering; ///< Lets variables be written once their numbering is known.
    robot::VariableHistory history; ///< What variables and registers were before.
    robot::Edits edits; ///< The one set of values that are staged for this controller.
    robot::SignalWatch watch; ///< The signals that people watch; kept in notes().
    robot::JobLibrary jobs;
    robot::Jog jog;
    FileOrders fileOrders;
    files::TransferQueue transfers;
    Backups backups;
    trend::Recorder recorder; ///< What is plotted and kept of this controller.
    robot::AlarmLog alarms; ///< The alarms of this controller, as people and the journal know them.
};

} // namespace station
