// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/level.h"
#include "values/job.h"
#include "values/status.h"
#include <QList>
#include <optional>

namespace robot {

/// Everything that can be ordered, and arming.
enum class Act {
    Arm,
    ResetAlarm,
    CancelError,
    WriteIo,
    WriteRegister,
    WriteVariable,
    SelectJob,
    SelectMasterJob,
    StartJob,
    Hold,
    ReleaseHold,
    ServoOn,
    ServoOff,
    HlockOn,
    HlockOff,
    SelectCycle,
    ShowPendantText,
    Move,
    Jog,
    Upload,
    Download,
    DeleteFile,
    Restore,
};
constexpr int actCount = int(Act::Restore) + 1;

/// What an act may depend on, said so that it should be the case.
enum class Condition {
    LinkUp,
    LevelOperate,
    LevelEngineer,
    StatusFresh,
    Armed,
    Remote,
    Play,
    NotTeach,
    NoAlarm,
    NoError,
    NotHeldByPendant,
    NotHeldExternally,
    NotHeldByCommand,
    HeldByCommand,
    HasError,
    ServoOn,
    NotRunning,
    JobSet,
    NumberingVerified,
    ModelMoves,
    // HSES does not tell whether the following hold.
    SafetyChainClosed,
    NotHeldByPanel,
    HomeConfirmed,
    StartUnlocked,
    PanelUnlocked,
    JobSelectPermitted,
    MasterCallPermitted,
    JobExists,
    NotEditing,
    FilesFree,
    DataUnlocked,
    OverwritePermitted,
};
constexpr int conditionCount = int(Condition::OverwritePermitted) + 1;

enum class Verdict {
    Met,
    NotMet,
    Unread, ///< There is no fresh reading to judge it by.
    Unreadable, ///< HSES does not tell.
};

/// Everything that conditions look at. Readings that are stale or were never made are not there.
struct Situation {
    bool isLinkUp = false; ///< Monitoring.
    Level level = Level::Monitor;
    bool isArmed = false; ///< This controller.
    std::optional<values::Status> status;
    std::optional<values::ExecutingJob> job; ///< Of the master task.
    bool isNumberingVerified = false;
    bool canModelMove = true; ///< The model answers 0x8A and 0x8B.

    bool operator==(const Situation &) const = default;
};

/// How one condition of an act stands.
struct Finding {
    Condition condition = Condition::LinkUp;
    Verdict verdict = Verdict::Met;
    bool isNeeded = true; ///< Not met, it forbids the act. Otherwise it is shown, and the controller decides.

    [[nodiscard]] bool blocks() const { return isNeeded && verdict == Verdict::NotMet; }
    bool operator==(const Finding &) const = default;
};

/// "Why not?": every condition of the act, our own rules first, then in the order in which the controller would refuse
/// (reference §10.2), then what nobody can know beforehand. None for HOLD on and servo off, which are always possible.
[[nodiscard]] QList<Finding> findings(Act act, const Situation &situation);
/// The first condition that forbids the act now; nullopt if it may be tried.
[[nodiscard]] std::optional<Condition> obstacle(Act act, const Situation &situation);

/// The conditions of the act that explain a refusal with this code (reference §9); empty where the code says all.
[[nodiscard]] QList<Condition> explanation(Act act, quint16 code);

/// The act in the journal and in object names, never translated: "start", "write-register".
[[nodiscard]] const char *key(Act act);
/// The condition in plain English, for the journal; ui translates it (context "Conditions").
[[nodiscard]] const char *title(Condition condition);

} // namespace robot
