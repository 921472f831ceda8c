// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/reading.h"
#include "values/alarm.h"
#include "values/job.h"
#include "values/managementtime.h"
#include "values/position.h"
#include "values/status.h"
#include "values/systeminformation.h"
#include "values/temperature.h"
#include "values/variable.h"

namespace robot {

/// What is read from a controller. The number of a topic tells which one of its kind.
enum class Kind {
    Status, ///< 1
    Job, ///< Task: 0 the master task, 1.. the sub tasks.
    Position, ///< Instance of the control group (reference §2.1), likewise the next four.
    AxisNames,
    FollowingError,
    Torque,
    EncoderTemperatures,
    ConverterTemperature, ///< Servo board, 1 or 2.
    SystemInformation, ///< Instance (reference §3.10).
    ManagementTime, ///< Instance of the counter (reference §3.9).
    Alarm, ///< Slot 1 to 4, 1 the newest.
    IoGroup, ///< Group of eight signals: 2701 is #27010 to #27017.
    Register, ///< 0 to 999
    ByteVariable, ///< Number of the variable, whatever the numbering on the wire; likewise the rest.
    IntegerVariable,
    DoubleVariable,
    RealVariable,
    StringVariable,
    PositionVariable,
    BasePosition,
    ExternalPosition,
};
constexpr int kindCount = int(Kind::ExternalPosition) + 1;

template <Kind kind> struct KindTraits;
template <> struct KindTraits<Kind::Status> {
    using Value = values::Status;
};
template <> struct KindTraits<Kind::Job> {
    using Value = values::ExecutingJob;
};
template <> struct KindTraits<Kind::Position> {
    using Value = values::Position;
};
template <> struct KindTraits<Kind::AxisNames> {
    using Value = values::AxisNames;
};
template <> struct KindTraits<Kind::FollowingError> {
    using Value = values::FollowingError;
};
template <> struct KindTraits<Kind::Torque> {
    using Value = values::Torque;
};
template <> struct KindTraits<Kind::EncoderTemperatures> {
    using Value = values::EncoderTemperatures;
};
template <> struct KindTraits<Kind::ConverterTemperature> {
    using Value = values::ConverterTemperature;
};
template <> struct KindTraits<Kind::SystemInformation> {
    using Value = values::SystemInformation;
};
template <> struct KindTraits<Kind::ManagementTime> {
    using Value = values::ManagementTime;
};
template <> struct KindTraits<Kind::Alarm> {
    using Value = values::AlarmWithTexts;
};
template <> struct KindTraits<Kind::IoGroup> {
    using Value = values::IoGroup;
};
template <> struct KindTraits<Kind::Register> {
    using Value = values::Register;
};
template <> struct KindTraits<Kind::ByteVariable> {
    using Value = values::ByteVariable;
};
template <> struct KindTraits<Kind::IntegerVariable> {
    using Value = values::IntegerVariable;
};
template <> struct KindTraits<Kind::DoubleVariable> {
    using Value = values::DoubleVariable;
};
template <> struct KindTraits<Kind::RealVariable> {
    using Value = values::RealVariable;
};
template <> struct KindTraits<Kind::StringVariable> {
    using Value = values::StringVariable32;
};
template <> struct KindTraits<Kind::PositionVariable> {
    using Value = values::PositionVariable;
};
template <> struct KindTraits<Kind::BasePosition> {
    using Value = values::BasePosition;
};
template <> struct KindTraits<Kind::ExternalPosition> {
    using Value = values::ExternalPosition;
};
template <Kind kind> using ValueOf = typename KindTraits<kind>::Value;

/// How closely a controller is followed.
enum class Pace {
    Watched, ///< Each kind at its own period.
    Background, ///< Nobody looks at its pages: once a second at most, and alarms when the status tells of a change.
};

/// How often a topic is read while something wants it; 0: once for each link.
[[nodiscard]] Milliseconds period(Kind kind, Pace pace = Pace::Watched);

/// One thing to be read.
struct Topic {
    Kind kind = Kind::Status;
    quint16 number = 1;

    auto operator<=>(const Topic &) const = default;
};

namespace topics {
inline constexpr Topic status {Kind::Status, 1};
inline constexpr Topic masterJob {Kind::Job, 0};
inline constexpr Topic systemInformation {Kind::SystemInformation, 11}; ///< R1.
constexpr Topic alarm(int slot) { return {Kind::Alarm, quint16(slot)}; } ///< 1 to 4.
constexpr Topic position(values::ControlGroup group) { return {Kind::Position, group.instance}; }
constexpr Topic axisNames(values::ControlGroup group) { return {Kind::AxisNames, group.instance}; }
// R1
inline constexpr Topic basePosition = position(values::ControlGroup::robotCartesian(1));
inline constexpr Topic pulsePosition = position(values::ControlGroup::robotPulse(1));
inline constexpr Topic baseAxisNames = axisNames(values::ControlGroup::robotCartesian(1));
inline constexpr Topic pulseAxisNames = axisNames(values::ControlGroup::robotPulse(1));
/// What tells about a robot at a glance.
inline constexpr std::array overview {
    status, masterJob, basePosition, pulsePosition, baseAxisNames, pulseAxisNames, systemInformation};
} // namespace topics

/// Things of one kind with consecutive numbers, first and last included.
struct TopicRange {
    Kind kind = Kind::Status;
    quint16 first = 1;
    quint16 last = 1;

    constexpr TopicRange() = default;
    constexpr TopicRange(Topic topic) : kind {topic.kind}, first {topic.number}, last {topic.number} { }
    constexpr TopicRange(Kind ofKind, int firstNumber, int lastNumber)
        : kind {ofKind}, first {quint16(firstNumber)}, last {quint16(lastNumber)}
    {
    }

    [[nodiscard]] constexpr int count() const { return last - first + 1; }
    [[nodiscard]] constexpr bool contains(Topic topic) const
    {
        return topic.kind == kind && topic.number >= first && topic.number <= last;
    }
    auto operator<=>(const TopicRange &) const = default;
};

} // namespace robot
