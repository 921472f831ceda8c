// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/conditions.h"

#include <algorithm>
#include <vector>

using values::Status;

namespace robot {

namespace {

using Judge = Verdict (*)(const Situation &);

Verdict verdict(bool isMet) { return isMet ? Verdict::Met : Verdict::NotMet; }

Verdict linkUp(const Situation &s) { return verdict(s.isLinkUp); }
Verdict statusFresh(const Situation &s) { return verdict(s.status.has_value()); }
Verdict armed(const Situation &s) { return verdict(s.isArmed); }
Verdict numberingVerified(const Situation &s) { return verdict(s.isNumberingVerified); }
Verdict modelMoves(const Situation &s) { return verdict(s.canModelMove); }
Verdict jobSet(const Situation &s) { return s.job ? verdict(!s.job->name.isEmpty()) : Verdict::Unread; }

template <Level level> Verdict atLeast(const Situation &s) { return verdict(s.level >= level); }

template <Status::Data1Flag flag, bool isWanted> Verdict data1(const Situation &s)
{
    return s.status ? verdict(s.status->data1.testFlag(flag) == isWanted) : Verdict::Unread;
}

template <Status::Data2Flag flag, bool isWanted> Verdict data2(const Situation &s)
{
    return s.status ? verdict(s.status->data2.testFlag(flag) == isWanted) : Verdict::Unread;
}

struct ConditionRow {
    Condition condition;
    const char *title;
    Judge judge; ///< None: HSES does not tell.
    QList<quint16> codes; ///< Refusals that it explains (reference §9).
};

/// One row a condition, in the order of Condition.
const std::vector<ConditionRow> &conditionRows()
{
    using enum Condition;
    static const std::vector<ConditionRow> rows {
        {LinkUp, QT_TRANSLATE_NOOP("Conditions", "The link to the controller is up"), linkUp, {}},
        {LevelOperate, QT_TRANSLATE_NOOP("Conditions", "The access level is Operate or Engineer"),
            atLeast<Level::Operate>, {}},
        {LevelEngineer, QT_TRANSLATE_NOOP("Conditions", "The access level is Engineer"), atLeast<Level::Engineer>, {}},
        {StatusFresh, QT_TRANSLATE_NOOP("Conditions", "The status is fresh"), statusFresh, {}},
        {Armed, QT_TRANSLATE_NOOP("Conditions", "This controller is armed"), armed, {}},
        {Remote, QT_TRANSLATE_NOOP("Conditions", "REMOTE is on"), data1<Status::Remote, true>,
            {0x2100, 0xE250, 0xE2B2}},
        {Play, QT_TRANSLATE_NOOP("Conditions", "The mode is PLAY"), data1<Status::Play, true>, {0x2080}},
        {NotTeach, QT_TRANSLATE_NOOP("Conditions", "The mode is not TEACH"), data1<Status::Teach, false>, {0x2080}},
        {NoAlarm, QT_TRANSLATE_NOOP("Conditions", "There is no alarm"), data2<Status::Alarm, false>, {0x2060}},
        {NoError, QT_TRANSLATE_NOOP("Conditions", "There is no error"), data2<Status::Error, false>, {0x2060}},
        {NotHeldByPendant, QT_TRANSLATE_NOOP("Conditions", "Not held by the pendant"),
            data2<Status::HeldByPendant, false>, {0x2020}},
        {NotHeldExternally, QT_TRANSLATE_NOOP("Conditions", "Not held by an external signal"),
            data2<Status::HeldExternally, false>, {0x2040}},
        {NotHeldByCommand, QT_TRANSLATE_NOOP("Conditions", "Not held by a command"),
            data2<Status::HeldByCommand, false>, {0x2050}},
        {HeldByCommand, QT_TRANSLATE_NOOP("Conditions", "Held by a command"), data2<Status::HeldByCommand, true>, {}},
        {HasError, QT_TRANSLATE_NOOP("Conditions", "The controller shows an error"), data2<Status::Error, true>, {}},
        {ServoOn, QT_TRANSLATE_NOOP("Conditions", "Servo power is on"), data2<Status::ServoOn, true>, {0x2070, 0x3010}},
        {NotRunning, QT_TRANSLATE_NOOP("Conditions", "No job is running"), data1<Status::Running, false>,
            {0x2010, 0x6010}},
        {JobSet, QT_TRANSLATE_NOOP("Conditions", "A job is selected"), jobSet, {0x4060}},
        {NumberingVerified, QT_TRANSLATE_NOOP("Conditions", "The numbering of variables is verified"),
            numberingVerified, {}},
        {ModelMoves, QT_TRANSLATE_NOOP("Conditions", "The model takes move orders"), modelMoves, {}},
        {SafetyChainClosed, QT_TRANSLATE_NOOP("Conditions", "The safety circuit is closed"), nullptr, {0x3450}},
        {NotHeldByPanel, QT_TRANSLATE_NOOP("Conditions", "Not held by a playback panel"), nullptr, {0x2030}},
        {HomeConfirmed, QT_TRANSLATE_NOOP("Conditions", "Home position and position check are confirmed"), nullptr,
            {0x3040, 0x3050}},
        {StartUnlocked, QT_TRANSLATE_NOOP("Conditions", "Starting is not locked at the panel"), nullptr, {0x3230}},
        {PanelUnlocked, QT_TRANSLATE_NOOP("Conditions", "Mode and cycle are not locked at the panel"), nullptr,
            {0x3220}},
        {JobSelectPermitted, QT_TRANSLATE_NOOP("Conditions", "Selecting a job in REMOTE and PLAY is permitted"),
            nullptr, {0x2080}},
        {MasterCallPermitted, QT_TRANSLATE_NOOP("Conditions", "Changing the master job is permitted"), nullptr,
            {0x3400, 0x3410, 0x3420}},
        {JobExists, QT_TRANSLATE_NOOP("Conditions", "The job exists on the controller"), nullptr, {0x4040}},
        {NotEditing, QT_TRANSLATE_NOOP("Conditions", "Nothing is being edited at the pendant"), nullptr, {0x2130}},
        {FilesFree, QT_TRANSLATE_NOOP("Conditions", "No other function uses the files"), nullptr, {0x2090, 0xE444}},
        {DataUnlocked, QT_TRANSLATE_NOOP("Conditions", "The data are not protected"), nullptr, {0x2110, 0x2120}},
        {OverwritePermitted, QT_TRANSLATE_NOOP("Conditions", "Replacing existing files is permitted"), nullptr,
            {0x4030, 0xE28C}},
    };
    return rows;
}

struct ActRow {
    Act act;
    const char *key;
    QList<Condition> needs;
    QList<Condition> hints;
};

using enum Condition;
using Conditions = QList<Condition>;

/// As start without a job (reference §10.2), with our own rules in front.
Conditions toStart(Condition level)
{
    return {LinkUp, level, StatusFresh, Armed, Remote, Play, NotTeach, NoAlarm, NoError, NotHeldByPendant,
        NotHeldExternally, NotHeldByCommand, ServoOn, NotRunning};
}

Conditions linkAnd(Condition level, const Conditions &more = {}) { return Conditions {LinkUp, level} + more; }

/// One row an act, in the order of Act: reference §10.2 with the access levels. What the reference only supposes for a
/// mere read is a hint, since trying does no harm.
const std::vector<ActRow> &actRows()
{
    static const Conditions operate = linkAnd(LevelOperate, {Remote});
    static const Conditions engineer = linkAnd(LevelEngineer);
    static const Conditions files = linkAnd(LevelEngineer, {Remote});
    static const Conditions atRest = linkAnd(LevelOperate, {Remote, NotRunning});
    static const Conditions inMotion {NotHeldByPanel, HomeConfirmed, StartUnlocked};
    static const std::vector<ActRow> rows {
        {Act::Arm, "arm", linkAnd(LevelOperate, {StatusFresh, Remote, Play, NotTeach, NoAlarm}), {}},
        {Act::ResetAlarm, "reset-alarm", operate, {}},
        {Act::CancelError, "cancel-error", operate + Conditions {HasError}, {}},
        {Act::WriteIo, "write-io", engineer, {DataUnlocked, NotEditing}},
        {Act::WriteRegister, "write-register", engineer, {DataUnlocked, NotEditing}},
        {Act::WriteVariable, "write-variable", engineer + Conditions {NumberingVerified}, {DataUnlocked, NotEditing}},
        {Act::SelectJob, "select-job", atRest, {JobSelectPermitted, NotEditing, JobExists}},
        {Act::SelectMasterJob, "select-master-job", atRest, {NotEditing, JobExists, MasterCallPermitted}},
        {Act::StartJob, "start", toStart(LevelOperate) + Conditions {JobSet}, inMotion},
        {Act::Hold, "hold", {}, {}},
        {Act::ReleaseHold, "release-hold", operate + Conditions {HeldByCommand}, {NotHeldByPendant, NotHeldExternally}},
        {Act::ServoOn, "servo-on",
            linkAnd(LevelOperate, {StatusFresh, Armed, Remote, Play, NotTeach, NoAlarm, NoError}), {SafetyChainClosed}},
        {Act::ServoOff, "servo-off", {}, {}},
        {Act::HlockOn, "hlock-on", files, {NotEditing, FilesFree}},
        {Act::HlockOff, "hlock-off", {LinkUp, Remote}, {NotEditing, FilesFree}}, // giving back asks for no level
        {Act::SelectCycle, "select-cycle", operate, {PanelUnlocked}},
        {Act::ShowPendantText, "pendant-text", operate, {}},
        {Act::Move, "move", toStart(LevelEngineer) + Conditions {ModelMoves}, inMotion},
        {Act::Jog, "jog", toStart(LevelEngineer) + Conditions {ModelMoves}, inMotion},
        {Act::Upload, "upload", files, {NotEditing, FilesFree, OverwritePermitted}},
        {Act::Download, "download", {LinkUp}, {Remote, NotEditing, FilesFree}},
        {Act::DeleteFile, "delete-file", files, {NotEditing, FilesFree}},
        {Act::Restore, "restore", files + Conditions {NotRunning}, {NotEditing, FilesFree, OverwritePermitted}},
    };
    return rows;
}

const ConditionRow &row(Condition condition) { return conditionRows()[std::size_t(condition)]; }
const ActRow &row(Act act) { return actRows()[std::size_t(act)]; }

Finding judge(Condition condition, const Situation &situation, bool isNeeded)
{
    const Judge judge = row(condition).judge;
    return {condition, judge ? judge(situation) : Verdict::Unreadable, isNeeded};
}

} // namespace

QList<Finding> findings(Act act, const Situation &situation)
{
    QList<Finding> result;
    for (const Condition condition : row(act).needs)
        result << judge(condition, situation, true);
    for (const Condition condition : row(act).hints)
        result << judge(condition, situation, false);
    return result;
}

std::optional<Condition> obstacle(Act act, const Situation &situation)
{
    for (const Condition condition : row(act).needs) {
        if (judge(condition, situation, true).blocks())
            return condition;
    }
    return std::nullopt;
}

QList<Condition> explanation(Act act, quint16 code)
{
    QList<Condition> result;
    for (const Condition condition : row(act).needs + row(act).hints) {
        if (row(condition).codes.contains(code))
            result << condition;
    }
    return result;
}

const char *key(Act act) { return row(act).key; }
const char *title(Condition condition) { return row(condition).title; }

} // namespace robot
