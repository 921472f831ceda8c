// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/motionpage.h"

#include "ui/pages/cartesiancard.h"
#include "ui/pages/controlgroups.h"
#include "ui/pages/motion/jogcard.h"
#include "ui/pages/motion/movecard.h"
#include "ui/widgets/armcontrol.h"
#include "ui/widgets/board.h"
#include "ui/widgets/conditionlist.h"
#include "ui/widgets/messagebar.h"
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QSignalBlocker>

namespace pages {

using robot::Kind;
using robot::TopicRange;
using values::ControlGroup;

namespace {

using widgets::Place;

// Readiness, Jog, Tool point, Move
constexpr Place motionWide[] {{0, 0, 2, 1}, {0, 1}, {0, 2}, {1, 1, 1, 2}};
constexpr Place motionMiddle[] {{0, 0}, {0, 1}, {1, 0}, {1, 1}};
constexpr Place motionNarrow[] {{0, 0}, {1, 0}, {2, 0}, {3, 0}};
constexpr widgets::Arrangement motionBoards[] {{3, motionWide}, {2, motionMiddle}, {1, motionNarrow}};

} // namespace

MotionPage::MotionPage(const Context &context, QWidget *parent)
    : Page(context, parent),
      m_state {context.station.state()},
      m_profile {context.station.profile()},
      m_jog {context.station.jog},
      m_group {new QComboBox},
      m_cartesian {new CartesianCard(context.station.state())},
      m_jogCard {new JogCard(context, m_jog)},
      m_move {new MoveCard(context, m_jog.limits())}
{
    auto *board = new widgets::Board(motionBoards);
    board->setObjectName(QStringLiteral("motionBoard"));
    board->add(readiness(context));
    for (QWidget *card : QWidgetList {m_jogCard, m_cartesian, m_move})
        board->add(card);
    auto *content = new QWidget;
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(statement());
    column->addWidget(board, 1);
    setContent(content);
    connect(m_group, &QComboBox::currentIndexChanged, this, &MotionPage::openGroup);
    connect(&m_state, &robot::RobotState::changed, this, [this](const TopicRange &range) {
        if (range.kind == Kind::AxisNames)
            showGroups();
    });
    showGroups();
}

/// Nobody holds a button of a page that is gone.
MotionPage::~MotionPage()
{
    m_jog.release();
    m_jog.setWindowActive(false);
}

QWidget *MotionPage::statement()
{
    auto *bar = new widgets::MessageBar(this); // shown from the first moment, and no window of its own
    bar->setObjectName(QStringLiteral("motionStatement"));
    bar->setContentsMargins(ui::space::page, 0, ui::space::page, ui::space::gap);
    bar->show({widgets::Severity::Warning,
        tr("Remote motion in automatic operation. The pendant’s enabling switch does not protect anyone here. Nobody "
           "may be inside the fence."),
        {}});
    return bar;
}

QWidget *MotionPage::readiness(const Context &context)
{
    auto *card = new widgets::Card(tr("Before each step"));
    m_group->setObjectName(QStringLiteral("motionGroup"));
    m_group->setAccessibleName(tr("Control group that moves"));
    auto *row = new QHBoxLayout;
    row->addWidget(widgets::text(tr("Control group"), ui::Type::Label, ui::Role::Text2));
    row->addWidget(m_group, 1);
    card->body()->addLayout(row);
    card->body()->addWidget(new widgets::ArmControl(context.station.orders));
    card->body()->addWidget(new widgets::ConditionList(context.station.orders, robot::Act::Jog));
    card->body()->addStretch();
    return card;
}

QList<TopicRange> MotionPage::topics() const
{
    QList<TopicRange> result = groupTopics(m_profile.dialect());
    const quint16 instance = m_group->currentData().isValid() ? quint16(m_group->currentData().toUInt()) : quint16(1);
    result << robot::topics::status;
    const auto add = [&](Kind kind, int number) { result << TopicRange(kind, number, number); };
    add(Kind::Position, instance);
    const int robot = instance > 20 ? 0 : instance > 10 ? instance - 10 : instance;
    if (robot == 0)
        return result;
    add(Kind::Position, 100 + robot);
    add(Kind::AxisNames, 100 + robot);
    if (instance > 10)
        add(Kind::Position, robot);
    else if (m_groups.contains(ControlGroup::basePulse(robot)))
        add(Kind::Position, 10 + robot);
    return result;
}

/// The choice changes only when another group answers.
void MotionPage::showGroups()
{
    const auto groups = controlGroups(m_state, m_profile.dialect()).groups;
    if (groups == m_groups)
        return;
    const auto before = m_group->currentData();
    m_groups = groups;
    {
        const QSignalBlocker blocker(m_group);
        m_group->clear();
        for (const ControlGroup group : groups)
            m_group->addItem(values::toString(group), group.instance);
        m_group->setCurrentIndex(std::max(0, m_group->findData(before)));
    }
    openGroup();
}

void MotionPage::openGroup()
{
    const ControlGroup group {quint16(m_group->currentData().toUInt())};
    m_cartesian->setGroup(group);
    m_jogCard->setGroup(group);
    m_move->setGroup(group);
    Q_EMIT topicsChanged();
}

/// The page may be given another window, which is then the one to be in front.
bool MotionPage::event(QEvent *event)
{
    if (event->type() == QEvent::Show || event->type() == QEvent::Hide || event->type() == QEvent::ParentChange)
        followWindow();
    return Page::event(event);
}

bool MotionPage::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::WindowActivate || event->type() == QEvent::WindowDeactivate)
        followWindow();
    return Page::eventFilter(watched, event);
}

void MotionPage::followWindow()
{
    window()->removeEventFilter(this);
    window()->installEventFilter(this);
    m_jog.setWindowActive(isVisible() && window()->isActiveWindow());
}

} // namespace pages
