// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/move.h"

using namespace std::chrono_literals;
using values::Result;

namespace robot {

namespace {

/// For a move whose time cannot be told.
constexpr std::chrono::milliseconds longTime = 60s;

} // namespace

Move::Move(Orders &orders, const motion::Plan &plan, const motion::Present &present, QObject *parent)
    : QObject {parent}, m_orders {orders}, m_plan {plan}, m_present {present}
{
    connect(&orders.controller().state(), &RobotState::changed, this, &Move::onStateChanged);
    connect(&orders, &Orders::linkDropped, this, [this] {
        if (m_follower)
            take(m_follower->loseLink());
    });
    m_clock.setInterval(200ms);
    connect(&m_clock, &QTimer::timeout, this, [this] { take(m_follower->tick(now())); });
}

void Move::start()
{
    if (m_follower)
        return;
    m_follower.emplace(m_plan.target, now(), m_plan.time.value_or(longTime));
    m_clock.start();
    send(m_orders, Act::Move, m_plan, m_present, this, [this](const Result<void> &result) { onReply(result); });
}

Move::Outcome Move::outcome() const { return m_follower ? m_follower->outcome() : Outcome::UnderWay; }

std::optional<values::Position> Move::position() const { return m_follower ? m_follower->position() : std::nullopt; }

void Move::onReply(const Result<void> &result)
{
    if (!result)
        m_error = result.error();
    take(m_follower->takeReply(replyOf(result), now()));
}

void Move::onStateChanged(const TopicRange &range)
{
    const auto &status = m_orders.controller().state().status();
    if (!m_follower || isFinished() || range.kind != Kind::Status || !status.value)
        return;
    take(m_follower->takeStatus(status.value->isRunning(), status.at));
    if (!isFinished() && !m_isReading)
        readPlace();
}

void Move::readPlace()
{
    m_isReading = true;
    m_orders.read(
        protocol::ReadPosition {m_plan.watched}, this,
        [this](const Result<values::Position> &position) { onPlace(position); }, session::Priority::Control);
}

void Move::onPlace(const Result<values::Position> &position)
{
    m_isReading = false;
    if (position && !isFinished())
        take(m_follower->takePosition(*position, now()));
}

void Move::take(Outcome outcome)
{
    if (outcome != Outcome::UnderWay)
        m_clock.stop();
    Q_EMIT changed();
}

} // namespace robot
