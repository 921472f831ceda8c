// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/alarmlog.h"
#include "robot/namebook.h"
#include "robot/numbering.h"
#include "robot/orders.h"
#include "settings/profilestore.h"
#include "trend/recorder.h"

namespace ui {

/// What the whole program shares: who may do what, and where it is written down.
struct Authority {
    robot::Access &access;
    robot::Arming &arming;
    journal::Store &journal;
};

/// One controller, and all that this program knows of it and does with it. Widgets come and go around it: a window that
/// changes its language makes its widgets anew, and the link, what was read and what was ordered go on.
struct Desk {
    /// `store` is asked while it is made; `authority` must outlive the desk.
    Desk(const settings::Profile &profile, const settings::ProfileStore &store, Authority authority)
        : controller {profile},
          orders {controller, authority.access, authority.arming},
          names {profile, store.notes(profile.name)},
          numbering {orders},
          recorder {controller, trend::Archive::folderOf(profile.name)},
          alarms {orders, authority.journal}
    {
        names.follow(controller);
        QObject::connect(&orders, &robot::Orders::recorded, &authority.journal, &journal::Store::append);
    }

    [[nodiscard]] const settings::Profile &profile() const { return controller.profile(); }

    robot::Controller controller;
    robot::Orders orders; ///< Everything that is ordered of it.
    robot::NameBook names;
    robot::NumberingGuard numbering;
    trend::Recorder recorder;
    robot::AlarmLog alarms;
};

} // namespace ui
