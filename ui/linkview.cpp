// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/linkview.h"

#include <QCoreApplication>

namespace ui {

LinkView linkView(const robot::Controller &controller)
{
    return {controller.linkState(), controller.linkStateSince(), controller.trouble(), controller.timesLost(),
        controller.holdState()};
}

QString linkWord(robot::LinkState state)
{
    switch (state) {
    case robot::LinkState::Checking: return QCoreApplication::translate("LinkView", "checking");
    case robot::LinkState::Monitoring: return QCoreApplication::translate("LinkView", "live");
    case robot::LinkState::Lost: return QCoreApplication::translate("LinkView", "communication lost");
    case robot::LinkState::Disconnected: break;
    }
    return QCoreApplication::translate("LinkView", "not connected");
}

QString addressText(const settings::Profile &profile)
{
    if (profile.port == protocol::robotPort || profile.host.isEmpty())
        return profile.host;
    return QStringLiteral("%1:%2").arg(profile.host).arg(profile.port);
}

} // namespace ui
