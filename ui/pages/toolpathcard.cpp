// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/toolpathcard.h"

#include "ui/widgets/shown.h"
#include "ui/widgets/toolpathview.h"
#include <QHBoxLayout>
#include <QPushButton>

namespace pages {

using robot::Freshness;
using robot::Kind;
using widgets::ToolPathView;

namespace {

quint16 cartesian(values::ControlGroup group)
{
    return group.instance <= 8 ? quint16(100 + group.instance) : quint16(0);
}

} // namespace

ToolPathCard::ToolPathCard(const robot::RobotState &state, QWidget *parent)
    : Card(tr("Tool path"), parent), m_state {state}
{
    auto *row = new QHBoxLayout;
    row->setSpacing(ui::space::gap);
    const std::pair<ToolPathView::Side, const char *> sides[] {{ToolPathView::Side::Top, "pathTop"},
        {ToolPathView::Side::Front, "pathFront"}, {ToolPathView::Side::Side, "pathSide"}};
    for (const auto &[side, name] : sides) {
        auto *view = new ToolPathView(side);
        view->setObjectName(QLatin1String(name));
        row->addWidget(view, 1);
        m_views << view;
    }
    auto *clearButton = new QPushButton(tr("Clear path"));
    clearButton->setObjectName(QStringLiteral("clearPath"));
    connect(clearButton, &QPushButton::clicked, this, &ToolPathCard::clear);
    body()->addLayout(row, 1);
    body()->addWidget(clearButton, 0, Qt::AlignLeft);
    connect(&state, &robot::RobotState::changed, this, &ToolPathCard::onChanged);
}

void ToolPathCard::setGroup(values::ControlGroup group)
{
    m_group = group;
    const QString name = values::toString(group);
    setNote(tr("%1 · base frame").arg(name));
    setReason(cartesian(group) == 0 ? tr("%1 has no tool point: HSES tells it of robots only.").arg(name) : QString());
    showPath();
}

void ToolPathCard::clear()
{
    m_paths.clear();
    showPath();
}

void ToolPathCard::onChanged(const robot::TopicRange &range)
{
    if (range.kind != Kind::Position)
        return;
    for (int number = std::max<int>(range.first, 101); number <= std::min<int>(range.last, 108); ++number) {
        const auto &reading = m_state.reading<Kind::Position>(number);
        trend::ToolPath &path = m_paths[quint16(number)];
        if (reading.value && m_state.freshness({Kind::Position, quint16(number)}) == Freshness::Live)
            path.append(*reading.value);
        else
            path.breakOff();
    }
    if (range.contains({Kind::Position, cartesian(m_group)}))
        showPath(); // with the value: a live one is never hatched
}

void ToolPathCard::showPath()
{
    const quint16 instance = cartesian(m_group);
    const auto &reading = m_state.reading<Kind::Position>(instance);
    const auto freshness = m_state.freshness({Kind::Position, instance});
    const bool isLive = freshness == Freshness::Live || !reading.value;
    for (ToolPathView *view : m_views) {
        view->show(m_paths[instance]);
        view->setStale(isLive ? QString() : widgets::lastSeen(reading.clock));
    }
    if (freshness == Freshness::Refused && reading.refusal)
        setReason(widgets::refused(*reading.refusal).note);
    else if (instance != 0)
        setReason({});
}

} // namespace pages
