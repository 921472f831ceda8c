// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/jobs/startcard.h"

#include "ui/dialogs/startsheet.h"
#include "ui/widgets/armcontrol.h"
#include <QPushButton>

namespace pages {

StartCard::StartCard(const Context &context, QWidget *parent) : OrderCard(context, tr("Start"), parent)
{
    body()->addWidget(new widgets::ArmControl(context.station.orders));
    widgets::OrderButton *start = addButton(robot::Act::StartJob);
    start->setText(tr("Start…"));
    connect(start, &widgets::OrderButton::clicked, this, [this] { (new dialogs::StartSheet(m_orders, this))->show(); });
}

} // namespace pages
