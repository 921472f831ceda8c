// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/orderwords.h"

#include "protocol/codes.h"
#include "ui/conditionwords.h"
#include <QCoreApplication>

using journal::Outcome;

namespace ui {

namespace {

struct OrderTexts {
    Q_DECLARE_TR_FUNCTIONS(OrderRecords)
};

} // namespace

QString word(Outcome outcome)
{
    switch (outcome) {
    case Outcome::Done: return OrderTexts::tr("✓ done");
    case Outcome::Refused: return OrderTexts::tr("✗ refused");
    case Outcome::Unknown: return OrderTexts::tr("▲ unknown");
    case Outcome::Cancelled: return OrderTexts::tr("□ cancelled");
    case Outcome::Withheld: break;
    }
    return OrderTexts::tr("□ not sent");
}

Role roleOf(Outcome outcome)
{
    switch (outcome) {
    case Outcome::Refused:
    case Outcome::Unknown: return Role::Amber;
    case Outcome::Done: return Role::Text1;
    case Outcome::Cancelled:
    case Outcome::Withheld: break;
    }
    return Role::Text2;
}

QString actionTitle(const QString &key)
{
    for (int act = 0; act < robot::actCount; ++act) {
        if (key == QLatin1String(robot::key(robot::Act(act))))
            return title(robot::Act(act));
    }
    return key;
}

QString changeText(const journal::OrderRecord &order)
{
    if (order.oldValue.isEmpty() || order.newValue.isEmpty())
        return order.newValue + order.oldValue;
    return QStringLiteral("%1 → %2").arg(order.oldValue, order.newValue);
}

QString replyText(const journal::OrderRecord &order)
{
    if (order.outcome != Outcome::Refused)
        return order.reply;
    return protocol::explain({values::ErrorKind::Refused, quint8(order.status), order.added, {}});
}

} // namespace ui
