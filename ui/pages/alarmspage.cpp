// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/alarmspage.h"

#include "robot/alarmlog.h"
#include "ui/pages/activealarmscard.h"
#include "ui/pages/alarmhistorycard.h"

namespace pages {

AlarmsPage::AlarmsPage(const Context &context, QWidget *parent) : Page(context, parent), m_log {context.station.alarms}
{
    auto *active = new ActiveAlarmsCard(context.station.alarms, context.station.orders);
    auto *history =
        new AlarmHistoryCard(context.station.alarms, context.station.shared.journal, context.station.profile());
    connect(active, &ActiveAlarmsCard::codeChosen, history, &AlarmHistoryCard::chooseCode);
    auto *content = new QWidget;
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(ui::space::page, 0, ui::space::page, ui::space::page);
    column->setSpacing(ui::space::gap);
    column->addWidget(active, 2);
    column->addWidget(history, 3);
    setContent(content);
}

QList<robot::TopicRange> AlarmsPage::topics() const
{
    return {robot::topics::status, {robot::Kind::Alarm, 1, values::activeAlarmCount}};
}

void AlarmsPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    m_log.readHistory();
}

} // namespace pages
