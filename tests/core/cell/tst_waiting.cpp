// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cell/waiting.h"

#include <QTest>

using namespace cell;
using namespace std::chrono_literals;
using inform::Wait;

namespace {

inform::Job jobWith(const QByteArray &line)
{
    return inform::parse(
        "/JOB\r\n//NAME T\r\n//POS\r\n///NPOS 0,0,0,0,0,0\r\n//INST\r\n///ATTR SC,RW\r\n///GROUP1 RB1\r\n"
        "///LVARS 2,2,0,0,0,0,0,0\r\nNOP\r\n"
        + line + "\r\nEND\r\n");
}

Waiting waitingFor(const char *line, protocol::Model model = protocol::Model::YRC1000)
{
    return waitingAt(jobWith(line), 1, model);
}

/// "IN#(5)=1 B012=3"
ValueOf valuesIn(const QByteArray &text)
{
    std::map<Subject, double> values;
    for (const QByteArray &pair : text.split(' ')) {
        const auto subject = subjectFromText(QString::fromLatin1(pair.left(pair.indexOf('='))));
        if (subject && pair.contains('='))
            values[*subject] = pair.mid(pair.indexOf('=') + 1).toDouble();
    }
    return [values](const Subject &subject) {
        const auto found = values.find(subject);
        return found == values.end() ? std::nullopt : std::optional {found->second};
    };
}

QString listOf(const QList<Subject> &subjects)
{
    QStringList texts;
    for (const Subject &subject : subjects)
        texts << toString(subject);
    return texts.join(u' ');
}

} // namespace

