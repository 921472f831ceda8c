// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/topic.h"

using namespace std::chrono_literals;

namespace robot {

namespace {

Milliseconds watchedPeriod(Kind kind)
{
    switch (kind) {
    case Kind::Status:
    case Kind::Position:
    case Kind::FollowingError:
    case Kind::Torque: return 100ms;
    case Kind::Job:
    case Kind::IoGroup: return 250ms;
    case Kind::Alarm: return 1s;
    case Kind::EncoderTemperatures:
    case Kind::ConverterTemperature:
    case Kind::ManagementTime: return 5s;
    case Kind::AxisNames:
    case Kind::SystemInformation: return 0ms;
    case Kind::Register:
    case Kind::ByteVariable:
    case Kind::IntegerVariable:
    case Kind::DoubleVariable:
    case Kind::RealVariable:
    case Kind::StringVariable:
    case Kind::PositionVariable:
    case Kind::BasePosition:
    case Kind::ExternalPosition: break;
    }
    return 500ms;
}

} // namespace

Milliseconds period(Kind kind, Pace pace)
{
    const Milliseconds watched = watchedPeriod(kind);
    if (pace == Pace::Watched || watched == 0ms)
        return watched;
    return kind == Kind::Alarm ? 10s : std::max<Milliseconds>(watched, 1s);
}

} // namespace robot
