// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/access.h"
#include <QSignalSpy>
#include <QTest>

using namespace std::chrono_literals;
using robot::Access;
using robot::AccessRules;
using robot::Level;
using settings::AccessSettings;
using settings::Passcode;

class TestAccess : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void eachControllerHasItsOwn()
    {
        AccessSettings settings;
        settings.idleTime = 5min;
        AccessRules rules {settings};
        Access one {rules};
        Access other {rules};
        QVERIFY(one.enter(Level::Engineer) == Access::Answer::Entered);
        QVERIFY(other.level() == Level::Monitor);
        QVERIFY(other.enter(Level::Operate) == Access::Answer::Entered);
        const auto begin = values::now();
        rules.noteActivity(begin); // one person, whatever controller they look at
        one.tick(begin + 5min);
        QVERIFY(one.level() == Level::Monitor);
        QVERIFY(other.level() == Level::Operate);
        rules.restrictToMonitor();
        QVERIFY(other.level() == Level::Monitor);
        QVERIFY(one.enter(Level::Operate) == Access::Answer::MonitorOnly);
    }

    void beginsAtMonitor()
    {
        AccessRules rules;
        Access access {rules};
        QVERIFY(access.level() == Level::Monitor);
        QVERIFY(!access.needsPasscode(Level::Engineer));
    }

    void goesUpAndDown()
    {
        AccessRules rules;
        Access access {rules};
        QSignalSpy changes {&access, &Access::levelChanged};
        QVERIFY(access.enter(Level::Engineer) == Access::Answer::Entered);
        QVERIFY(access.level() == Level::Engineer);
        QVERIFY(access.enter(Level::Operate) == Access::Answer::Entered);
        QVERIFY(access.enter(Level::Operate) == Access::Answer::Entered);
        QCOMPARE(changes.count(), 2);
    }

    void fallsBackWhenIdle()
    {
        AccessSettings settings;
        settings.idleTime = 5min;
        AccessRules rules {settings};
        Access access {rules};
        QVERIFY(access.enter(Level::Operate) == Access::Answer::Entered);
        const auto begin = values::now();
        rules.noteActivity(begin);
        access.tick(begin + 4min);
        QVERIFY(access.level() == Level::Operate);
        rules.noteActivity(begin + 4min);
        access.tick(begin + 9min - 1ms);
        QVERIFY(access.level() == Level::Operate);
        QSignalSpy changes {&access, &Access::levelChanged};
        access.tick(begin + 9min);
        QVERIFY(access.level() == Level::Monitor);
        QCOMPARE(changes.count(), 1);
    }

    void thePasscodeIsAskedOnTheWayUp()
    {
        AccessSettings settings;
        settings.passcode = Passcode::of(QStringLiteral("forty-two"), 1000);
        AccessRules rules {settings};
        Access access {rules};
        const auto enter = [&access](Level level, const QString &text) {
            std::optional<Access::Answer> answer;
            access.enter(level, text, &access, [&](Access::Answer given) { answer = given; });
            [&] { QTRY_VERIFY_WITH_TIMEOUT(answer, 60'000); }();
            return answer;
        };
        QVERIFY(access.needsPasscode(Level::Operate));
        QVERIFY(access.enter(Level::Operate) == Access::Answer::WrongPasscode);
        QVERIFY(enter(Level::Operate, QStringLiteral("Forty-two")) == Access::Answer::WrongPasscode);
        QVERIFY(access.level() == Level::Monitor);
        QSignalSpy changed {&rules, &AccessRules::settingsChanged};
        QVERIFY(enter(Level::Engineer, QStringLiteral("forty-two")) == Access::Answer::Entered);
        QCOMPARE(changed.size(), 1); // it had too few iterations and was made anew
        QVERIFY(!rules.settings().passcode->isOutdated());
        QVERIFY(!access.needsPasscode(Level::Operate));
        QVERIFY(access.enter(Level::Operate) == Access::Answer::Entered);
        QVERIFY(access.needsPasscode(Level::Engineer));
        QVERIFY(access.enter(Level::Monitor) == Access::Answer::Entered);
    }

    void monitorOnlyHasNoOtherLevel()
    {
        AccessRules rules;
        Access access {rules};
        QVERIFY(access.enter(Level::Engineer) == Access::Answer::Entered);
        rules.restrictToMonitor();
        QVERIFY(access.level() == Level::Monitor);
        QVERIFY(access.enter(Level::Operate) == Access::Answer::MonitorOnly);
        QVERIFY(access.level() == Level::Monitor);
    }
};

QTEST_GUILESS_MAIN(TestAccess)
#include "tst_access.moc"