class TestWaiting : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void linesThatLast_data()
    {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<int>("wait");
        QTest::addColumn<int>("milliseconds"); // -1: no time
        QTest::addColumn<int>("number");
        const auto row = [](const char *line, Wait wait, int milliseconds = -1, int number = 0) {
            QTest::addRow("%s", line) << QByteArray(line) << int(wait) << milliseconds << number;
        };
        row("SET B001 1", Wait::No);
        row("'WAIT IN#(1)=ON", Wait::No);
        row("COMM WAIT IN#(1)=ON", Wait::No);
        row("EDTLCK WAIT IN#(1)=ON", Wait::Condition);
        row("WAIT IN#(5)=ON", Wait::Condition);
        row("WAIT IN#(5)=ON T=10.00", Wait::Condition, 10'000);
        row("WAIT T=2.50", Wait::Time, 2'500);
        row("TIMER T=0.050", Wait::Time, 50);
        row("PWAIT SUB2", Wait::Task, -1, 2);
        row("TSYNC 3", Wait::Tasks, -1, 3);
        row("MOVJ C00000 VJ=10.00", Wait::Motion);
        row("CWAIT", Wait::MotionEnd);
        row("PAUSE", Wait::Person);
    }
    void linesThatLast()
    {
        QFETCH(QByteArray, line);
        const Waiting waiting = waitingFor(line);
        QTEST(int(waiting.wait), "wait");
        QTEST(waiting.time ? int(waiting.time->count()) : -1, "milliseconds");
        QTEST(waiting.number, "number");
    }

    void timesInVariables_data()
    {
        QTest::addColumn<int>("model");
        QTest::addColumn<int>("milliseconds"); // one unit, INFORM reference §5.3
        QTest::addRow("YRC1000") << int(protocol::Model::YRC1000) << 10;
        QTest::addRow("DX200") << int(protocol::Model::DX200) << 10;
        QTest::addRow("FS100") << int(protocol::Model::FS100) << 1;
        QTest::addRow("YRC1000micro") << int(protocol::Model::YRC1000micro) << 1;
    }
    void timesInVariables()
    {
        QFETCH(int, model);
        const Waiting waiting = waitingFor("WAIT IN#(1)=ON T=I012", protocol::Model(model));
        QVERIFY(!waiting.time);
        QCOMPARE(toString(*waiting.timeVariable), QStringLiteral("I012"));
        QTEST(int(waiting.timeUnit.count()), "milliseconds");
    }

    void conditionsAreJudged_data()
    {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QByteArray>("values");
        QTest::addColumn<int>("holds"); // -1: not known
        QTest::addColumn<QString>("needed");
        const auto row = [](const char *line, const char *values, int holds, const char *needed) {
            QTest::addRow("%s with %s", line, values)
                << QByteArray(line) << QByteArray(values) << holds << QString::fromLatin1(needed);
        };
        row("WAIT IN#(5)=ON", "IN#(5)=1", 1, "IN#(5)");
        row("WAIT IN#(5)=ON", "IN#(5)=0", 0, "IN#(5)");
        row("WAIT IN#(5)=ON", "", -1, "IN#(5)");
        row("WAIT IN#(5)<>ON", "IN#(5)=0", 1, "IN#(5)");
        row("WAIT B012=3", "B012=3", 1, "B012");
        row("WAIT B012>=I003", "B012=2 I003=3", 0, "B012 I003");
        row("WAIT D001<-5", "D001=-6", 1, "D001");
        row("WAIT IGH#(1)=5", "IN#(1)=1 IN#(2)=0 IN#(3)=1 IN#(4)=0", 1, "IN#(1) IN#(2) IN#(3) IN#(4)");
        row("WAIT IGH#(1)=5", "IN#(1)=1 IN#(2)=0 IN#(3)=1", -1, "IN#(1) IN#(2) IN#(3) IN#(4)");
        row("WAIT IN#(I010)=ON", "I010=7 IN#(7)=1", 1, "I010 IN#(7)");
        row("WAIT IN#(I010)=ON", "IN#(7)=1", -1, "I010");
        row("WAIT IN#(LI001)=ON", "IN#(7)=1", -1, "");
        row("WAIT LB000=1", "", -1, "");
        row("WAIT S001=\"A\"", "", -1, "");
        row("WAIT FOREXPRESS IN#(1)=OFF ANDEXP IN#(2)=OFF T=1.50", "IN#(1)=0 IN#(2)=1", 0, "IN#(1) IN#(2)");
        row("WAIT FOREXPRESS IN#(1)=OFF ANDEXP IN#(2)=OFF", "IN#(1)=1", 0, "IN#(1) IN#(2)");
        row("WAIT FOREXPRESS IN#(1)=OFF ANDEXP IN#(2)=OFF", "IN#(1)=0", -1, "IN#(1) IN#(2)");
        row("WAIT FOREXPRESS IN#(1)=ON ANDEXP IN#(2)=ON OREXP IN#(3)=ON", "IN#(1)=0 IN#(3)=1", 1,
            "IN#(1) IN#(2) IN#(3)");
        row("WAIT FOREXPRESS IN#(1)=ON OREXP IN#(2)=ON", "IN#(1)=0", -1, "IN#(1) IN#(2)");
        row("WAIT FOREXPRESS IN#(1)=ON OREXP IN#(2)=ON", "IN#(1)=0 IN#(2)=0", 0, "IN#(1) IN#(2)");
        row("MOVL C00001 V=50.0 UNTIL IN#(3)=ON", "IN#(3)=0", 0, "IN#(3)");
    }
    void conditionsAreJudged()
    {
        QFETCH(QByteArray, line);
        QFETCH(QByteArray, values);
        const Waiting waiting = waitingFor(line);
        const ValueOf valueOf = valuesIn(values);
        const auto result = holds(waiting.comparisons, valueOf);
        QTEST(result ? int(*result) : -1, "holds");
        QTEST(listOf(neededFor(waiting, valueOf)), "needed");
    }

    void whatIsNoLineWaitsForNothing()
    {
        const inform::Job job = jobWith("WAIT IN#(1)=ON");
        QVERIFY(!waitingAt(job, -1, protocol::Model::YRC1000).isWaiting());
        QVERIFY(!waitingAt(job, 99, protocol::Model::YRC1000).isWaiting());
    }
};

QTEST_GUILESS_MAIN(TestWaiting)
#include "tst_waiting.moc"
