// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/jobs/ordercard.h"

#include "ui/conditionwords.h"

namespace pages {

OrderCard::OrderCard(const Context &context, const QString &title, QWidget *parent)
    : Card(title, parent),
      m_orders {context.station.orders},
      m_state {context.station.state()},
      m_profile {context.station.profile()},
      m_outcome {widgets::sentence({}, ui::Role::Amber)}
{
    m_outcome->setObjectName(QStringLiteral("outcome"));
    m_outcome->hide();
    static_cast<QVBoxLayout *>(layout())->addWidget(m_outcome);
}

widgets::OrderButton *OrderCard::addButton(robot::Act act)
{
    auto *button = new widgets::OrderButton(m_orders, act);
    body()->addWidget(button);
    return button;
}

void OrderCard::begin(widgets::OrderButton *button, widgets::OrderButton::Agrees agrees)
{
    m_outcome->hide();
    if (agrees)
        button->expect(std::move(agrees));
}

/// An unknown outcome stays pending: the status tells the truth.
void OrderCard::end(widgets::OrderButton *button, robot::Act act, const values::Result<void> &result)
{
    m_outcome->setVisible(!result);
    if (result)
        return;
    m_outcome->setText(ui::explain(act, result.error(), m_profile.model));
    if (result.error().kind != values::ErrorKind::UnknownOutcome)
        button->stopExpecting();
}

} // namespace pages
