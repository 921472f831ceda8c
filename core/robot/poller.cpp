// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/poller.h"

#include "session/session.h"
#include <QPointer>

using namespace std::chrono_literals;
using values::ControlGroup;
using values::Error;
using values::Result;

namespace robot {

namespace {

/// How often something that is read once is asked for until it is answered.
constexpr auto patience = 500ms;
/// How often something that was refused is asked for again.
constexpr auto refusedPause = 5s;

template <Kind kind> auto requestFor(int number)
{
    const auto instance = quint16(number);
    if constexpr (kind == Kind::Status)
        return protocol::ReadStatus {};
    else if constexpr (kind == Kind::Job)
        return protocol::ReadExecutingJob {number};
    else if constexpr (kind == Kind::Position)
        return protocol::ReadPosition {ControlGroup {instance}};
    else if constexpr (kind == Kind::AxisNames)
        return protocol::ReadAxisNames {ControlGroup {instance}};
    else if constexpr (kind == Kind::FollowingError)
        return protocol::ReadFollowingError {ControlGroup {instance}};
    else if constexpr (kind == Kind::Torque)
        return protocol::ReadTorque {ControlGroup {instance}};
    else if constexpr (kind == Kind::EncoderTemperatures)
        return protocol::ReadEncoderTemperatures {ControlGroup {instance}};
    else if constexpr (kind == Kind::ConverterTemperature)
        return protocol::ReadConverterTemperature {number};
    else if constexpr (kind == Kind::SystemInformation)
        return protocol::ReadSystemInformation {{instance}};
    else
        return protocol::ReadManagementTime {values::ManagementTimeCounter {instance}};
}

values::StringVariable32 widened(const values::StringVariable16 &narrow)
{
    return {values::FixedText<32>(narrow.value.bytes())};
}
template <typename Value> Value widened(const Value &value) { return value; }

} // namespace

Poller::Poller(RobotState &state, protocol::Dialect dialect, QObject *parent)
    : QObject {parent}, m_state {state}, m_dialect {dialect}
{
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &Poller::poll);
}

Poller::~Poller() = default;

Poller::Interest Poller::want(const QList<TopicRange> &topics) { return hold(m_interests, topics); }

Poller::Interest Poller::wantOnce(const QList<TopicRange> &topics)
{
    for (const TopicRange &range : topics)
        std::erase_if(m_answered, [&](Topic topic) { return range.contains(topic) && period(topic.kind) > 0ms; });
    return hold(m_onceInterests, topics);
}

Poller::Interest Poller::hold(Interests &interests, const QList<TopicRange> &topics)
{
    const auto release = [self = QPointer(this)](const QList<TopicRange> *list) {
        delete list;
        if (self)
            self->m_isPlanOld = true;
    };
    Interest interest {new QList<TopicRange>(topics), release};
    std::erase_if(interests, [](const auto &old) { return old.expired(); });
    interests.push_back(interest);
    m_isPlanOld = true;
    wake();
    return interest;
}

void Poller::start(session::Session &session)
{
    stop();
    m_session = &session;
    m_context = std::make_unique<QObject>();
    m_plan.clear();
    m_refused.clear();
    m_answered.clear();
    m_hasAlarmTexts = true;
    m_isPlanOld = true;
    wake();
}

void Poller::stop()
{
    m_timer.stop();
    m_context.reset();
    m_session = nullptr;
}

void Poller::readNow(Topic topic)
{
    for (auto &[read, slot] : m_plan) {
        if (read.range.contains(topic))
            slot.due = {};
    }
    wake();
}

void Poller::setPace(Pace pace)
{
    m_state.setPace(pace);
    for (auto &[read, slot] : m_plan)
        slot.due = {};
    wake();
}

void Poller::setProbing(bool probing)
{
    m_isProbing = probing;
    m_answered.clear(); // another controller may stand there now
    m_refused.clear();
    m_isPlanOld = true;
    wake();
}

void Poller::wake()
{
    if (m_session)
        m_timer.start(0ms);
}

QList<TopicRange> Poller::wanted()
{
    QList<TopicRange> result {topics::status, topics::systemInformation};
    for (const auto &weak : m_interests) {
        if (const auto interest = weak.lock(); interest && !m_isProbing)
            result << *interest;
    }
    return result;
}

/// One by one, without those that were answered.
QList<TopicRange> Poller::wantedOnce()
{
    QList<TopicRange> result;
    for (const auto &weak : m_onceInterests) {
        const auto interest = weak.lock();
        for (const TopicRange &range : interest && !m_isProbing ? *interest : QList<TopicRange>()) {
            for (int number = range.first; number <= range.last; ++number) {
                if (const Topic topic {range.kind, quint16(number)}; !m_answered.contains(topic))
                    result << topic;
            }
        }
    }
    return result;
}

