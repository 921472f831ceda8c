// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/orders.h"

#include "protocol/codes.h"
#include <QSysInfo>

using values::Error;
using values::ErrorKind;
using values::Result;

namespace robot {

namespace {

journal::Outcome outcomeOf(const Result<void> &result)
{
    if (result)
        return journal::Outcome::Done;
    switch (result.error().kind) {
    case ErrorKind::Refused: return journal::Outcome::Refused;
    case ErrorKind::NotSent:
    case ErrorKind::BadInput:
    case ErrorKind::LocalFile: return journal::Outcome::Withheld;
    case ErrorKind::Cancelled: return journal::Outcome::Cancelled;
    default: return journal::Outcome::Unknown;
    }
}

/// What came back, in plain English.
QString replyText(const Error &error)
{
    if (error.kind == ErrorKind::UnknownOutcome)
        return QStringLiteral("no answer");
    if (error.kind != ErrorKind::Refused)
        return error.detail;
    const quint16 code = protocol::effectiveCode(error);
    const auto *row = protocol::findStatusCode(code);
    return row ? QLatin1String(row->meaning) : QStringLiteral("a code that is not in the code list");
}

/// Of whoever runs this program.
QString userName() { return qEnvironmentVariable("USER", qEnvironmentVariable("USERNAME")); }

template <Kind kind> std::optional<ValueOf<kind>> fresh(const RobotState &state, Topic topic)
{
    return state.freshness(topic) == Freshness::Live ? state.reading<kind>(topic.number).value : std::nullopt;
}

} // namespace

Attempt::Attempt(
    const Order &order, const journal::OrderRecord &blank, QObject *context, OrderHandler handler, QObject *parent)
    : QObject {parent}, m_record {blank}, m_context {context}, m_handler {std::move(handler)}
{
    m_record.action = QLatin1String(key(order.act));
    m_record.subject = order.subject;
    m_record.oldValue = order.oldValue;
    m_record.newValue = order.newValue;
}

bool Attempt::isSame(const Order &order) const
{
    return !m_isEnded && !m_withheld && m_record.action == QLatin1String(key(order.act))
        && m_record.subject == order.subject && m_record.newValue == order.newValue;
}

Attempt::~Attempt() { abandon(); }

void Attempt::abandon() { end(tl::unexpected(m_withheld.value_or(Error {ErrorKind::UnknownOutcome}))); }

void Attempt::end(const Result<void> &result)
{
    if (std::exchange(m_isEnded, true))
        return;
    m_record.duration = std::chrono::floor<Milliseconds>(now() - m_begun);
    m_record.outcome = outcomeOf(result);
    if (!result) {
        m_record.status = result.error().status;
        m_record.added = result.error().addedStatus;
        m_record.reply = replyText(result.error());
    }
    Q_EMIT ended(m_record);
    deleteLater();
    if (m_context && m_handler)
        std::exchange(m_handler, {})(result);
}

Orders::Orders(Controller &controller, Access &access, Arming &arming, QObject *parent)
    : QObject {parent},
      m_controller {controller},
      m_access {access},
      m_arming {arming},
      m_isNumberingVerified {controller.profile().isSimulation}
{
    connect(&controller, &Controller::linkStateChanged, this, &Orders::onLinkStateChanged);
    connect(&controller, &Controller::holdOrderChanged, this, &Orders::onHoldOrderChanged);
    connect(&controller.state(), &RobotState::changed, this, &Orders::update);
    connect(&access, &Access::levelChanged, this, &Orders::update);
    connect(&arming, &Arming::dropped, this, &Orders::onDropped);
    connect(&arming, &Arming::changed, this, &Orders::update);
    update();
}

Orders::~Orders()
{
    for (Attempt *attempt : findChildren<Attempt *>())
        attempt->abandon(); // the program may end before the turn of the event loop that a withheld one waits for
    if (isArmed())
        m_arming.drop(Arming::Drop::Disconnected);
}

session::Session *Orders::session() const { return m_controller.session(); }

Situation Orders::look() const
{
    Situation situation;
    situation.isLinkUp = m_controller.linkState() == LinkState::Monitoring;
    situation.level = m_access.level();
    situation.isArmed = isArmed();
    situation.status = fresh<Kind::Status>(m_controller.state(), topics::status);
    situation.job = fresh<Kind::Job>(m_controller.state(), topics::masterJob);
    situation.isNumberingVerified = m_isNumberingVerified;
    situation.canModelMove = m_controller.profile().dialect().hasMoves;
    return situation;
}

void Orders::setNumberingVerified(bool verified)
{
    m_isNumberingVerified = verified;
    update();
}

journal::OrderRecord Orders::blank() const
{
    journal::OrderRecord record;
    record.at = QDateTime::currentDateTimeUtc();
    record.user = userName();
    record.host = QSysInfo::machineHostName();
    record.level = QLatin1String(key(m_access.level()));
    record.controller = m_controller.profile().name;
    return record;
}

Attempt *Orders::attempt(const Order &order, QObject *context, OrderHandler handler)
{
    auto *attempt = new Attempt {order, blank(), context, std::move(handler), this};
    connect(attempt, &Attempt::ended, this, &Orders::noteLock);
    connect(attempt, &Attempt::ended, this, &Orders::recorded);
    return attempt;
}

Attempt *Orders::begin(const Order &order, QObject *context, OrderHandler handler)
{
    m_arming.tick(values::Clocks::read()); // before a click that waited while the program stood still
    const Result<void> permitted = permission(order);
    Attempt *attempt = this->attempt(order, context, std::move(handler));
    if (!permitted) {
        attempt->m_withheld = permitted.error();
        QMetaObject::invokeMethod(attempt, &Attempt::abandon, Qt::QueuedConnection);
        return nullptr;
    }
    connect(
        this, &Orders::linkDropped, attempt, [attempt] { attempt->end(values::failure(ErrorKind::UnknownOutcome)); });
    return attempt;
}

Result<void> Orders::permission(const Order &order) const
{
    if (const auto obstacle = this->obstacle(order.act))
        return values::failure(ErrorKind::NotSent, QLatin1String(title(*obstacle)));
    const auto open = findChildren<Attempt *>(QString(), Qt::FindDirectChildrenOnly);
    if (std::ranges::any_of(open, [&](const Attempt *attempt) { return attempt->isSame(order); }))
        return values::failure(ErrorKind::NotSent, QStringLiteral("The same order is under way"));
    return {};
}

void Orders::servoOff(QObject *context, OrderHandler handler)
{
    Attempt *attempt = this->attempt({Act::ServoOff}, context, std::move(handler));
    const auto unknown = [attempt] { attempt->end(values::failure(ErrorKind::UnknownOutcome)); };
    if (!session()) {
        QMetaObject::invokeMethod(attempt, unknown, Qt::QueuedConnection);
        return;
    }
    auto *order = new StopOrder {Stop::ServoOff, *session(), session()};
    connect(order, &QObject::destroyed, attempt, unknown); // with the link
    connect(order, &StopOrder::finished, attempt, [=](StopOrder::Outcome outcome, const std::optional<Error> &refusal) {
        switch (outcome) {
        case StopOrder::Outcome::Confirmed: return attempt->end({});
        case StopOrder::Outcome::Refused: return attempt->end(tl::unexpected(refusal.value_or(Error {})));
        case StopOrder::Outcome::Unconfirmed: return unknown();
        }
    });
    order->start();
}

/// HOLD can be ordered again before it is confirmed; that is one attempt. It ends as unknown when the link is closed.
void Orders::onHoldOrderChanged()
{
    using Progress = HoldOrder::Progress;
    const auto order = m_controller.holdFacts().order;
    const bool isNowhereToSend = order && order->progress == Progress::Unconfirmed && !session();
    if (!m_hold && order && (order->progress == Progress::UnderWay || isNowhereToSend))
        m_hold = attempt({Act::Hold}, nullptr, {});
    if (!m_hold || (order && order->progress == Progress::UnderWay))
        return;
    if (order && order->progress == Progress::Confirmed)
        m_hold->end({});
    else if (order && order->progress == Progress::Refused)
        m_hold->end(tl::unexpected(order->refusal.value_or(Error {})));
    else
        m_hold->end(values::failure(ErrorKind::UnknownOutcome));
    m_hold.clear();
}

void Orders::hold(const QList<Orders *> &orders)
{
    for (const Orders *each : orders)
        each->m_controller.sendHold();
    for (const Orders *each : orders)
        each->m_controller.tellHold();
}

bool Orders::arm()
{
    if (!m_arming.arm(*this, look(), now()))
        return false;
    m_lastDrop.reset();
    return true;
}

void Orders::onDropped(const QObject *robot, Arming::Drop reason)
{
    if (robot == this)
        m_lastDrop = {reason, QDateTime::currentDateTime()};
}

void Orders::onLinkStateChanged()
{
    if (isArmed() && m_controller.linkState() == LinkState::Disconnected)
        m_arming.drop(Arming::Drop::Disconnected); // somebody's wish, and no loss
    update();
    if (!m_situation.isLinkUp)
        Q_EMIT linkDropped();
}

void Orders::update()
{
    Situation situation = look();
    m_arming.follow(*this, situation); // it may drop, which leads here again
    situation.isArmed = isArmed();
    if (std::exchange(m_situation, situation) != situation)
        Q_EMIT situationChanged();
}

void Orders::noteLock(const journal::OrderRecord &record)
{
    const bool isLock = record.action == QLatin1String(key(Act::HlockOn));
    if (record.outcome == journal::Outcome::Withheld || (!isLock && record.action != QLatin1String(key(Act::HlockOff))))
        return;
    const bool isDone = record.outcome == journal::Outcome::Done;
    const bool isLocked = isLock ? isDone || record.outcome == journal::Outcome::Unknown : m_isPendantLocked && !isDone;
    if (std::exchange(m_isPendantLocked, isLocked) != isLocked)
        Q_EMIT pendantLockChanged();
}

} // namespace robot
