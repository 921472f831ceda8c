// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/robotstate.h"

namespace robot {

namespace {

/// Joins numbers that come in rising order to ranges.
class Ranges
{
public:
    explicit Ranges(Kind kind) : m_kind {kind} { }
    void add(quint16 number)
    {
        if (!ranges.isEmpty() && ranges.last().last + 1 == number)
            ++ranges.last().last;
        else
            ranges << TopicRange(m_kind, number, number);
    }

    QList<TopicRange> ranges;

private:
    Kind m_kind;
};

} // namespace

RobotState::RobotState(QObject *parent) : QObject {parent} { }

/// Calls `function(kind, shelf)` for each kind.
template <typename Function> void RobotState::forEachShelf(Function function)
{
    [&]<std::size_t... kinds>(std::index_sequence<kinds...>)
    {
        (function(Kind(kinds), std::get<kinds>(m_shelves)), ...);
    }
    (std::make_index_sequence<kindCount> {});
}

template <typename Function> void RobotState::visit(Kind kind, Function function)
{
    forEachShelf([&](Kind shelfKind, auto &shelf) {
        if (shelfKind == kind)
            function(shelf);
    });
}

Freshness RobotState::freshness(Topic topic) const
{
    Freshness result = Freshness::Unknown;
    const_cast<RobotState *>(this)->visit(topic.kind, [&](const auto &shelf) {
        if (const auto found = shelf.find(topic.number); found != shelf.end())
            result = found->second.freshness;
    });
    return result;
}

void RobotState::refuse(const TopicRange &range, const values::Error &error, Time now)
{
    visit(range.kind, [&](auto &shelf) {
        for (int number = range.first; number <= range.last; ++number) {
            auto &entry = shelf[quint16(number)];
            entry.reading.refuse(error);
            entry.freshness = entry.reading.freshness(now, period(range.kind, m_pace), m_isLinkUp);
        }
    });
    Q_EMIT changed(range);
}

void RobotState::tick(Time now)
{
    QList<TopicRange> changes;
    forEachShelf([&](Kind kind, auto &shelf) {
        Ranges aged {kind};
        for (auto &[number, entry] : shelf) {
            const Freshness fresh = entry.reading.freshness(now, period(kind, m_pace), m_isLinkUp);
            if (std::exchange(entry.freshness, fresh) != fresh)
                aged.add(number);
        }
        changes << aged.ranges;
    });
    for (const TopicRange &range : changes)
        Q_EMIT changed(range);
}

void RobotState::setLinkUp(bool up, Time now)
{
    m_isLinkUp = up;
    tick(now);
}

void RobotState::clear()
{
    QList<TopicRange> changes;
    forEachShelf([&](Kind kind, auto &shelf) {
        Ranges gone {kind};
        for (const auto &[number, entry] : shelf)
            gone.add(number);
        changes << gone.ranges;
        shelf.clear();
    });
    for (const TopicRange &range : changes)
        Q_EMIT changed(range);
}

} // namespace robot
