// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/conditionwords.h"

#include "protocol/codes.h"
#include <QCoreApplication>
#include <algorithm>

using robot::Act;
using robot::Arming;
using robot::Condition;
using robot::Level;
using robot::Verdict;

namespace ui {

namespace {

struct Conditions {
    Q_DECLARE_TR_FUNCTIONS(Conditions)
};

struct Words {
    Condition condition;
    const char *complaint;
    const char *remedy;
};

#define WORDS(text) QT_TRANSLATE_NOOP("Conditions", text)
// One row a condition, in the order of Condition; the titles are the core's.
// clang-format off
constexpr Words words[] {
    {Condition::LinkUp, WORDS("There is no link to the controller"), WORDS("connect, or wait until it answers again")},
    {Condition::LevelOperate, WORDS("The access level is Monitor"), WORDS("switch to Operate in the strip (Ctrl+L)")},
    {Condition::LevelEngineer, WORDS("The access level is not Engineer"),
        WORDS("switch to Engineer in the strip (Ctrl+L)")},
    {Condition::StatusFresh, WORDS("The status was not read just now"),
        WORDS("wait a moment; if it stays so, look at the link")},
    {Condition::Armed, WORDS("This controller is not armed"), WORDS("arm it on this page")},
    {Condition::Remote, WORDS("REMOTE is off"), WORDS("turn the pendant key to REMOTE and switch on CMD REMOTE SEL: %1")},
    {Condition::Play, WORDS("The mode is not PLAY"), WORDS("turn the pendant key to PLAY or REMOTE")},
    {Condition::NotTeach, WORDS("The controller is in TEACH"),
        WORDS("the person at the pendant has the robot: turn the key to REMOTE when that is over")},
    {Condition::NoAlarm, WORDS("There is an alarm"), WORDS("remove its cause, then reset it on the Alarms page")},
    {Condition::NoError, WORDS("There is an error"), WORDS("read it on the Alarms page, then cancel it")},
    {Condition::NotHeldByPendant, WORDS("Held by the pendant"), WORDS("release it there")},
    {Condition::NotHeldExternally, WORDS("Held by an external signal"), WORDS("release it where that signal comes from")},
    {Condition::NotHeldByCommand, WORDS("Held by a command"), WORDS("release HOLD on the Jobs page")},
    {Condition::HeldByCommand, WORDS("No command holds the robot"), WORDS("there is nothing to release from here")},
    {Condition::ServoOn, WORDS("Servo power is off"), WORDS("switch servo on")},
    {Condition::NotRunning, WORDS("A job is running"), WORDS("wait until it has ended, or hold it")},
    {Condition::JobSet, WORDS("No job is selected"), WORDS("select one on the Jobs page")},
    {Condition::NumberingVerified, WORDS("The numbering of variables is not verified"),
        WORDS("compare two variables with the pendant (Variables page)")},
    {Condition::ModelMoves, WORDS("This model takes no move orders"), WORDS("move it with the pendant")},
    {Condition::SafetyChainClosed, WORDS("The safety circuit is open"),
        WORDS("look at emergency stops, doors and the enabling switch")},
    {Condition::NotHeldByPanel, WORDS("Held by a playback panel"), WORDS("release it there")},
    {Condition::HomeConfirmed, WORDS("Home position or position check is missing"),
        WORDS("confirm the position at the pendant")},
    {Condition::StartUnlocked, WORDS("Starting is locked at the panel"),
        WORDS("release the start lock (I/O or panel prohibit) at the cell")},
    {Condition::PanelUnlocked, WORDS("Mode and cycle are locked at the panel"),
        WORDS("release the panel lock (I/O or panel prohibit) at the cell")},
    {Condition::JobSelectPermitted, WORDS("Selecting a job in REMOTE and PLAY is prohibited"),
        WORDS("set “job select when remote and play” to permit: %1")},
    {Condition::MasterCallPermitted, WORDS("Changing the master job is prohibited"),
        WORDS("permit it at the pendant (master call, teach lock): %1")},
    {Condition::JobExists, WORDS("The job is not on the controller"), WORDS("read the list of jobs again")},
    {Condition::NotEditing, WORDS("Something is being edited at the pendant"), WORDS("leave the editor there")},
    {Condition::FilesFree, WORDS("Another function uses the files"), WORDS("try again in a moment")},
    {Condition::DataUnlocked, WORDS("The data are protected"), WORDS("release the protection at the pendant")},
    {Condition::OverwritePermitted, WORDS("Replacing files is not permitted"),
        WORDS("set the parameters RS029 and RS214 to 1: %1")},
};
static_assert(std::size(words) == robot::conditionCount);

/// Where the pendant has it. The names of menus follow the model; a YRC1000micro with a Smart Pendant has its own.
struct Path {
    Condition condition;
    const char *older; ///< DX100 and FS100
    const char *newer; ///< DX200 and YRC1000, YRC1000micro
};

constexpr Path paths[] {
    {Condition::Remote, WORDS("IN/OUT, PSEUDO INPUT SIG, #82015"), WORDS("IN/OUT, PSEUDO INPUT SIG, #82015")},
    {Condition::JobSelectPermitted, WORDS("SETUP, FUNCTION COND. or FUNCTION ENABLE"), WORDS("SETUP, FUNCTION ENABLE")},
    {Condition::MasterCallPermitted, WORDS("SETUP, FUNCTION COND. or TEACHING COND."),
        WORDS("SETUP, FUNCTION ENABLE or TEACHING COND.")},
    {Condition::OverwritePermitted, WORDS("PARAMETER, RS (management mode)"), WORDS("PARAMETER, RS (management mode)")},
};
// clang-format on
#undef WORDS

QString path(Condition condition, protocol::Model model)
{
    using protocol::Model;
    const auto *found = std::ranges::find(paths, condition, &Path::condition);
    if (found == std::end(paths))
        return {};
    const bool isOlder = model == Model::DX100 || model == Model::FS100;
    return Conditions::tr(isOlder ? found->older : found->newer);
}

} // namespace

QString title(Condition condition) { return Conditions::tr(robot::title(condition)); }

QString complaint(Condition condition) { return Conditions::tr(words[std::size_t(condition)].complaint); }

QString remedy(Condition condition, protocol::Model model)
{
    const QString text = Conditions::tr(words[std::size_t(condition)].remedy);
    const QString way = path(condition, model);
    return way.isEmpty() ? text : text.arg(way);
}

QString reason(Condition condition, protocol::Model model)
{
    return Conditions::tr("%1: %2.", "what is wrong: what helps").arg(complaint(condition), remedy(condition, model));
}

QString word(Verdict verdict)
{
    switch (verdict) {
    case Verdict::Met: return Conditions::tr("met");
    case Verdict::NotMet: return Conditions::tr("not met");
    case Verdict::Unread: return Conditions::tr("not read yet");
    case Verdict::Unreadable: return Conditions::tr("cannot be read over HSES");
    }
    return {};
}

QString explain(Act act, const values::Error &error, protocol::Model model)
{
    QStringList sentences {
        Conditions::tr("%1: %2.", "what was tried: how it ended").arg(title(act), protocol::explain(error))};
    if (error.kind == values::ErrorKind::Refused) {
        for (const Condition condition : robot::explanation(act, protocol::effectiveCode(error)))
            sentences << reason(condition, model);
    }
    return sentences.join(u' ');
}

QString title(Act act)
{
    switch (act) {
    case Act::Arm: return Conditions::tr("Arm");
    case Act::ResetAlarm: return Conditions::tr("Reset alarm");
    case Act::CancelError: return Conditions::tr("Cancel error");
    case Act::WriteIo: return Conditions::tr("Write a signal");
    case Act::WriteRegister: return Conditions::tr("Write a register");
    case Act::WriteVariable: return Conditions::tr("Write a variable");
    case Act::SelectJob: return Conditions::tr("Select a job");
    case Act::SelectMasterJob: return Conditions::tr("Select a master job");
    case Act::StartJob: return Conditions::tr("Start the job");
    case Act::Hold: return Conditions::tr("HOLD (software)");
    case Act::ReleaseHold: return Conditions::tr("Release HOLD");
    case Act::ServoOn: return Conditions::tr("Servo on");
    case Act::ServoOff: return Conditions::tr("Servo off");
    case Act::HlockOn: return Conditions::tr("HLOCK on");
    case Act::HlockOff: return Conditions::tr("HLOCK off");
    case Act::SelectCycle: return Conditions::tr("Select the cycle mode");
    case Act::ShowPendantText: return Conditions::tr("Show a message on the pendant");
    case Act::Move: return Conditions::tr("Move");
    case Act::Jog: return Conditions::tr("Jog");
    case Act::Upload: return Conditions::tr("Send a file to the controller");
    case Act::Download: return Conditions::tr("Get a file from the controller");
    case Act::DeleteFile: return Conditions::tr("Delete a file on the controller");
    case Act::Restore: return Conditions::tr("Restore a backup");
    }
    return {};
}

QString title(Level level)
{
    switch (level) {
    case Level::Monitor: return Conditions::tr("Monitor");
    case Level::Operate: return Conditions::tr("Operate");
    case Level::Engineer: return Conditions::tr("Engineer");
    }
    return {};
}

QString reason(Arming::Drop drop)
{
    using Drop = Arming::Drop;
    switch (drop) {
    case Drop::ByHand: return Conditions::tr("disarmed by hand");
    case Drop::Idle: return Conditions::tr("nobody used key or mouse for a minute");
    case Drop::FocusLost: return Conditions::tr("another program came to the front");
    case Drop::ScreenLocked: return Conditions::tr("the screen was locked");
    case Drop::CommunicationLost: return Conditions::tr("communication was lost");
    case Drop::ModeChanged: return Conditions::tr("the mode changed at the controller");
    case Drop::Alarm: return Conditions::tr("an alarm came up");
    case Drop::AccessDropped: return Conditions::tr("the access level fell back");
    case Drop::ProfileChanged: return Conditions::tr("the controller or its profile was changed");
    case Drop::SecondWindow: return Conditions::tr("another window came to the front");
    case Drop::OtherController: return Conditions::tr("another controller was armed");
    }
    return {};
}

} // namespace ui