int Poller::planSize()
{
    if (m_isPlanOld)
        replan();
    return int(m_plan.size());
}

/// What was planned before keeps its time and its answer on the way.
void Poller::replan()
{
    m_isPlanOld = false;
    Plan plan;
    add(plan, wanted(), false);
    add(plan, wantedOnce(), true);
    m_plan = std::move(plan);
}

void Poller::add(Plan &plan, const QList<TopicRange> &topics, bool isOnce)
{
    for (const PlannedRead &read : planReads(topics, m_refused, m_dialect)) {
        const auto known = m_plan.find(read);
        Slot slot = known == m_plan.end() ? Slot {} : known->second;
        slot.isOnce = isOnce || period(read.range.kind) == 0ms;
        plan.emplace(read, slot);
    }
}

/// Nothing is left to be asked.
bool Poller::isDone(const PlannedRead &read, const Slot &slot) const
{
    return slot.isOnce && m_answered.contains({read.range.kind, read.range.first});
}

void Poller::poll()
{
    if (m_isPlanOld)
        replan();
    const Time at = now();
    for (auto &[read, slot] : m_plan) {
        if (slot.due > at || isDone(read, slot))
            continue;
        const auto usual = period(read.range.kind, m_state.pace());
        auto pace = usual > 0ms ? usual : patience;
        if (m_refused.contains({read.range.kind, read.range.first}))
            pace = refusedPause;
        slot.due = slot.due + pace > at ? slot.due + pace : at + pace;
        if (!slot.isWaiting) {
            slot.isWaiting = true;
            send(read);
        }
    }
    schedule(at);
}

void Poller::schedule(Time at)
{
    Time next = Time::max();
    for (const auto &[read, slot] : m_plan) {
        if (!isDone(read, slot))
            next = std::min(next, slot.due);
    }
    if (next < Time::max())
        m_timer.start(std::chrono::ceil<Milliseconds>(std::max<Time::duration>(next - at, 1ms)));
}

void Poller::send(const PlannedRead &read)
{
    switch (read.range.kind) {
    case Kind::Status: return sendSingle<Kind::Status>(read);
    case Kind::Job: return sendSingle<Kind::Job>(read);
    case Kind::Position: return sendSingle<Kind::Position>(read);
    case Kind::AxisNames: return sendSingle<Kind::AxisNames>(read);
    case Kind::FollowingError: return sendSingle<Kind::FollowingError>(read);
    case Kind::Torque: return sendSingle<Kind::Torque>(read);
    case Kind::EncoderTemperatures: return sendSingle<Kind::EncoderTemperatures>(read);
    case Kind::ConverterTemperature: return sendSingle<Kind::ConverterTemperature>(read);
    case Kind::SystemInformation: return sendSingle<Kind::SystemInformation>(read);
    case Kind::ManagementTime: return sendSingle<Kind::ManagementTime>(read);
    case Kind::Alarm: return sendAlarm(read);
    case Kind::IoGroup: return sendItems<Kind::IoGroup, values::IoGroup>(read);
    case Kind::Register: return sendItems<Kind::Register, values::Register>(read);
    case Kind::ByteVariable: return sendItems<Kind::ByteVariable, values::ByteVariable>(read);
    case Kind::IntegerVariable: return sendItems<Kind::IntegerVariable, values::IntegerVariable>(read);
    case Kind::DoubleVariable: return sendItems<Kind::DoubleVariable, values::DoubleVariable>(read);
    case Kind::RealVariable: return sendItems<Kind::RealVariable, values::RealVariable>(read);
    case Kind::StringVariable:
        if (m_dialect.stringSize == 16)
            return sendItems<Kind::StringVariable, values::StringVariable16>(read);
        return sendItems<Kind::StringVariable, values::StringVariable32>(read);
    case Kind::PositionVariable: return sendItems<Kind::PositionVariable, values::PositionVariable>(read);
    case Kind::BasePosition: return sendItems<Kind::BasePosition, values::BasePosition>(read);
    case Kind::ExternalPosition: return sendItems<Kind::ExternalPosition, values::ExternalPosition>(read);
    }
}

/// The status, on which the link and every order depend, goes ahead of what waits; what is read once never delays what
/// is watched.
session::Priority Poller::priorityOf(const PlannedRead &read) const
{
    if (read.range.kind == Kind::Status)
        return session::Priority::Control;
    const auto slot = m_plan.find(read);
    const bool isOnce = slot != m_plan.end() && slot->second.isOnce;
    return isOnce && !m_isProbing ? session::Priority::Background : session::Priority::Page;
}

