// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "session/linkmeter.h"

#include <algorithm>

using namespace std::chrono_literals;
using RoundTrips = std::vector<std::chrono::microseconds>;

namespace session {

namespace {

constexpr auto span = 60s;
constexpr std::size_t samplesPerSecond = 100;

Time secondOf(Time now) { return std::chrono::floor<std::chrono::seconds>(now); }

/// The value that `percent` of the samples do not exceed.
std::optional<std::chrono::microseconds> percentile(RoundTrips samples, std::size_t percent)
{
    if (samples.empty())
        return std::nullopt;
    const auto at = samples.begin() + std::ptrdiff_t((samples.size() - 1) * percent / 100);
    std::ranges::nth_element(samples, at);
    return *at;
}

} // namespace

LinkMeter::Second &LinkMeter::second(Time now)
{
    const Time begin = secondOf(now);
    if (m_seconds.empty() || m_seconds.back().begin != begin) {
        m_seconds.push_back({begin, 0, 0, {}});
        while (m_seconds.front().begin < begin - span)
            m_seconds.pop_front();
    }
    return m_seconds.back();
}

void LinkMeter::sent(Time now, quint16 command)
{
    ++second(now).sent;
    ++m_commands[command].sent;
}

void LinkMeter::miss(Time now, quint16 command)
{
    ++second(now).missed;
    ++m_commands[command].missed;
}

void LinkMeter::roundTrip(Time now, quint16 command, std::chrono::microseconds roundTrip)
{
    Second &current = second(now);
    if (current.roundTrips.size() < samplesPerSecond)
        current.roundTrips.push_back(roundTrip);
    CommandRecord &record = m_commands[command];
    record.roundTrips[record.answers++ % record.roundTrips.size()] = roundTrip;
    record.lastAnswer = now;
}

CommandStatistics LinkMeter::summary(quint16 command, const CommandRecord &record, Time now)
{
    const auto count = std::min<quint64>(record.answers, record.roundTrips.size());
    const RoundTrips samples {record.roundTrips.begin(), record.roundTrips.begin() + std::ptrdiff_t(count)};
    CommandStatistics result;
    result.command = command;
    result.p50 = percentile(samples, 50);
    result.p95 = percentile(samples, 95);
    result.loss = record.sent > 0 ? double(record.missed) / double(record.sent) : 0;
    if (count > 0)
        result.lastAnswerAge = std::chrono::duration_cast<Milliseconds>(now - record.lastAnswer);
    return result;
}

LinkStatistics LinkMeter::statistics(Time now) const
{
    LinkStatistics result;
    if (m_lastAnswer)
        result.lastAnswerAge = std::chrono::duration_cast<Milliseconds>(now - *m_lastAnswer);
    for (const auto &[command, record] : m_commands)
        result.commands.push_back(summary(command, record, now));
    const Time current = secondOf(now);
    RoundTrips all;
    int sent = 0;
    int missed = 0;
    if (m_seconds.empty())
        return result;
    result.seconds.resize(std::size_t((current - std::clamp(m_seconds.front().begin, current - span, current)) / 1s));
    for (const Second &second : m_seconds) {
        const auto age = (current - second.begin) / 1s;
        if (age > span / 1s)
            continue;
        sent += second.sent;
        missed += second.missed;
        all.insert(all.end(), second.roundTrips.begin(), second.roundTrips.end());
        if (age > 0)
            result.seconds[result.seconds.size() - std::size_t(age)] = {
                second.sent, second.missed, percentile(second.roundTrips, 50)};
    }
    result.p95 = percentile(all, 95);
    result.p50 = percentile(std::move(all), 50);
    result.loss = sent > 0 ? double(missed) / sent : 0;
    result.requestsPerSecond = result.seconds.empty() ? 0 : result.seconds.back().sent;
    return result;
}

} // namespace session
