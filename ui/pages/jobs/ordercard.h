// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/pages/page.h"
#include "ui/widgets/card.h"
#include "ui/widgets/orderbutton.h"

namespace pages {

/// A card with buttons that order something, and one line for what became of the last order.
class OrderCard : public widgets::Card
{
    Q_OBJECT

public:
    OrderCard(const Context &context, const QString &title, QWidget *parent = nullptr);

protected:
    [[nodiscard]] widgets::OrderButton *addButton(robot::Act act);
    /// Sends it, shows "pending…" until the situation agrees, and says how it ended.
    template <protocol::TypedRequest R>
    void order(widgets::OrderButton *button, const R &request, const robot::Order &order,
        widgets::OrderButton::Agrees agrees = {})
    {
        begin(button, std::move(agrees));
        m_orders.send(request, order, this,
            [this, button, act = order.act](const values::Result<void> &result) { end(button, act, result); });
    }
    void begin(widgets::OrderButton *button, widgets::OrderButton::Agrees agrees);
    void end(widgets::OrderButton *button, robot::Act act, const values::Result<void> &result);

    robot::Orders &m_orders;
    const robot::RobotState &m_state;
    const settings::Profile &m_profile;
};

} // namespace pages