/// Asks, hands a value to `take` and settles the slot.
template <typename Request, typename Take> void Poller::ask(const PlannedRead &read, const Request &request, Take take)
{
    const auto onReply = [this, read, take](const Result<typename Request::Reply> &value) {
        const Time at = now();
        if (value)
            take(*value, at);
        settle(read, value ? std::nullopt : std::optional {value.error()}, at);
    };
    m_session->send(request, m_context.get(), onReply, priorityOf(read));
}

template <Kind kind> void Poller::sendSingle(const PlannedRead &read)
{
    const int number = read.range.first;
    ask(read, requestFor<kind>(number),
        [this, number](const ValueOf<kind> &value, Time at) { m_state.take<kind>(number, value, at); });
}

void Poller::sendAlarm(const PlannedRead &read)
{
    const int slot = read.range.first;
    if (m_dialect.hasAlarmTexts && m_hasAlarmTexts)
        return ask(read, protocol::ReadAlarmWithTexts {slot},
            [=, this](const values::AlarmWithTexts &alarm, Time at) { m_state.take<Kind::Alarm>(slot, alarm, at); });
    ask(read, protocol::ReadAlarm {slot}, [=, this](const values::Alarm &alarm, Time at) {
        m_state.take<Kind::Alarm>(slot, {alarm, {}, {}, {}}, at);
    });
}

template <Kind kind, typename Item> void Poller::sendItems(const PlannedRead &read)
{
    const bool isNumbered = kind != Kind::IoGroup && kind != Kind::Register;
    const int first = read.range.first;
    const quint16 instance = isNumbered ? protocol::variableInstance(first, m_dialect.numbering) : quint16(first);
    if (read.count == 1)
        return ask(read, protocol::ReadItem<Item> {instance},
            [=, this](const Item &item, Time at) { m_state.take<kind>(first, widened(item), at); });
    const auto request = protocol::ReadItems<Item>::create(instance, read.count);
    Q_ASSERT(request); // the plan keeps the rules
    ask(read, *request, [=, this](const QList<Item> &items, Time at) {
        QList<ValueOf<kind>> values;
        for (const Item &item : items.first(read.range.count()))
            values << widened(item);
        m_state.takeAll<kind>(first, values, at);
    });
}

void Poller::settle(const PlannedRead &read, const std::optional<Error> &error, Time at)
{
    const auto found = m_plan.find(read);
    if (error && error->kind == values::ErrorKind::Refused && found != m_plan.end())
        settleRefusal(found, *error, at);
    else if (error && (error->kind == values::ErrorKind::Malformed || error->kind == values::ErrorKind::Refused))
        m_state.refuse(read.range, *error, at);
    if (const auto still = m_plan.find(read); still != m_plan.end()) {
        Slot &slot = still->second;
        slot.isWaiting = false;
        const bool isAnswered = !error || error->kind == values::ErrorKind::Refused;
        if (isAnswered && slot.isOnce)
            noteAnswered(read.range);
        if (isAnswered && std::exchange(slot.isHalf, false)
            && std::ranges::none_of(m_plan, [](const auto &row) { return row.second.isHalf; }))
            m_isPlanOld = true; // all that is refused is known: the rest shares packets again
        if (!error && m_refused.erase({read.range.kind, read.range.first}) > 0)
            m_isPlanOld = true;
    }
    Q_EMIT finished(read.range, error);
}

void Poller::noteAnswered(const TopicRange &range)
{
    for (int number = range.first; number <= range.last; ++number)
        m_answered.insert({range.kind, quint16(number)});
}

void Poller::settleRefusal(Plan::iterator slot, const Error &error, Time at)
{
    const PlannedRead read = slot->first;
    const bool isOnce = slot->second.isOnce;
    const Topic topic {read.range.kind, read.range.first};
    if (read.count > 1) {
        m_plan.erase(slot);
        for (const PlannedRead &half : halves(read.range, m_dialect))
            m_plan[half] = {.isOnce = isOnce, .isHalf = true};
        return wake();
    }
    if (topic.kind == Kind::Alarm && std::exchange(m_hasAlarmTexts, false))
        return readNow(topic); // an older controller: alarms without texts
    m_state.refuse(read.range, error, at);
    if (topic.kind == Kind::Status)
        return;
    m_refused.insert(topic);
    slot->second.due = at + refusedPause;
}

} // namespace robot
