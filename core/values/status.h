// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QFlags>
#include <QStringList>

namespace values {

/// The controller's status word pair as received (reference §3.4). Contradictory bits are kept, never corrected.
/// It holds no emergency-stop and no door state: HSES does not tell them.
struct Status {
    enum Data1Flag : quint32 {
        Step = 0x01,
        OneCycle = 0x02,
        Continuous = 0x04,
        Running = 0x08,
        SpeedLimited = 0x10, ///< In-guard safe operation.
        Teach = 0x20,
        Play = 0x40,
        Remote = 0x80, ///< Command remote.
    };
    Q_DECLARE_FLAGS(Data1, Data1Flag)

    enum Data2Flag : quint32 {
        HeldByPendant = 0x02,
        HeldExternally = 0x04,
        HeldByCommand = 0x08,
        Alarm = 0x10,
        Error = 0x20,
        ServoOn = 0x40,
    };
    Q_DECLARE_FLAGS(Data2, Data2Flag)

    Data1 data1;
    Data2 data2;

    [[nodiscard]] bool isRunning() const { return data1 & Running; }
    [[nodiscard]] bool isTeach() const { return data1 & Teach; }
    [[nodiscard]] bool isPlay() const { return data1 & Play; }
    [[nodiscard]] bool isRemote() const { return data1 & Remote; }
    [[nodiscard]] bool isSpeedLimited() const { return data1 & SpeedLimited; }
    [[nodiscard]] bool isHeld() const { return data2 & (Data2 {HeldByPendant} | HeldExternally | HeldByCommand); }
    [[nodiscard]] bool hasAlarm() const { return data2 & Alarm; }
    [[nodiscard]] bool hasError() const { return data2 & Error; }
    [[nodiscard]] bool isServoOn() const { return data2 & ServoOn; }
    /// TEACH and PLAY together, neither of them, or not exactly one cycle mode: shown as received and flagged.
    [[nodiscard]] bool hasContradictoryMode() const { return isTeach() == isPlay(); }
    [[nodiscard]] bool hasContradictoryCycle() const
    {
        const auto cycle = data1 & (Data1 {Step} | OneCycle | Continuous);
        return cycle != Step && cycle != OneCycle && cycle != Continuous;
    }

    /// The names of all set bits, as in `pendeskctl decode`: "play", "servo_on".
    [[nodiscard]] QStringList bitNames() const;

    bool operator==(const Status &) const = default;
};

Q_DECLARE_OPERATORS_FOR_FLAGS(Status::Data1)
Q_DECLARE_OPERATORS_FOR_FLAGS(Status::Data2)

} // namespace values
