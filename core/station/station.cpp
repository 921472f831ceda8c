// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "station/station.h"

#include "station/watchlist.h"
#include <QCoreApplication>

namespace station {

namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(station::Station)
};

} // namespace

Station::Station(const settings::Profile &known, Shared common)
    : shared {common},
      controller {known},
      access {common.rules},
      orders {controller, access, common.arming},
      names {known, notes()},
      numbering {orders},
      history {state()},
      edits {orders, robot::formatOf(known)},
      watch {state()},
      jobs {orders},
      jog {orders, motion::limits(known.motion)},
      fileOrders {orders},
      backups {fileOrders, controller, notes()},
      recorder {controller, trend::Archive::folderOf(known.folderName())},
      alarms {orders, common.journal}
{
    keepWatchList(watch, notes(), known.dialect());
    QObject::connect(&orders, &robot::Orders::recorded, &common.journal, &journal::Store::append);
}

QStringList Station::unfinished() const
{
    QStringList sentences;
    if (const auto count = int(edits.staged().edits().size()); count > 0)
        sentences << Texts::tr("%n staged value(s) were not applied.", nullptr, count);
    if (!transfers.isIdle())
        sentences << Texts::tr("Files are still being transferred.");
    if (backups.isBusy())
        sentences << Texts::tr("Files are still being read or sent for a backup, a comparison or a restore.");
    return sentences;
}

} // namespace station
