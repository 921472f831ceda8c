// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/topic.h"
#include <QString>
#include <optional>

namespace trend {

/// What a number of a signal counts.
enum class Unit { Plain, Bit, Pulse, Millimetre, Degree, Percent, Celsius, Hour };

/// "mm", "pulses", "°"; empty for plain numbers and bits.
[[nodiscard]] QString toString(Unit unit);

struct Quantity {
    double value = 0;
    Unit unit = Unit::Plain;

    bool operator==(const Quantity &) const = default;
};

/// The name of one number of a controller: what is read, and which element of it. Any number that Pendesk can read and
/// plot has such a name.
struct Signal {
    robot::Topic topic;
    /// Counted from 0. The axis of a position, error, torque or temperature; the bit of an I/O group; a bit of the
    /// status (data 1 is 0 to 7, data 2 is 8 to 15); line, step, override of a job; 0 for a single number.
    quint16 element = 0;

    auto operator<=>(const Signal &) const = default;
};

/// How many elements a value of that kind can have; 0 for a kind that holds no numbers.
[[nodiscard]] int elementCount(robot::Kind kind);
/// The elements have a meaning of their own, as in "Held by command"; the bits of the status without one do not.
[[nodiscard]] bool isUsed(const Signal &signal);

/// The number itself; nullopt where the value does not have that element: an axis that the arm lacks, a text.
template <typename Value> std::optional<Quantity> quantity(const Value &, int) { return std::nullopt; }
[[nodiscard]] std::optional<Quantity> quantity(const values::Status &status, int bit);
[[nodiscard]] std::optional<Quantity> quantity(const values::ExecutingJob &job, int element);
[[nodiscard]] std::optional<Quantity> quantity(const values::Position &position, int axis);
[[nodiscard]] std::optional<Quantity> quantity(const values::FollowingError &error, int axis);
[[nodiscard]] std::optional<Quantity> quantity(const values::Torque &torque, int axis);
[[nodiscard]] std::optional<Quantity> quantity(const values::EncoderTemperatures &temperatures, int axis);
[[nodiscard]] std::optional<Quantity> quantity(const values::ConverterTemperature &temperature, int element);
[[nodiscard]] std::optional<Quantity> quantity(const values::ManagementTime &time, int element);
[[nodiscard]] std::optional<Quantity> quantity(const values::AlarmWithTexts &alarm, int element);
[[nodiscard]] std::optional<Quantity> quantity(const values::IoGroup &group, int bit);
[[nodiscard]] std::optional<Quantity> quantity(const values::Register &value, int element);
[[nodiscard]] std::optional<Quantity> quantity(const values::ByteVariable &value, int element);
[[nodiscard]] std::optional<Quantity> quantity(const values::IntegerVariable &value, int element);
[[nodiscard]] std::optional<Quantity> quantity(const values::DoubleVariable &value, int element);
[[nodiscard]] std::optional<Quantity> quantity(const values::RealVariable &value, int element);
[[nodiscard]] std::optional<Quantity> quantity(const values::PositionVariable &value, int axis);
[[nodiscard]] std::optional<Quantity> quantity(const values::BasePosition &value, int axis);
[[nodiscard]] std::optional<Quantity> quantity(const values::ExternalPosition &value, int axis);

/// A short label: "R1 X", "R1 S torque", "#00010", "B005". `axisName` is what the controller calls the axis; axes are
/// counted from 1 where it is empty.
[[nodiscard]] QString label(const Signal &signal, const QString &axisName = {});
/// Which topic names the axes of this signal; nullopt if it has no axes.
[[nodiscard]] std::optional<robot::Topic> namesOf(const Signal &signal);

/// The signal as one word for settings, files and drags: "torque.1.0".
[[nodiscard]] QString key(const Signal &signal);
/// nullopt for a word that is no signal, however it is spelled.
[[nodiscard]] std::optional<Signal> fromKey(QStringView key);

/// Signals as they travel in a drag: one key a line.
inline constexpr char mimeType[] = "application/x-pendesk-signals";
[[nodiscard]] QByteArray toMime(const QList<Signal> &list);
/// Lines that are no signals are left out.
[[nodiscard]] QList<Signal> fromMime(const QByteArray &data);

} // namespace trend
