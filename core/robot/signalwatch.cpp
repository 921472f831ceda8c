// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/signalwatch.h"

namespace robot {

using names::Signal;

SignalWatch::SignalWatch(const RobotState &state, QObject *parent) : QObject {parent}, m_state {state}
{
    connect(&state, &RobotState::changed, this, [this](const TopicRange &range) {
        const auto isWatched = [&](const SignalTrace &trace) {
            return range.contains({Kind::IoGroup, quint16(trace.signal.group)});
        };
        if (std::ranges::any_of(m_traces, isWatched))
            look(values::now());
    });
}

qsizetype SignalWatch::find(const Signal &signal) const
{
    const auto found = std::ranges::find(m_traces, signal, &SignalTrace::signal);
    return found == m_traces.end() ? -1 : found - m_traces.begin();
}

const SignalTrace *SignalWatch::trace(const Signal &signal) const
{
    const qsizetype index = find(signal);
    return index < 0 ? nullptr : &m_traces[index];
}

QList<TopicRange> SignalWatch::topics() const
{
    QList<TopicRange> result;
    for (const SignalTrace &trace : m_traces) {
        const TopicRange group {Topic {Kind::IoGroup, quint16(trace.signal.group)}};
        if (!result.contains(group))
            result += group;
    }
    return result;
}

void SignalWatch::add(const Signal &signal)
{
    if (isWatched(signal))
        return;
    m_traces += SignalTrace {signal, 0, 0, {}, {}};
    look(m_traces.last(), values::now());
    Q_EMIT listChanged();
}

void SignalWatch::remove(const Signal &signal)
{
    if (m_traces.removeIf([&](const SignalTrace &trace) { return trace.signal == signal; }) > 0)
        Q_EMIT listChanged();
}

void SignalWatch::reset()
{
    for (SignalTrace &trace : m_traces) {
        trace.rises = 0;
        trace.falls = 0;
        trace.changed = {};
    }
    Q_EMIT traced();
}

void SignalWatch::look(Time now)
{
    for (SignalTrace &trace : m_traces)
        look(trace, now);
    Q_EMIT traced();
}

void SignalWatch::look(SignalTrace &trace, Time now)
{
    const Topic topic {Kind::IoGroup, quint16(trace.signal.group)};
    const auto &reading = m_state.reading<Kind::IoGroup>(topic.number);
    const bool isLive = m_state.freshness(topic) == Freshness::Live && reading.value;
    const auto isOn = isLive ? std::optional {reading.value->isOn(trace.signal.bit)} : std::nullopt;
    const auto before = trace.spans.empty() ? std::nullopt : trace.spans.back().isOn;
    if (trace.spans.empty() || before != isOn)
        trace.spans.push_back({isLive ? std::max(reading.at, Time {}) : now, isOn});
    if (isOn && before && isOn != before) {
        ++(*isOn ? trace.rises : trace.falls);
        trace.changed = reading.clock;
    }
    while (trace.spans.size() > 1 && trace.spans[1].from < now - memory)
        trace.spans.pop_front();
}

} // namespace robot
