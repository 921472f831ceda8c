// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/controller.h"

#include "robot/policies.h"
#include "session/filesession.h"
#include "session/session.h"
#include "session/udptransport.h"
#include <QHostInfo>

using namespace std::chrono_literals;
using values::Error;
using values::ErrorKind;

namespace robot {

namespace {

constexpr auto watchPeriod = 50ms;
constexpr auto statisticsPeriod = 500ms;
constexpr auto standstill = 250ms; ///< Of this program itself, such as a long paint.
constexpr auto resolvePause = 2s;
constexpr int statusMissesUntilLost = 3;

} // namespace

/// What exists while a link is open. It is a child-less QObject: the context of everything that must end with the link.
struct Controller::Link : QObject {
    Link(const QHostAddress &address, const settings::Profile &profile)
        : transport {address, profile.port},
          session {transport, policyOf(profile)},
          fileTransport {address, profile.filePort},
          files {fileTransport, filePolicyOf(profile)}
    {
    }

    session::UdpTransport transport;
    session::Session session;
    session::UdpTransport fileTransport;
    session::FileSession files;
    QObject orders; ///< Parent of orders under way; they end before the session.
};

Controller::Controller(settings::Profile profile, QObject *parent)
    : QObject {parent},
      m_profile {std::move(profile)},
      m_state {new RobotState {this}},
      m_poller {new Poller {*m_state, m_profile.dialect(), this}},
      m_linkStateSince {QDateTime::currentDateTime()}
{
    connect(m_poller, &Poller::finished, this, &Controller::onFinished);
    connect(m_state, &RobotState::changed, this, [this](const TopicRange &range) {
        if (range.contains(topics::status) && m_state->status().value) {
            noteRelease();
            updateHold();
        }
    });
    connect(&m_watch, &QTimer::timeout, this, [this, last = Time {}]() mutable {
        const Time at = now();
        if (const auto pause = at - std::exchange(last, at); pause > standstill)
            m_lastStatus = std::min(m_lastStatus + pause, at); // not asked meanwhile: silence says nothing
        watch();
    });
    connect(&m_statisticsTimer, &QTimer::timeout, this, &Controller::statisticsChanged);
}

Controller::~Controller() = default;

session::Session *Controller::session() const { return m_link ? &m_link->session : nullptr; }

session::FileSession *Controller::files() const { return m_link ? &m_link->files : nullptr; }

session::LinkStatistics Controller::statistics() const
{
    return m_link ? m_link->session.statistics() : session::LinkStatistics {};
}

void Controller::setNumbering(protocol::Numbering numbering, const QDateTime &verified, const QString &software)
{
    const bool isOpen = m_linkState != LinkState::Disconnected;
    const bool isOther = numbering != m_profile.numbering;
    m_profile.numbering = numbering;
    m_profile.numberingVerified = verified;
    m_profile.numberingSoftware = software;
    if (!isOther)
        return;
    close();
    m_poller->setDialect(m_profile.dialect());
    if (isOpen)
        open();
}

void Controller::setPace(Pace pace)
{
    if (pace == m_state->pace())
        return;
    m_poller->setPace(pace);
    m_lastStatus = now(); // it was not asked so often before: silence says nothing
}

void Controller::open()
{
    if (m_linkState != LinkState::Disconnected)
        return;
    m_timesLost = 0;
    m_isIdentified = false;
    m_watch.start(watchPeriod);
    m_statisticsTimer.start(statisticsPeriod);
    setLinkState(LinkState::Checking);
    resolve();
}

void Controller::resolve()
{
    if (const QHostAddress address {m_profile.host}; !address.isNull())
        return openLink(address);
    QHostInfo::lookupHost(m_profile.host, this, [this](const QHostInfo &found) {
        if (m_linkState != LinkState::Checking || m_link)
            return;
        for (const QHostAddress &address : found.addresses()) {
            if (address.protocol() == QAbstractSocket::IPv4Protocol)
                return openLink(address);
        }
        setTrouble(
            Error {ErrorKind::Network, 0, 0, tr("The name %1 is not known to this computer.").arg(m_profile.host)});
        QTimer::singleShot(resolvePause, this, [this] {
            if (m_linkState == LinkState::Checking && !m_link)
                resolve();
        });
    });
}

void Controller::openLink(const QHostAddress &address)
{
    m_link = std::make_unique<Link>(address, m_profile);
    connect(
        &m_link->session, &session::Session::outcomeUnknown, m_poller, [this] { m_poller->readNow(topics::status); });
    m_poller->setProbing(true);
    m_poller->start(m_link->session);
}

void Controller::close()
{
    if (m_linkState == LinkState::Disconnected)
        return;
    m_watch.stop();
    m_statisticsTimer.stop();
    dropLink();
    setLinkState(LinkState::Disconnected);
    setTrouble({});
    m_stop.clear();
    forgetHold();
    m_state->setLinkUp(false, now());
    m_state->clear();
}

/// The session may be the caller, several frames up: it goes when the event loop has control again.
void Controller::dropLink()
{
    m_poller->stop();
    if (m_link)
        m_link.release()->deleteLater();
}

void Controller::onFinished(const TopicRange &range, const std::optional<Error> &error)
{
    const bool isStatus = range == TopicRange(topics::status);
    if (range == TopicRange(topics::systemInformation) && !error)
        m_isIdentified = true;
    if (isStatus && (!error || error->kind == ErrorKind::Refused))
        m_lastStatus = now();
    if (m_linkState == LinkState::Checking && error)
        setTrouble(error);
    if (isStatus && !error) {
        readAlarmsOnEdge();
        onStatusAnswered();
    }
}

/// Alarms come and go with these bits: then they are read at once, and otherwise at their own pace.
void Controller::readAlarmsOnEdge()
{
    const values::Status &status = *m_state->status().value;
    const bool hasAlarm = status.hasAlarm() || status.hasError();
    if (std::exchange(m_hadAlarm, hasAlarm) == hasAlarm)
        return;
    for (int slot = 1; slot <= values::activeAlarmCount; ++slot)
        m_poller->readNow({Kind::Alarm, quint16(slot)});
}

void Controller::onStatusAnswered()
{
    if (m_linkState == LinkState::Monitoring || !m_isIdentified)
        return;
    setTrouble({});
    m_state->setLinkUp(true, now());
    m_poller->setProbing(false);
    setLinkState(LinkState::Monitoring);
}

/// Values grow old, and a status that stayed away for three time-outs means that communication is lost.
void Controller::watch()
{
    const Time at = now();
    const auto miss =
        std::max(m_profile.readTimeout, period(Kind::Status, m_state->pace())); // nobody is late before the slot
    if (m_linkState == LinkState::Monitoring && at - m_lastStatus > statusMissesUntilLost * miss) {
        ++m_timesLost;
        m_isIdentified = false; // another controller may answer next
        m_poller->setProbing(true);
        m_state->setLinkUp(false, at);
        setLinkState(LinkState::Lost);
    }
    m_state->tick(at);
    updateHold();
}

void Controller::tellHold()
{
    if (m_linkState == LinkState::Disconnected)
        return;
    const bool isSent = m_link != nullptr; // else the host's name is not resolved yet: nothing can leave
    setHoldOrder(HoldOrder {isSent ? HoldOrder::Progress::UnderWay : HoldOrder::Progress::Unconfirmed, now()});
}

/// Once more while it is under way: that is the same order, and its 2 s begin again.
void Controller::sendHold()
{
    if (!m_link)
        return;
    if (!m_stop) {
        m_stop = new StopOrder {Stop::Hold, m_link->session, &m_link->orders};
        connect(m_stop, &StopOrder::statusRead, this,
            [this](const values::Status &status, Time at) { m_state->take<Kind::Status>(1, status, at); });
        connect(m_stop, &StopOrder::finished, this, &Controller::endHold);
    }
    m_stop->start();
}

void Controller::endHold(StopOrder::Outcome outcome, const std::optional<Error> &refusal)
{
    using Progress = HoldOrder::Progress;
    m_stop.clear();
    switch (outcome) {
    case StopOrder::Outcome::Confirmed: return setHoldOrder(HoldOrder {Progress::Confirmed, now()});
    case StopOrder::Outcome::Refused: return setHoldOrder(HoldOrder {Progress::Refused, now(), refusal});
    case StopOrder::Outcome::Unconfirmed: return setHoldOrder(HoldOrder {Progress::Unconfirmed, now()});
    }
}

HoldFacts Controller::holdFacts() const
{
    const bool isLive = m_state->freshness(topics::status) == Freshness::Live;
    return {m_linkState, isLive ? m_state->status().value : std::nullopt, m_holdOrder, m_releasedAt};
}

void Controller::setHoldOrder(const std::optional<HoldOrder> &order)
{
    if (std::exchange(m_holdOrder, order) == order)
        return;
    m_releasedAt.reset();
    Q_EMIT holdOrderChanged();
    updateHold();
}

/// Called with each status that was read.
void Controller::noteRelease()
{
    const values::Status &status = *m_state->status().value;
    const bool isHeld = status.data2.testFlag(values::Status::HeldByCommand);
    const bool wasHeld = std::exchange(m_wasHeld, isHeld);
    if (status.isHeld())
        m_releasedAt.reset();
    else if (wasHeld)
        m_releasedAt = now();
}

/// Nothing of an earlier link is said on the next one.
void Controller::forgetHold()
{
    m_wasHeld = false;
    m_releasedAt.reset();
    if (!m_stop)
        setHoldOrder({});
}

void Controller::updateHold()
{
    const HoldState state = robot::holdState(holdFacts(), now());
    if (std::exchange(m_holdState, state) != state)
        Q_EMIT holdStateChanged();
}

void Controller::setLinkState(LinkState state)
{
    if (std::exchange(m_linkState, state) == state)
        return;
    m_linkStateSince = QDateTime::currentDateTime();
    if (state == LinkState::Monitoring)
        forgetHold();
    updateHold();
    Q_EMIT linkStateChanged();
}

void Controller::setTrouble(const std::optional<Error> &trouble)
{
    if (std::exchange(m_trouble, trouble) != trouble)
        Q_EMIT troubleChanged();
}

} // namespace robot
