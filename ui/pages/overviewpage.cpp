// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/overviewpage.h"

#include "ui/pages/jobcard.h"
#include "ui/pages/linkcard.h"
#include "ui/pages/notconnectedpanel.h"
#include "ui/pages/optionscard.h"
#include "ui/pages/positioncard.h"
#include "ui/pages/statecard.h"
#include "ui/pages/systemcard.h"
#include "ui/widgets/board.h"
#include <QStackedLayout>

namespace pages {

namespace {

using robot::Topic;
using widgets::Place;

// State, Position, Options, Job, Link, System
constexpr Place wide[] {{0, 0}, {0, 1}, {0, 2}, {1, 0, 1, 2}, {1, 2, 2, 1}, {2, 0, 1, 2}};
constexpr Place medium[] {{0, 0}, {0, 1}, {3, 1}, {1, 0, 1, 2}, {2, 0, 2, 1}, {2, 1}};
constexpr Place narrow[] {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}};
constexpr widgets::Arrangement arrangements[] {{3, wide}, {2, medium}, {1, narrow}};

} // namespace

OverviewPage::OverviewPage(const Context &context, QWidget *parent)
    : Page(parent),
      m_layers {new QStackedLayout(this)},
      m_board {new widgets::Board(arrangements)},
      m_linkCard {new LinkCard(context.profile)},
      m_optionsCard {new OptionsCard}
{
    m_board->add(new StateCard(context.state));
    m_board->add(new PositionCard(context.state));
    m_board->add(m_optionsCard);
    m_board->add(new JobCard(context.state, context.profile.encoding));
    m_board->add(m_linkCard);
    m_board->add(new SystemCard(context.state, context.profile.model));
    m_board->setObjectName(QStringLiteral("overviewBoard"));
    auto *panel = new NotConnectedPanel(context);
    panel->setObjectName(QStringLiteral("notConnected"));
    m_layers->addWidget(panel);
    m_layers->addWidget(m_board);
    showLink({});
}

QList<Topic> OverviewPage::topics() const
{
    return {Topic::Status, Topic::Job, Topic::BasePosition, Topic::PulsePosition, Topic::BaseAxisNames,
        Topic::PulseAxisNames, Topic::SystemInformation};
}

void OverviewPage::showLink(const ui::LinkView &link)
{
    m_layers->setCurrentIndex(link.state == robot::LinkState::Disconnected ? 0 : 1);
    m_optionsCard->showLink(link);
}

void OverviewPage::showStatistics(const session::LinkStatistics &statistics) { m_linkCard->showStatistics(statistics); }

} // namespace pages
