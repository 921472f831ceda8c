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

struct ConditionWords {
    Condition condition;
    const char *complaint;
    const char *remedy;
};

// One row a condition, in the order of Condition; the titles are the core's.
// clang-format off
constexpr ConditionWords conditionWords[] {
    {Condition::LinkUp, QT_TRANSLATE_NOOP("Conditions", "There is no link to the controller"), QT_TRANSLATE_NOOP("Conditions", "connect, or wait until it answers again")},
    {Condition::LevelOperate, QT_TRANSLATE_NOOP("Conditions", "The access level is Monitor"), QT_TRANSLATE_NOOP("Conditions", "switch to Operate in the strip (Ctrl+L)")},
    {Condition::LevelEngineer, QT_TRANSLATE_NOOP("Conditions", "The access level is not Engineer"),
        QT_TRANSLATE_NOOP("Conditions", "switch to Engineer in the strip (Ctrl+L)")},
    {Condition::StatusFresh, QT_TRANSLATE_NOOP("Conditions", "The status was not read just now"),
        QT_TRANSLATE_NOOP("Conditions", "wait a moment; if it stays so, look at the link")},
    {Condition::Armed, QT_TRANSLATE_NOOP("Conditions", "This controller is not armed"), QT_TRANSLATE_NOOP("Conditions", "arm it on this page")},
    {Condition::Remote, QT_TRANSLATE_NOOP("Conditions", "REMOTE is off"), QT_TRANSLATE_NOOP("Conditions", "turn the pendant key to REMOTE and switch on CMD REMOTE SEL: %1")},
    {Condition::Play, QT_TRANSLATE_NOOP("Conditions", "The mode is not PLAY"), QT_TRANSLATE_NOOP("Conditions", "turn the pendant key to PLAY or REMOTE")},
    {Condition::NotTeach, QT_TRANSLATE_NOOP("Conditions", "The controller is in TEACH"),
        QT_TRANSLATE_NOOP("Conditions", "the person at the pendant has the robot: turn the key to REMOTE when that is over")},
    {Condition::NoAlarm, QT_TRANSLATE_NOOP("Conditions", "There is an alarm"), QT_TRANSLATE_NOOP("Conditions", "remove its cause, then reset it on the Alarms page")},
    {Condition::NoError, QT_TRANSLATE_NOOP("Conditions", "There is an error"), QT_TRANSLATE_NOOP("Conditions", "read it on the Alarms page, then cancel it")},
    {Condition::NotHeldByPendant, QT_TRANSLATE_NOOP("Conditions", "Held by the pendant"), QT_TRANSLATE_NOOP("Conditions", "release it there")},
    {Condition::NotHeldExternally, QT_TRANSLATE_NOOP("Conditions", "Held by an external signal"), QT_TRANSLATE_NOOP("Conditions", "release it where that signal comes from")},
    {Condition::NotHeldByCommand, QT_TRANSLATE_NOOP("Conditions", "Held by a command"), QT_TRANSLATE_NOOP("Conditions", "release HOLD on the Jobs page")},
    {Condition::HeldByCommand, QT_TRANSLATE_NOOP("Conditions", "No command holds the robot"), QT_TRANSLATE_NOOP("Conditions", "there is nothing to release from here")},
    {Condition::HasError, QT_TRANSLATE_NOOP("Conditions", "The controller shows no error"), QT_TRANSLATE_NOOP("Conditions", "there is nothing to cancel")},
    {Condition::ServoOn, QT_TRANSLATE_NOOP("Conditions", "Servo power is off"), QT_TRANSLATE_NOOP("Conditions", "switch servo on")},
    {Condition::NotRunning, QT_TRANSLATE_NOOP("Conditions", "A job is running"), QT_TRANSLATE_NOOP("Conditions", "wait until it has ended, or hold it")},
    {Condition::JobSet, QT_TRANSLATE_NOOP("Conditions", "No job is selected"), QT_TRANSLATE_NOOP("Conditions", "select one on the Jobs page")},
    {Condition::NumberingVerified, QT_TRANSLATE_NOOP("Conditions", "The numbering of variables is not verified"),
        QT_TRANSLATE_NOOP("Conditions", "compare two variables with the pendant (Variables page)")},
    {Condition::ModelMoves, QT_TRANSLATE_NOOP("Conditions", "This model takes no move orders"), QT_TRANSLATE_NOOP("Conditions", "move it with the pendant")},
    {Condition::SafetyChainClosed, QT_TRANSLATE_NOOP("Conditions", "The safety circuit is open"),
        QT_TRANSLATE_NOOP("Conditions", "look at emergency stops, doors and the enabling switch")},
    {Condition::NotHeldByPanel, QT_TRANSLATE_NOOP("Conditions", "Held by a playback panel"), QT_TRANSLATE_NOOP("Conditions", "release it there")},
    {Condition::HomeConfirmed, QT_TRANSLATE_NOOP("Conditions", "Home position or position check is missing"),
        QT_TRANSLATE_NOOP("Conditions", "confirm the position at the pendant")},
    {Condition::StartUnlocked, QT_TRANSLATE_NOOP("Conditions", "Starting is locked at the panel"),
        QT_TRANSLATE_NOOP("Conditions", "release the start lock (I/O or panel prohibit) at the cell")},
    {Condition::PanelUnlocked, QT_TRANSLATE_NOOP("Conditions", "Mode and cycle are locked at the panel"),
        QT_TRANSLATE_NOOP("Conditions", "release the panel lock (I/O or panel prohibit) at the cell")},
    {Condition::JobSelectPermitted, QT_TRANSLATE_NOOP("Conditions", "Selecting a job in REMOTE and PLAY is prohibited"),
        QT_TRANSLATE_NOOP("Conditions", "set “job select when remote and play” to permit: %1")},
    {Condition::MasterCallPermitted, QT_TRANSLATE_NOOP("Conditions", "Changing the master job is prohibited"),
        QT_TRANSLATE_NOOP("Conditions", "permit it at the pendant (master call, teach lock): %1")},
    {Condition::JobExists, QT_TRANSLATE_NOOP("Conditions", "The job is not on the controller"), QT_TRANSLATE_NOOP("Conditions", "read the list of jobs again")},
    {Condition::NotEditing, QT_TRANSLATE_NOOP("Conditions", "Something is being edited at the pendant"), QT_TRANSLATE_NOOP("Conditions", "leave the editor there")},
    {Condition::FilesFree, QT_TRANSLATE_NOOP("Conditions", "Another function uses the files"), QT_TRANSLATE_NOOP("Conditions", "try again in a moment")},
    {Condition::DataUnlocked, QT_TRANSLATE_NOOP("Conditions", "The data are protected"), QT_TRANSLATE_NOOP("Conditions", "release the protection at the pendant")},
    {Condition::OverwritePermitted, QT_TRANSLATE_NOOP("Conditions", "Replacing files is not permitted"),
        QT_TRANSLATE_NOOP("Conditions", "set the parameters RS029 and RS214 to 1: %1")},
};
static_assert(std::size(conditionWords) == robot::conditionCount);

