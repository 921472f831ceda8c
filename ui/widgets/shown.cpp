// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/shown.h"

#include "protocol/codes.h"
#include <QCoreApplication>

namespace widgets {

QString dash() { return QStringLiteral("—"); }

QString notTaught() { return QCoreApplication::translate("Shown", "not taught"); }

Shown unknown()
{
    return {{dash(), Lamp::None}, robot::Freshness::Unknown, QCoreApplication::translate("Shown", "Not read yet.")};
}

Shown refused(const values::Error &refusal)
{
    if (protocol::isNotTaught(refusal))
        return {{notTaught(), Lamp::None}, robot::Freshness::Refused, protocol::explain(refusal)};
    return {{dash(), Lamp::None}, robot::Freshness::Refused,
        QCoreApplication::translate("Shown", "Refused: %1").arg(protocol::explain(refusal))};
}

QString lastSeen(const QDateTime &clock)
{
    return QCoreApplication::translate("Shown", "Last seen %1").arg(clock.toString(u"HH:mm:ss"));
}

} // namespace widgets
