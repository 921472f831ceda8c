// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "station/station.h"

namespace station {

Station::Station(const settings::Profile &known, Shared common)
    : shared {common},
      controller {known},
      access {common.rules},
      orders {controller, access, common.arming},
      names {known, notes()},
      numbering {orders},
      recorder {controller, trend::Archive::folderOf(known.name)},
      alarms {orders, common.journal}
{
    names.follow(controller);
    QObject::connect(&orders, &robot::Orders::recorded, &common.journal, &journal::Store::append);
}

} // namespace station
