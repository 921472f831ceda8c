// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/jobs/ordercard.h"

#include "ui/conditionwords.h"

namespace pages {

OrderCard::OrderCard(const Context &context, const QString &title, QWidget *parent)
    : Card(title, parent),
      m_orders {context.station.orders},
      m_state {context.station.state()},
      m_profile {context.station.profile()}
{
}

widgets::OrderButton *OrderCard::addButton(robot::Act act)
{
    auto *button = new widgets::OrderButton(m_orders, act);
    body()->addWidget(button);
    return button;
}

void OrderCard::begin(widgets::OrderButton *button, widgets::OrderButton::Agrees agrees)
{
    setReason({});
    if (agrees)
        button->expect(std::move(agrees));
}

/// An unknown outcome stays pending: the status tells the truth.
void OrderCard::end(widgets::OrderButton *button, robot::Act act, const values::Result<void> &result)
{
    setReason(result ? QString() : ui::explain(act, result.error(), m_profile.model));
    if (!result && result.error().kind != values::ErrorKind::UnknownOutcome)
        button->stopExpecting();
}

} // namespace pages
