// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/overviewpage.h"

#include "ui/pages/jobcard.h"
#include "ui/pages/linkcard.h"
#include "ui/pages/optionscard.h"
#include "ui/pages/positioncard.h"
#include "ui/pages/statecard.h"
#include "ui/pages/systemcard.h"
#include "ui/widgets/board.h"

namespace pages {

namespace {

using widgets::Place;

// State, Position, Options, Job, Link, System
constexpr Place overviewWide[] {{0, 0}, {0, 1}, {0, 2}, {1, 0, 1, 2}, {1, 2, 2, 1}, {2, 0, 1, 2}};
constexpr Place overviewMiddle[] {{0, 0}, {0, 1}, {3, 1}, {1, 0, 1, 2}, {2, 0, 2, 1}, {2, 1}};
constexpr Place overviewNarrow[] {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}};
constexpr widgets::Arrangement overviewBoards[] {{3, overviewWide}, {2, overviewMiddle}, {1, overviewNarrow}};

} // namespace

OverviewPage::OverviewPage(const Context &context, QWidget *parent)
    : Page(context, parent),
      m_linkCard {new LinkCard(context.station.profile())},
      m_optionsCard {new OptionsCard(context.station.orders)}
{
    auto *board = new widgets::Board(overviewBoards);
    board->add(new StateCard(context.station.state()));
    board->add(new PositionCard(context.station.state()));
    board->add(m_optionsCard);
    board->add(new JobCard(context.station.state(), context.station.profile().encoding));
    board->add(m_linkCard);
    board->add(new SystemCard(context.station.state(), context.station.profile().model));
    board->setObjectName(QStringLiteral("overviewBoard"));
    setContent(board);
}

QList<robot::TopicRange> OverviewPage::topics() const
{
    return {robot::topics::overview.begin(), robot::topics::overview.end()};
}

void OverviewPage::showLink(const ui::LinkView &link)
{
    Page::showLink(link);
    m_optionsCard->showLink(link);
}

void OverviewPage::showStatistics(const session::LinkStatistics &statistics) { m_linkCard->showStatistics(statistics); }

} // namespace pages
