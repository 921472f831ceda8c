// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/fixedtext.h"
#include <QString>
#include <array>

namespace values {

/// What an alarm's sub code is (reference §3.3). Other numbers may come from a controller; they are kept.
enum class AlarmDataType : quint32 {
    None = 0,
    Unsigned16 = 1,
    Bits8 = 2,
    AxesSlurbt = 3,
    AxesXyz = 4,
    AxesXyzRxRyRz = 5,
    ConveyorFiles = 6,
    GroupsRobotStation = 8,
    Signed16 = 9,
    Bits16 = 10,
    GroupsRobot = 11,
    GroupsRobotStationBase = 12,
    GroupLowHighAxes = 20, ///< From here on the packing is not known: shown as hex with the type's meaning.
    GroupMinMaxAxes = 21,
    GroupMinMaxXyz = 22,
    AxesOfTwoGroups = 23,
    TwoAxisSets = 24,
    GroupAxesAndNumber = 25,
    GroupAndNumber = 27,
};

/// The sub code of an alarm and what it is.
struct AlarmData {
    quint32 value = 0;
    AlarmDataType type = AlarmDataType::None;

    /// "S L", "-12", "0000 0101", "R1 R2", hex for a packing that is not known; empty for None. Bit 0 is taken for the
    /// first of a set.
    [[nodiscard]] QString toString() const;
    bool operator==(const AlarmData &) const = default;
};

/// An active alarm, or an entry of the history (reference §3.1, §3.2).
struct Alarm {
    quint32 code = 0; ///< 1 to 9999; 0 where there is no alarm.
    AlarmData data;
    FixedText<16> time; ///< "YYYY/MM/DD hh:mm", by the controller's clock.
    FixedText<32> name; ///< In the pendant's encoding.

    /// An empty slot: the controller answers it with zeros, not with a refusal.
    [[nodiscard]] bool isEmpty() const { return code == 0; }
    bool operator==(const Alarm &) const = default;
};

/// An alarm with the texts of 0x30A and 0x30B. The texts are empty if the controller did not send them.
struct AlarmWithTexts {
    Alarm alarm;
    FixedText<16> extra; ///< The servo board, such as "[SV#1]".
    FixedText<96> subText; ///< The sub code in the controller's words.
    std::array<quint8, 96> reversed {}; ///< Reverse video, one byte a character of `subText`; its form is not known.

    bool operator==(const AlarmWithTexts &) const = default;
};

/// The five lists of the history. The value is the instance before the first entry.
enum class AlarmHistoryClass : quint16 { Major = 0, Minor = 1000, UserSystem = 2000, User = 3000, Offline = 4000 };
inline constexpr std::array allAlarmHistoryClasses {AlarmHistoryClass::Major, AlarmHistoryClass::Minor,
    AlarmHistoryClass::UserSystem, AlarmHistoryClass::User, AlarmHistoryClass::Offline};
constexpr int alarmHistoryLength = 100; ///< Entries a class; 1 is the newest.
constexpr int activeAlarmCount = 4; ///< Slots of active alarms; 1 is the newest.

/// What a sub code of this type is, in words: "axes"; "unknown type 30" for others.
[[nodiscard]] QString toString(AlarmDataType type);

} // namespace values
