// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/readplan.h"

#include "protocol/payloads.h"
#include "protocol/plural.h"

namespace robot {

using protocol::Dialect;
using protocol::InstanceRange;
using protocol::PluralRule;

namespace {

/// The rule of the plural command that reads this kind; nullopt where there is none.
std::optional<PluralRule> ruleOf(Kind kind, const Dialect &dialect)
{
    switch (kind) {
    case Kind::IoGroup: return protocol::pluralRule<values::IoGroup>();
    case Kind::Register: return protocol::pluralRule<values::Register>();
    case Kind::ByteVariable: return protocol::pluralRule<values::ByteVariable>();
    case Kind::IntegerVariable: return protocol::pluralRule<values::IntegerVariable>();
    case Kind::DoubleVariable: return protocol::pluralRule<values::DoubleVariable>();
    case Kind::RealVariable: return protocol::pluralRule<values::RealVariable>();
    case Kind::StringVariable: return PluralRule {dialect.stringSize};
    case Kind::PositionVariable: return protocol::pluralRule<values::PositionVariable>();
    case Kind::BasePosition: return protocol::pluralRule<values::BasePosition>();
    case Kind::ExternalPosition: return protocol::pluralRule<values::ExternalPosition>();
    default: return std::nullopt;
    }
}

/// The last number that one packet beginning at `topic` may reach.
quint16 lastOfArea(Topic topic, const Dialect &dialect)
{
    switch (topic.kind) {
    case Kind::IoGroup: {
        const auto area = dialect.ioArea(topic.number);
        return area ? dialect.ioRange(*area).last : topic.number;
    }
    case Kind::Register: return protocol::registers.last;
    case Kind::PositionVariable:
    case Kind::BasePosition:
    case Kind::ExternalPosition: return quint16(dialect.positionVariables - 1);
    default: return quint16(dialect.variables - 1);
    }
}

using Topics = std::set<Topic>;

/// Plans from `next` on as much as one packet can carry, and moves `next` behind it.
QList<PlannedRead> planNext(
    Topics::const_iterator &next, const Topics &topics, const Topics &refused, const Dialect &dialect)
{
    const Topic first = *next;
    const auto rule = ruleOf(first.kind, dialect);
    if (!rule || refused.contains(first)) {
        ++next;
        return {{first, 1}};
    }
    int end = std::max(lastOfArea(first, dialect), first.number);
    if (const auto wall = refused.upper_bound(first); wall != refused.end() && wall->kind == first.kind)
        end = std::min(end, wall->number - 1);
    const int reach = std::min(end, first.number + rule->maxCount() - 1);
    quint16 last = first.number;
    for (; next != topics.end() && next->kind == first.kind && next->number <= reach; ++next)
        last = next->number;
    QList<PlannedRead> result;
    for (const auto &chunk : protocol::chunksToRead(*rule, {first.number, last}, quint16(end)))
        result += {{first.kind, chunk.first, chunk.first + chunk.wanted - 1}, chunk.count};
    return result;
}

} // namespace

QList<PlannedRead> planReads(const QList<TopicRange> &wanted, const Topics &refused, const Dialect &dialect)
{
    Topics topics;
    for (const TopicRange &range : wanted) {
        for (int number = range.first; number <= range.last; ++number)
            topics.insert({range.kind, quint16(number)});
    }
    QList<PlannedRead> result;
    for (auto next = topics.cbegin(); next != topics.cend();)
        result << planNext(next, topics, refused, dialect);
    return result;
}

QList<PlannedRead> halves(const TopicRange &range, const Dialect &dialect)
{
    const int half = std::max(1, range.count() / 4 * 2); // even where it can be: bytes travel in pairs
    const int middle = range.first + half;
    return planReads({{range.kind, range.first, middle - 1}}, {}, dialect)
        + planReads({{range.kind, middle, range.last}}, {}, dialect);
}

} // namespace robot
