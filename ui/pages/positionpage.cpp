// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/positionpage.h"

#include "ui/pages/axescard.h"
#include "ui/pages/cartesiancard.h"
#include "ui/pages/controlgroups.h"
#include "ui/pages/toolpathcard.h"
#include "ui/widgets/board.h"
#include "ui/widgets/flow.h"
#include "ui/widgets/pageline.h"
#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTabBar>

namespace pages {

using robot::Kind;
using robot::TopicRange;

namespace {

using widgets::Place;

// Tool point, Axes, Path
constexpr Place positionWide[] {{0, 0}, {0, 1}, {1, 0, 1, 2}};
constexpr Place positionNarrow[] {{0, 0}, {1, 0}, {2, 0}};
constexpr widgets::Arrangement positionBoards[] {{2, positionWide}, {1, positionNarrow}};

QPushButton *positionButton(const QString &name, const QString &words)
{
    auto *result = new QPushButton(words);
    result->setObjectName(name);
    return result;
}

} // namespace

PositionPage::PositionPage(const Context &context, QWidget *parent)
    : Page(context, parent),
      m_state {context.station.state()},
      m_profile {context.station.profile()},
      m_tabs {new QTabBar},
      m_cartesian {new CartesianCard(context.station.state())},
      m_axes {new AxesCard(context.station.state(), context.station.profile())},
      m_path {new ToolPathCard(context.station.state())}
{
    auto *board = new widgets::Board(positionBoards);
    board->setObjectName(QStringLiteral("positionBoard"));
    board->add(m_cartesian);
    board->add(m_axes);
    board->add(m_path);
    auto *content = new QWidget;
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(header());
    column->addWidget(board, 1);
    setContent(content);
    connect(&m_state, &robot::RobotState::changed, this, &PositionPage::onChanged);
    showGroups();
}

QWidget *PositionPage::header()
{
    m_tabs->setObjectName(QStringLiteral("groupTabs"));
    m_tabs->setAccessibleName(tr("Control groups"));
    m_tabs->setDrawBase(false);
    m_tabs->setExpanding(false);
    auto *resetButton = positionButton(QStringLiteral("resetExtremes"), tr("Reset min and max"));
    auto *copyButton = positionButton(QStringLiteral("copyPosition"), tr("Copy as text"));
    auto *result = new QWidget;
    auto *row = new widgets::Flow(result);
    row->setContentsMargins(ui::space::page, 0, ui::space::page, ui::space::gap);
    row->addWidget(m_tabs);
    row->addStretch();
    row->addWidget(resetButton);
    row->addWidget(copyButton);
    connect(m_tabs, &QTabBar::currentChanged, this, &PositionPage::openTab);
    connect(resetButton, &QPushButton::clicked, this, &PositionPage::reset);
    connect(copyButton, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(toText()); });
    return result;
}

QList<TopicRange> PositionPage::topics() const
{
    const auto dialect = m_profile.dialect();
    const quint16 instance = m_group.instance;
    QList<TopicRange> result = groupTopics(dialect);
    result << robot::topics::status;
    for (const Kind kind : {Kind::Position, Kind::FollowingError, Kind::Torque})
        result << TopicRange(kind, instance, instance);
    if (instance <= 8)
        result << TopicRange(Kind::Position, 100 + instance, 100 + instance)
               << TopicRange(Kind::AxisNames, 100 + instance, 100 + instance);
    if (dialect.hasTemperatures)
        result << TopicRange(Kind::EncoderTemperatures, instance, instance)
               << TopicRange(Kind::ConverterTemperature, 1, 2);
    return result;
}

void PositionPage::showLink(const ui::LinkView &link)
{
    Page::showLink(link);
    m_isLive = link.state == robot::LinkState::Monitoring;
    showGroups();
    if (link.state == robot::LinkState::Disconnected)
        reset();
}

void PositionPage::onChanged(const TopicRange &range)
{
    if (range.kind == Kind::AxisNames)
        showGroups();
}

/// The tabs change only when another group answers, so that a tab bar in use stands still.
void PositionPage::showGroups()
{
    const auto [groups, refused, all] = controlGroups(m_state, m_profile.dialect());
    if (m_isLive)
        line().setSubject({{tr("%n control group(s)", nullptr, int(groups.size()))}, robot::Freshness::Live,
            refused == 0 ? QString()
                         : tr("Not shown because refused: %1 of %2 control groups.").arg(refused).arg(all)});
    if (groups != m_groups) {
        m_groups = groups;
        const QSignalBlocker blocker(m_tabs);
        while (m_tabs->count() > 0)
            m_tabs->removeTab(0);
        for (const values::ControlGroup &group : groups)
            m_tabs->addTab(values::toString(group));
        m_tabs->setCurrentIndex(std::max<int>(0, int(groups.indexOf(m_group))));
        openTab(m_tabs->currentIndex());
    }
}

void PositionPage::openTab(int tab)
{
    m_group = m_groups[tab];
    m_cartesian->setGroup(m_group);
    m_axes->setGroup(m_group);
    m_path->setGroup(m_group);
    Q_EMIT topicsChanged();
}

void PositionPage::reset()
{
    m_cartesian->resetExtremes();
    m_axes->resetExtremes();
}

QString PositionPage::toText() const
{
    QStringList parts {
        QStringLiteral("%1  %2").arg(m_profile.name, QDateTime::currentDateTime().toString(u"yyyy-MM-dd HH:mm:ss"))};
    for (const QString &text : {m_cartesian->toText(), m_axes->toText()}) {
        if (!text.isEmpty())
            parts << text;
    }
    return parts.join(QStringLiteral("\n\n")) + u'\n';
}

} // namespace pages
