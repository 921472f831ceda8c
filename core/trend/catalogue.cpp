// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "trend/catalogue.h"

namespace trend {

using robot::Kind;

namespace {

/// Collects the used elements of topics.
class Collector
{
public:
    void add(Kind kind, int first, int last, int elements = values::maxAxes * 2)
    {
        for (int number = first; number <= last; ++number) {
            for (int element = 0; element < std::min(elements, elementCount(kind)); ++element) {
                if (const Signal signal {{kind, quint16(number)}, quint16(element)}; isUsed(signal))
                    list << signal;
            }
        }
    }

    QList<Signal> list;
};

/// The axes of a group that answered; 0 for another.
int axesOf(const robot::RobotState &state, int instance)
{
    const auto &names = state.reading<Kind::AxisNames>(instance).value;
    return names ? names->count() : 0;
}

void addGroups(Collector &collector, const protocol::Dialect &dialect, const robot::RobotState &state)
{
    constexpr int usualAxes = 6;
    for (int instance = 1; instance <= 20 + dialect.stations; ++instance) {
        const int axes = axesOf(state, instance) > 0 || instance > 1 ? axesOf(state, instance) : usualAxes;
        if (axes > 0 && instance <= 8)
            collector.add(Kind::Position, 100 + instance, 100 + instance, axes);
        for (const Kind kind : {Kind::Position, Kind::FollowingError, Kind::Torque})
            collector.add(kind, instance, instance, axes);
        if (dialect.hasTemperatures)
            collector.add(Kind::EncoderTemperatures, instance, instance, axes);
    }
}

} // namespace

QList<Signal> allSignals(const protocol::Dialect &dialect, const robot::RobotState &state)
{
    Collector collector;
    collector.add(Kind::Status, 1, 1);
    collector.add(Kind::Job, 0, dialect.tasks - 1);
    addGroups(collector, dialect, state);
    if (dialect.hasTemperatures)
        collector.add(Kind::ConverterTemperature, 1, 2);
    collector.add(Kind::Alarm, 1, 4);
    for (const protocol::IoRange &range : dialect.io)
        collector.add(Kind::IoGroup, range.groups.first, range.groups.last);
    collector.add(Kind::Register, protocol::registers.first, protocol::registers.last);
    for (const Kind kind : {Kind::ByteVariable, Kind::IntegerVariable, Kind::DoubleVariable, Kind::RealVariable})
        collector.add(kind, 0, dialect.variables - 1);
    for (const Kind kind : {Kind::PositionVariable, Kind::BasePosition, Kind::ExternalPosition})
        collector.add(kind, 0, dialect.positionVariables - 1);
    return collector.list;
}

} // namespace trend
