// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/topic.h"
#include <QObject>
#include <map>
#include <tuple>
#include <utility>

namespace robot {

/// The latest value of every topic that was read. Pages listen and show; only the poller and orders write.
class RobotState : public QObject
{
    Q_OBJECT

public:
    explicit RobotState(QObject *parent = nullptr);

    /// An empty reading if it was never read. The reference holds until clear().
    template <Kind kind> [[nodiscard]] const Reading<ValueOf<kind>> &reading(int number) const
    {
        static const Reading<ValueOf<kind>> none;
        const auto &shelf = std::get<std::size_t(kind)>(m_shelves);
        const auto found = shelf.find(quint16(number));
        return found == shelf.end() ? none : found->second.reading;
    }
    [[nodiscard]] const Reading<values::Status> &status() const { return reading<Kind::Status>(1); }
    /// `task` 0 is the master task.
    [[nodiscard]] const Reading<values::ExecutingJob> &job(int task = 0) const { return reading<Kind::Job>(task); }
    // R1
    [[nodiscard]] const Reading<values::Position> &basePosition() const
    {
        return reading<Kind::Position>(topics::basePosition.number);
    }
    [[nodiscard]] const Reading<values::Position> &pulsePosition() const
    {
        return reading<Kind::Position>(topics::pulsePosition.number);
    }
    [[nodiscard]] const Reading<values::AxisNames> &baseAxisNames() const
    {
        return reading<Kind::AxisNames>(topics::baseAxisNames.number);
    }
    [[nodiscard]] const Reading<values::AxisNames> &pulseAxisNames() const
    {
        return reading<Kind::AxisNames>(topics::pulseAxisNames.number);
    }
    [[nodiscard]] const Reading<values::SystemInformation> &systemInformation() const
    {
        return reading<Kind::SystemInformation>(topics::systemInformation.number);
    }

    /// As of the last change or tick; a change of it is announced by changed().
    [[nodiscard]] Freshness freshness(Topic topic) const;

    template <Kind kind> void take(int number, const ValueOf<kind> &value, Time now)
    {
        store<kind>(quint16(number), value, now);
        Q_EMIT changed(Topic {kind, quint16(number)});
    }
    /// What one packet brought: values with consecutive numbers. It must not be empty.
    template <Kind kind> void takeAll(int first, const QList<ValueOf<kind>> &values, Time now)
    {
        quint16 number = quint16(first);
        for (const auto &value : values)
            store<kind>(number++, value, now);
        Q_EMIT changed({kind, first, first + int(values.size()) - 1});
    }
    void refuse(const TopicRange &range, const values::Error &error, Time now);

    /// Looks at the clock: values that grew old become stale. Called a few times a period.
    void tick(Time now);
    /// While the link is down every value is stale at once.
    void setLinkUp(bool up, Time now);
    /// How often values come, and so when one is old.
    void setPace(Pace pace) { m_pace = pace; }
    [[nodiscard]] Pace pace() const { return m_pace; }
    /// Forgets everything: another controller, or none.
    void clear();

Q_SIGNALS:
    /// The value, the refusal or the freshness of topics in `range` is another than before, or they were read again.
    /// All that one packet brought is announced at once.
    void changed(const robot::TopicRange &range);

private:
    template <Kind kind> struct Entry {
        Reading<ValueOf<kind>> reading;
        Freshness freshness = Freshness::Unknown;
    };
    template <Kind kind> using Shelf = std::map<quint16, Entry<kind>>;
    template <std::size_t... kinds> static std::tuple<Shelf<Kind(kinds)>...> makeShelves(std::index_sequence<kinds...>);
    using Shelves = decltype(makeShelves(std::make_index_sequence<kindCount> {}));

    template <typename Function> void forEachShelf(Function function);
    template <typename Function> void visit(Kind kind, Function function);
    template <Kind kind> void store(quint16 number, const ValueOf<kind> &value, Time now)
    {
        auto &entry = std::get<std::size_t(kind)>(m_shelves)[number];
        entry.reading.take(value, now);
        entry.freshness = entry.reading.freshness(now, period(kind, m_pace), m_isLinkUp);
    }

    Shelves m_shelves;
    bool m_isLinkUp = false;
    Pace m_pace = Pace::Watched;
};

} // namespace robot
