// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/codes.h"
#include "robot/conditions.h"
#include <QTest>

using namespace robot;
using values::Status;

namespace {

/// Everything as it must be for a start and for everything else but releasing HOLD.
Situation good()
{
    Situation situation;
    situation.isLinkUp = true;
    situation.level = Level::Engineer;
    situation.isArmed = true;
    situation.status = Status {Status::Data1 {Status::Remote} | Status::Play | Status::OneCycle, Status::ServoOn};
    situation.job = values::ExecutingJob {values::JobName {"WELD_A12"}};
    situation.isNumberingVerified = true;
    return situation;
}

void off(Situation &s, Status::Data1Flag flag) { s.status->data1.setFlag(flag, false); }
void on(Situation &s, Status::Data1Flag flag) { s.status->data1.setFlag(flag); }
void on(Situation &s, Status::Data2Flag flag) { s.status->data2.setFlag(flag); }

/// One way in which something is not as it must be, with the condition that says so where it counts.
struct Deviation {
    char letter;
    const char *name;
    Condition reason;
    void (*apply)(Situation &);
};

constexpr Deviation deviations[] {
    {'.', "as it should be", Condition::LinkUp, [](Situation &) {}},
    {'L', "no link", Condition::LinkUp,
        [](Situation &s) {
            s.isLinkUp = false;
            s.status.reset();
            s.job.reset();
        }},
    {'F', "status stale", Condition::StatusFresh, [](Situation &s) { s.status.reset(); }},
    {'R', "REMOTE off", Condition::Remote, [](Situation &s) { off(s, Status::Remote); }},
    {'P', "neither PLAY nor TEACH", Condition::Play, [](Situation &s) { off(s, Status::Play); }},
    {'T', "TEACH and PLAY", Condition::NotTeach, [](Situation &s) { on(s, Status::Teach); }},
    {'A', "alarm", Condition::NoAlarm, [](Situation &s) { on(s, Status::Alarm); }},
    {'E', "error", Condition::NoError, [](Situation &s) { on(s, Status::Error); }},
    {'p', "held by the pendant", Condition::NotHeldByPendant, [](Situation &s) { on(s, Status::HeldByPendant); }},
    {'x', "held externally", Condition::NotHeldExternally, [](Situation &s) { on(s, Status::HeldExternally); }},
    {'c', "held by a command", Condition::NotHeldByCommand, [](Situation &s) { on(s, Status::HeldByCommand); }},
    {'S', "servo off", Condition::ServoOn, [](Situation &s) { s.status->data2.setFlag(Status::ServoOn, false); }},
    {'r', "running", Condition::NotRunning, [](Situation &s) { on(s, Status::Running); }},
    {'J', "no job selected", Condition::JobSet, [](Situation &s) { s.job->name = {}; }},
    {'j', "job not read", Condition::JobSet, [](Situation &s) { s.job.reset(); }},
    {'N', "numbering unverified", Condition::NumberingVerified, [](Situation &s) { s.isNumberingVerified = false; }},
    {'M', "model without moves", Condition::ModelMoves, [](Situation &s) { s.canModelMove = false; }},
};

/// What reference §10.2 and our own rules say of one act: the level, whether it must be armed, and the letters of the
/// deviations that forbid it.
struct Rule {
    Act act;
    Level level;
    bool armed;
    const char *forbidding;
};

constexpr Rule rules[] {
    {Act::Arm, Level::Operate, false, "LFRPTA"},
    {Act::ResetAlarm, Level::Operate, false, "LR"},
    {Act::WriteIo, Level::Engineer, false, "L"},
    {Act::WriteRegister, Level::Engineer, false, "L"},
    {Act::WriteVariable, Level::Engineer, false, "LN"},
    {Act::SelectJob, Level::Operate, false, "LRr"},
    {Act::SelectMasterJob, Level::Operate, false, "LRr"},
    {Act::StartJob, Level::Operate, true, "LFRPTAEpxcSrJ"},
    {Act::Hold, Level::Monitor, false, ""},
    {Act::ServoOn, Level::Operate, true, "LFRPTAE"},
    {Act::ServoOff, Level::Monitor, false, ""},
    {Act::HlockOn, Level::Engineer, false, "LR"},
    {Act::HlockOff, Level::Monitor, false, "LR"},
    {Act::SelectCycle, Level::Operate, false, "LR"},
    {Act::ShowPendantText, Level::Operate, false, "LR"},
    {Act::Move, Level::Engineer, true, "LFRPTAEpxcSrM"},
    {Act::Jog, Level::Engineer, true, "LFRPTAEpxcSrM"},
    {Act::Upload, Level::Engineer, false, "LR"},
    {Act::Download, Level::Monitor, false, "L"},
    {Act::DeleteFile, Level::Engineer, false, "LR"},
    {Act::Restore, Level::Engineer, false, "LRr"},
};

constexpr Level levels[] {Level::Monitor, Level::Operate, Level::Engineer};

} // namespace

