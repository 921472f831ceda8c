// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/statecard.h"

#include "ui/widgets/statefield.h"
#include "ui/words.h"
#include <QCoreApplication>
#include <QGridLayout>
#include <QPainter>

namespace pages {

namespace {

struct StateRow {
    const char *name;
    const char *title;
    widgets::Word (*word)(const values::Status &);
    int row;
    int column;
    int span; ///< Of six columns.
};

constexpr StateRow stateRows[] {
    {"mode", QT_TRANSLATE_NOOP("pages::StateCard", "Mode"), ui::modeWord, 0, 0, 3},
    {"cycle", QT_TRANSLATE_NOOP("pages::StateCard", "Cycle"), ui::cycleWord, 0, 3, 3},
    {"servo", QT_TRANSLATE_NOOP("pages::StateCard", "Servo"), ui::servoWord, 1, 0, 3},
    {"run", QT_TRANSLATE_NOOP("pages::StateCard", "Run"), ui::runWord, 1, 3, 3},
    {"heldByPendant", QT_TRANSLATE_NOOP("pages::StateCard", "Hold · pendant"), ui::heldByPendantWord, 2, 0, 2},
    {"heldExternally", QT_TRANSLATE_NOOP("pages::StateCard", "Hold · external"), ui::heldExternallyWord, 2, 2, 2},
    {"heldByCommand", QT_TRANSLATE_NOOP("pages::StateCard", "Hold · command"), ui::heldByCommandWord, 2, 4, 2},
    {"alarm", QT_TRANSLATE_NOOP("pages::StateCard", "Alarm"), ui::alarmWord, 3, 0, 2},
    {"error", QT_TRANSLATE_NOOP("pages::StateCard", "Error"), ui::errorWord, 3, 2, 2},
    {"speedLimit", QT_TRANSLATE_NOOP("pages::StateCard", "Speed limit"), ui::speedLimitWord, 3, 4, 2},
};

/// Draws a hairline around each of its children.
class Cells : public QWidget
{
protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        painter.setPen(ui::color(ui::Role::Border, this));
        for (const QObject *child : children()) {
            if (const auto *widget = qobject_cast<const QWidget *>(child))
                painter.drawRect(widget->geometry());
        }
    }
};

} // namespace

StateCard::StateCard(const robot::RobotState &state, QWidget *parent) : Card(tr("State"), parent), m_state {state}
{
    auto *cells = new Cells;
    auto *grid = new QGridLayout(cells);
    grid->setContentsMargins(0, 0, 1, 1);
    grid->setSpacing(0);
    for (int column = 0; column < 6; ++column)
        grid->setColumnStretch(column, 1);
    for (const StateRow &field : stateRows) {
        auto *widget = new widgets::StateField(tr(field.title), ui::Type::State);
        widget->layout()->setContentsMargins(12, 5, 10, 6);
        widget->value()->setObjectName(QLatin1String(field.name));
        grid->addWidget(widget, field.row, field.column, 1, field.span);
        m_fields << widget;
    }
    body()->addWidget(cells, 1);
    connect(&state, &robot::RobotState::changed, this, &StateCard::onChanged);
    onChanged(robot::topics::status);
}

void StateCard::onChanged(const robot::TopicRange &range)
{
    if (!range.contains(robot::topics::status))
        return;
    const auto freshness = m_state.freshness(robot::topics::status);
    for (qsizetype i = 0; i < m_fields.size(); ++i)
        m_fields[i]->show(widgets::shown(m_state.status(), freshness, stateRows[i].word));
    setReason(freshness == robot::Freshness::Refused ? m_fields.front()->value()->shown().note : QString());
}

} // namespace pages
