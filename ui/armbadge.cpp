// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/armbadge.h"

#include "ui/theme.h"
#include "ui/widgets/text.h"

using namespace std::chrono_literals;

namespace ui {

ArmBadge::ArmBadge(robot::Orders &orders, QWidget *parent) : QPushButton(parent), m_orders {orders}
{
    setObjectName(QStringLiteral("armBadge"));
    setProperty("badge", true);
    setProperty("amber", true);
    setAutoDefault(false);
    QFont small = ui::font(Type::Label);
    small.setWeight(QFont::DemiBold);
    setFont(small);
    widgets::reserveWidth(this, {tr("ARMED · %1 s").arg(60)});
    setToolTip(tr("This controller is armed: press to disarm."));
    connect(this, &QPushButton::clicked, this, [this] { m_orders.arming().drop(robot::Arming::Drop::ByHand); });
    connect(&m_clock, &QTimer::timeout, this, &ArmBadge::showArming);
    connect(&orders.arming(), &robot::Arming::changed, this, &ArmBadge::showArming);
    showArming();
}

void ArmBadge::showArming()
{
    setVisible(m_orders.isArmed());
    if (!m_orders.isArmed())
        return m_clock.stop();
    m_clock.start(1s);
    const auto left = m_orders.arming().remaining(values::now());
    const int seconds = int(std::chrono::ceil<std::chrono::seconds>(left).count());
    setText(tr("ARMED · %1 s").arg(seconds));
    setAccessibleName(tr("Armed for %n more second(s). Press to disarm.", nullptr, seconds));
}

} // namespace ui