/// Where the pendant has it. The names of menus follow the model; a YRC1000micro with a Smart Pendant has its own.
struct Path {
    Condition condition;
    const char *older; ///< DX100 and FS100
    const char *newer; ///< DX200 and YRC1000, YRC1000micro
};

constexpr Path paths[] {
    {Condition::Remote, QT_TRANSLATE_NOOP("Conditions", "IN/OUT, PSEUDO INPUT SIG, CMD REMOTE SEL (#82015 on a DX100)"), QT_TRANSLATE_NOOP("Conditions", "IN/OUT, PSEUDO INPUT SIG, CMD REMOTE SEL (#82015 on a DX100)")},
    {Condition::JobSelectPermitted, QT_TRANSLATE_NOOP("Conditions", "SETUP, FUNCTION COND. or FUNCTION ENABLE"), QT_TRANSLATE_NOOP("Conditions", "SETUP, FUNCTION ENABLE")},
    {Condition::MasterCallPermitted, QT_TRANSLATE_NOOP("Conditions", "SETUP, FUNCTION COND. or TEACHING COND."),
        QT_TRANSLATE_NOOP("Conditions", "SETUP, FUNCTION ENABLE or TEACHING COND.")},
    {Condition::OverwritePermitted, QT_TRANSLATE_NOOP("Conditions", "PARAMETER, RS (management mode)"), QT_TRANSLATE_NOOP("Conditions", "PARAMETER, RS (management mode)")},
};
// clang-format on

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

QString complaint(Condition condition) { return Conditions::tr(conditionWords[std::size_t(condition)].complaint); }

QString remedy(Condition condition, protocol::Model model)
{
    const QString text = Conditions::tr(conditionWords[std::size_t(condition)].remedy);
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
    case Drop::Disconnected: return Conditions::tr("the connection was closed");
    case Drop::LanguageChanged: return Conditions::tr("the language was changed");
    case Drop::SecondWindow: return Conditions::tr("another window came to the front");
    case Drop::StationLeft: return Conditions::tr("the window was turned to another controller");
    case Drop::OtherController: return Conditions::tr("another controller was armed");
    case Drop::Sleep: return Conditions::tr("the computer went to sleep");
    case Drop::Standstill: return Conditions::tr("this program stood still, or the computer's clock jumped");
    }
    return {};
}

} // namespace ui