/// "Why not?" as a table: state of the controller × access × act → allowed, or the reason.
class TestConditions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void table_data()
    {
        QTest::addColumn<int>("act");
        QTest::addColumn<Situation>("situation");
        QTest::addColumn<bool>("allowed");
        QTest::addColumn<QList<int>>("reasons"); // all that stands against it, in any order
        for (const Rule &rule : rules) {
            for (const Deviation &deviation : deviations) {
                for (const Level level : levels) {
                    for (const bool isArmed : {false, true})
                        addRow(rule, deviation, level, isArmed);
                }
            }
        }
    }

    void table()
    {
        QFETCH(int, act);
        QFETCH(Situation, situation);
        QFETCH(bool, allowed);
        QFETCH(QList<int>, reasons);
        const auto obstacle = robot::obstacle(Act(act), situation);
        QCOMPARE(!obstacle, allowed);
        QList<int> blocking;
        for (const Finding &finding : findings(Act(act), situation)) {
            if (finding.blocks())
                blocking << int(finding.condition);
        }
        std::ranges::sort(blocking);
        std::ranges::sort(reasons);
        QCOMPARE(blocking, reasons);
        QVERIFY(allowed || reasons.contains(int(*obstacle)));
    }

    void ownRulesComeFirst_data()
    {
        QTest::addColumn<int>("act");
        QTest::addColumn<QList<int>>("order"); // of the first findings, reference §10.2 after our own rules
        const auto row = [](const char *name, Act act, const QList<Condition> &conditions) {
            QList<int> order;
            for (const Condition condition : conditions)
                order << int(condition);
            QTest::newRow(name) << int(act) << order;
        };
        using enum Condition;
        row("start", Act::StartJob,
            {LinkUp, LevelOperate, StatusFresh, Armed, Remote, Play, NotTeach, NoAlarm, NoError, NotHeldByPendant,
                NotHeldExternally, NotHeldByCommand, ServoOn, NotRunning, JobSet});
        row("servo on", Act::ServoOn, {LinkUp, LevelOperate, StatusFresh, Armed, Remote, Play});
        row("select", Act::SelectJob, {LinkUp, LevelOperate, Remote, NotRunning});
    }

    void ownRulesComeFirst()
    {
        QFETCH(int, act);
        QFETCH(QList<int>, order);
        const auto found = findings(Act(act), good());
        QVERIFY(found.size() >= order.size());
        for (qsizetype i = 0; i < order.size(); ++i)
            QCOMPARE(int(found[i].condition), order[i]);
    }

    void stoppingHasNoConditions()
    {
        QVERIFY(findings(Act::Hold, {}).isEmpty());
        QVERIFY(findings(Act::ServoOff, {}).isEmpty());
    }

    void anErrorIsCancelledOnlyWhereThereIsOne()
    {
        Situation situation = good();
        situation.level = Level::Operate;
        QVERIFY(robot::obstacle(Act::CancelError, situation) == Condition::HasError);
        on(situation, Status::Error);
        QVERIFY(!robot::obstacle(Act::CancelError, situation));
        off(situation, Status::Remote);
        QVERIFY(robot::obstacle(Act::CancelError, situation) == Condition::Remote);
    }

    /// HOLD can be released if a command holds, whoever else holds too.
    void releaseHold_data()
    {
        QTest::addColumn<int>("held");
        QTest::addColumn<bool>("allowed");
        QTest::newRow("not held") << 0 << false;
        QTest::newRow("by a command") << int(Status::HeldByCommand) << true;
        QTest::newRow("by the pendant") << int(Status::HeldByPendant) << false;
        QTest::newRow("externally") << int(Status::HeldExternally) << false;
        QTest::newRow("by both") << int(Status::HeldByCommand | Status::HeldByPendant) << true;
    }

    void releaseHold()
    {
        QFETCH(int, held);
        QFETCH(bool, allowed);
        Situation situation = good();
        situation.status->data2 |= Status::Data2 {held};
        QCOMPARE(!obstacle(Act::ReleaseHold, situation), allowed);
        situation.level = Level::Monitor;
        QVERIFY(obstacle(Act::ReleaseHold, situation) == Condition::LevelOperate);
    }

    void whatHsesDoesNotTellIsShownAndDoesNotBlock()
    {
        int unreadable = 0;
        for (const Finding &finding : findings(Act::StartJob, good())) {
            if (finding.verdict != Verdict::Unreadable)
                continue;
            ++unreadable;
            QVERIFY(!finding.isNeeded);
            QVERIFY(!finding.blocks());
        }
        QCOMPARE(unreadable, 3); // panel hold, home, start lock
    }

    void aJobThatWasNotReadDoesNotBlock()
    {
        Situation situation = good();
        situation.job.reset();
        const auto found = findings(Act::StartJob, situation);
        const auto job = std::ranges::find(found, Condition::JobSet, &Finding::condition);
        QVERIFY(job != found.end());
        QVERIFY(job->verdict == Verdict::Unread);
        QVERIFY(!obstacle(Act::StartJob, situation));
    }

    void explains_data()
    {
        QTest::addColumn<int>("act");
        QTest::addColumn<int>("code");
        QTest::addColumn<QList<int>>("conditions");
        const auto row = [](const char *name, Act act, int code, const QList<Condition> &conditions) {
            QList<int> expected;
            for (const Condition condition : conditions)
                expected << int(condition);
            QTest::newRow(name) << int(act) << code << expected;
        };
        using enum Condition;
        row("remote", Act::StartJob, 0x2100, {Remote});
        row("mode of a start", Act::StartJob, 0x2080, {Play, NotTeach});
        row("mode of a selection", Act::SelectJob, 0x2080, {JobSelectPermitted});
        row("alarm", Act::StartJob, 0x2060, {NoAlarm, NoError});
        row("pendant hold", Act::StartJob, 0x2020, {NotHeldByPendant});
        row("panel hold", Act::StartJob, 0x2030, {NotHeldByPanel});
        row("external hold", Act::StartJob, 0x2040, {NotHeldExternally});
        row("command hold", Act::StartJob, 0x2050, {NotHeldByCommand});
        row("servo", Act::StartJob, 0x2070, {ServoOn});
        row("servo first", Act::StartJob, 0x3010, {ServoOn});
        row("running", Act::StartJob, 0x2010, {NotRunning});
        row("no job", Act::StartJob, 0x4060, {JobSet});
        row("home", Act::StartJob, 0x3040, {HomeConfirmed});
        row("start lock", Act::StartJob, 0x3230, {StartUnlocked});
        row("safety chain", Act::ServoOn, 0x3450, {SafetyChainClosed});
        row("no such job", Act::SelectJob, 0x4040, {JobExists});
        row("edited", Act::SelectJob, 0x2130, {NotEditing});
        row("master call", Act::SelectMasterJob, 0x3410, {MasterCallPermitted});
        row("cycle lock", Act::SelectCycle, 0x3220, {PanelUnlocked});
        row("protected data", Act::WriteIo, 0x2110, {DataUnlocked});
        row("files without remote", Act::Upload, 0xE2B2, {Remote});
        row("files busy", Act::Upload, 0xE444, {FilesFree});
        row("no overwriting", Act::Upload, 0xE28C, {OverwritePermitted});
        row("says all itself", Act::WriteVariable, 0xB004, {});
    }

    void explains()
    {
        QFETCH(int, act);
        QFETCH(int, code);
        QFETCH(QList<int>, conditions);
        QVERIFY(protocol::findStatusCode(quint16(code)));
        QList<int> found;
        for (const Condition condition : explanation(Act(act), quint16(code)))
            found << int(condition);
        QCOMPARE(found, conditions);
    }

    /// Rows stand in the order of their enum, and everything has a name of its own.
    void everyRowIsInItsPlace()
    {
        QSet<QByteArray> keys;
        for (int act = 0; act < actCount; ++act)
            keys << key(Act(act));
        QCOMPARE(keys.size(), actCount);
        QCOMPARE(key(Act::StartJob), "start");
        QCOMPARE(key(Act::Restore), "restore");
        QSet<QByteArray> titles;
        for (int condition = 0; condition < conditionCount; ++condition)
            titles << title(Condition(condition));
        QCOMPARE(titles.size(), conditionCount);
        QCOMPARE(title(Condition::LinkUp), "The link to the controller is up");
        QCOMPARE(title(Condition::OverwritePermitted), "Replacing existing files is permitted");
    }

private:
    static void addRow(const Rule &rule, const Deviation &deviation, Level level, bool isArmed)
    {
        Situation situation = good();
        deviation.apply(situation);
        situation.level = level;
        situation.isArmed = isArmed;
        QList<int> reasons;
        const QByteArray forbidding = rule.forbidding;
        if (forbidding.contains(deviation.letter))
            reasons << int(deviation.reason);
        if (deviation.letter == 'L' && forbidding.contains('F'))
            reasons << int(Condition::StatusFresh);
        if (level < rule.level)
            reasons << int(rule.level == Level::Engineer ? Condition::LevelEngineer : Condition::LevelOperate);
        if (rule.armed && !isArmed)
            reasons << int(Condition::Armed);
        QTest::addRow("%s, %s, %s, %s", key(rule.act), deviation.name, key(level), isArmed ? "armed" : "not armed")
            << int(rule.act) << situation << reasons.isEmpty() << reasons;
    }
};

QTEST_GUILESS_MAIN(TestConditions)
#include "tst_conditions.moc"
