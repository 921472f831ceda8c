// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/conditionwords.h"
#include <QTest>

using robot::Act;
using robot::Condition;
using values::ErrorKind;

class TestConditionWords : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyConditionHasWords()
    {
        for (int i = 0; i < robot::conditionCount; ++i) {
            for (const protocol::Model model : protocol::allModels) {
                const auto condition = Condition(i);
                QVERIFY(!ui::title(condition).isEmpty());
                QVERIFY(!ui::complaint(condition).isEmpty());
                QVERIFY(ui::complaint(condition) != ui::title(condition));
                QVERIFY(!ui::remedy(condition, model).isEmpty());
                QVERIFY2(!ui::reason(condition, model).contains(u'%'), qPrintable(ui::reason(condition, model)));
            }
        }
        QCOMPARE(ui::complaint(Condition::LinkUp), QStringLiteral("There is no link to the controller"));
        QCOMPARE(ui::complaint(Condition::OverwritePermitted), QStringLiteral("Replacing files is not permitted"));
    }

    void everyActHasATitleOfItsOwn()
    {
        QSet<QString> titles;
        for (int act = 0; act < robot::actCount; ++act)
            titles << ui::title(Act(act));
        QCOMPARE(titles.size(), robot::actCount);
        QVERIFY(!titles.contains(QString()));
    }

    void aRefusalIsExplained_data()
    {
        QTest::addColumn<int>("act");
        QTest::addColumn<quint16>("code");
        QTest::addColumn<QString>("part");
        QTest::newRow("code in words") << int(Act::StartJob) << quint16(0x2070) << QStringLiteral("0x2070");
        QTest::newRow("servo") << int(Act::StartJob) << quint16(0x2070) << QStringLiteral("Servo power is off");
        QTest::newRow("remote") << int(Act::SelectCycle) << quint16(0x2100) << QStringLiteral("#82015");
        QTest::newRow("select") << int(Act::SelectJob) << quint16(0x2080) << QStringLiteral("remote and play");
        QTest::newRow("unlisted code") << int(Act::SelectJob) << quint16(0x7777) << QStringLiteral("0x7777");
    }

    void aRefusalIsExplained()
    {
        QFETCH(int, act);
        QFETCH(quint16, code);
        QFETCH(QString, part);
        const values::Error refusal {ErrorKind::Refused, 0x1F, code, {}};
        const QString text = ui::explain(Act(act), refusal, protocol::Model::YRC1000);
        QVERIFY2(text.contains(part), qPrintable(text));
    }

    void anUnknownOutcomeIsNeverCalledFailed()
    {
        const QString text = ui::explain(Act::StartJob, {ErrorKind::UnknownOutcome, 0, 0, {}}, protocol::Model::DX100);
        QVERIFY(!text.contains(QStringLiteral("fail"), Qt::CaseInsensitive));
        QVERIFY(text.contains(QStringLiteral("look at the robot")));
    }
};

QTEST_MAIN(TestConditionWords)
#include "tst_conditionwords.moc"
