// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/fixedtext.h"
#include <QString>
#include <array>
#include <span>

namespace values {

constexpr int maxAxes = 8;

/// Up to eight signed axis words, as many as the controller sent. What a word means is for the owner to say:
/// see Position::unit().
class AxisWords
{
public:
    constexpr AxisWords() = default;
    constexpr AxisWords(std::initializer_list<qint32> words) : m_count {int(words.size())}
    {
        Q_ASSERT(words.size() <= maxAxes);
        std::copy(words.begin(), words.end(), m_words.begin());
    }

    [[nodiscard]] int count() const { return m_count; }
    /// The new words are 0. `count` is 0 to 8.
    void resize(int count)
    {
        Q_ASSERT(count >= 0 && count <= maxAxes);
        std::fill(m_words.begin() + std::min(count, m_count), m_words.end(), 0);
        m_count = count;
    }
    qint32 &operator[](int axis) { return m_words[std::size_t(axis)]; }
    qint32 operator[](int axis) const { return m_words[std::size_t(axis)]; }
    [[nodiscard]] auto begin() const { return m_words.begin(); }
    [[nodiscard]] auto end() const { return m_words.begin() + m_count; }

    bool operator==(const AxisWords &) const = default;

private:
    std::array<qint32, maxAxes> m_words {};
    int m_count = 0;
};

/// Axis names as the controller gives them, empty where an axis is missing (reference §3.6).
struct AxisNames {
    std::array<FixedText<4>, maxAxes> names;

    [[nodiscard]] int count() const
    {
        return int(std::count_if(names.begin(), names.end(), [](const auto &name) { return !name.isEmpty(); }));
    }
    bool operator==(const AxisNames &) const = default;
};

/// What a position's words are relative to (reference §5.1).
enum class PositionType : quint32 { Pulse = 0, Base = 16, Robot = 17, User = 18, Tool = 19 };

/// The unit of one axis word (reference §5.1).
enum class AxisUnit { Pulse, Micrometre, TenThousandthDegree };

/// The unit of axis `axis` (from 0) in a position of the given type: X Y Z are lengths, Rx Ry Rz Re angles.
constexpr AxisUnit axisUnit(PositionType type, int axis)
{
    if (type == PositionType::Pulse)
        return AxisUnit::Pulse;
    return axis < 3 ? AxisUnit::Micrometre : AxisUnit::TenThousandthDegree;
}

/// A position as read with 0x75 or held by a P variable (reference §3.7, §4.4).
struct Position {
    PositionType type = PositionType::Pulse;
    quint32 form = 0; ///< Form bits, reference §5.2; 0 for pulse.
    quint32 tool = 0; ///< 0 to 63.
    quint32 userFrame = 0; ///< 1 to 63 with PositionType::User, else 0.
    quint32 extendedForm = 0; ///< Extended form bits, reference §5.2.
    AxisWords axes;

    bool operator==(const Position &) const = default;
};

/// How far each axis is behind its command, in pulses (reference §3.8).
struct FollowingError {
    AxisWords axes;

    bool operator==(const FollowingError &) const = default;
};

/// The torque of each axis; the unit is stated nowhere (reference §3.8).
struct Torque {
    AxisWords axes;

    bool operator==(const Torque &) const = default;
};

/// "pulse", "base frame", …; "unknown type 5" for others.
[[nodiscard]] QString toString(PositionType type);

/// A control group's number as instance (reference §2.1).
struct ControlGroup {
    quint16 instance = 1;

    static constexpr ControlGroup robotPulse(int robot) { return {quint16(robot)}; }
    static constexpr ControlGroup basePulse(int base) { return {quint16(10 + base)}; }
    static constexpr ControlGroup stationPulse(int station) { return {quint16(20 + station)}; }
    static constexpr ControlGroup robotCartesian(int robot) { return {quint16(100 + robot)}; }
    static constexpr ControlGroup baseCartesian(int base) { return {quint16(110 + base)}; }

    [[nodiscard]] constexpr bool isCartesian() const { return instance > 100; }
    bool operator==(const ControlGroup &) const = default;
};

/// The group in the pendant's words, "R1", "B2", "S3", whatever its coordinates; "group 99" for no known instance.
[[nodiscard]] QString toString(ControlGroup group);

} // namespace values
