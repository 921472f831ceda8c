// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/jobstart.h"

using namespace std::chrono_literals;
using values::ErrorKind;
using values::Result;

namespace robot {

namespace {

constexpr auto askPause = 200ms;

} // namespace

JobStart::JobStart(Orders &orders, QString job, QObject *parent)
    : QObject {parent}, m_orders {orders}, m_job {std::move(job)}
{
}

bool JobStart::isFinished() const
{
    return m_phase != Phase::Sent && m_phase != Phase::Waiting && m_phase != Phase::Asking;
}

void JobStart::start()
{
    m_orders.send(protocol::StartJob {}, {Act::StartJob, m_job}, this,
        [this](const Result<void> &result) { onAnswered(result); });
}

void JobStart::onAnswered(const Result<void> &result)
{
    m_deadline = now() + runPatience;
    if (!result)
        m_error = result.error();
    if (result) {
        setPhase(Phase::Waiting);
        connect(&m_orders, &Orders::situationChanged, this, &JobStart::onSituationChanged);
        QTimer::singleShot(runPatience, this, [this] {
            if (m_phase == Phase::Waiting)
                setPhase(Phase::NotRunning);
        });
        onSituationChanged();
    } else if (result.error().kind == ErrorKind::Refused || result.error().kind == ErrorKind::NotSent) {
        setPhase(Phase::Refused);
    } else {
        setPhase(Phase::Asking);
        ask();
    }
}

/// The status can be older than the answer by one reading: a RUN in it can only be the one that was started, since a
/// start is withheld while a job runs.
void JobStart::onSituationChanged()
{
    const auto &status = m_orders.situation().status;
    if (m_phase == Phase::Waiting && status && status->isRunning())
        setPhase(Phase::Running);
}

void JobStart::ask()
{
    m_orders.read(protocol::ReadStatus {}, this, [this](const Result<values::Status> &status) { onStatus(status); });
}

void JobStart::onStatus(const Result<values::Status> &status)
{
    if (status)
        return setPhase(status->isRunning() ? Phase::UnknownRunning : Phase::UnknownNotRunning);
    if (now() >= m_deadline)
        return setPhase(Phase::UnknownStatus);
    QTimer::singleShot(askPause, this, &JobStart::ask);
}

void JobStart::setPhase(Phase phase)
{
    m_phase = phase;
    Q_EMIT phaseChanged();
}

} // namespace robot
