// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/jobtext.h"
#include <QTest>

using robot::JobMark;
using robot::JobText;
using robot::parseJobText;

class TestJobText : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsAJob()
    {
        const JobText job = parseJobText("/JOB\r\n//NAME WELD\r\n//POS\r\n///NPOS 0,0,0,0,0,0\r\n//INST\r\n"
                                         "///DATE 2026/01/12 08:30\r\n///COMM FRONT PANEL\r\n///ATTR SC,RW\r\n"
                                         "///GROUP1 RB1\r\nNOP\r\n*NEXT\r\n'JOB:NOT THIS\r\nCALL JOB:CLAMP\r\n"
                                         "CALL JOB:TIP IF B000>=20\r\nJUMP *NEXT IF B001<3\r\nEND\r\n");
        QCOMPARE(job.name, QByteArray("WELD"));
        QCOMPARE(job.comment, QByteArray("FRONT PANEL"));
        QCOMPARE(job.date, QByteArray("2026/01/12 08:30"));
        QCOMPARE(job.lines.size(), 7);
        QCOMPARE(job.lines.first(), QByteArray("NOP"));
        QCOMPARE(job.lines.last(), QByteArray("END"));
        const QList<JobMark> marks {{JobMark::Kind::Label, 1, "*NEXT"}, {JobMark::Kind::Call, 3, "JOB:CLAMP"},
            {JobMark::Kind::Call, 4, "JOB:TIP"}};
        QVERIFY(job.marks == marks);
    }

    void badJobs_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("lines");
        QTest::newRow("nothing") << QByteArray() << 0;
        QTest::newRow("no NOP") << QByteArray("/JOB\r\n//NAME A\r\n//INST\r\nMOVJ C0 VJ=1\r\nEND\r\n") << 0;
        QTest::newRow("no END") << QByteArray("NOP\r\nDOUT OT#(1) ON") << 2;
        QTest::newRow("LF alone") << QByteArray("NOP\nEND\n") << 2;
        QTest::newRow("after END") << QByteArray("NOP\r\nEND\r\nNOP\r\n") << 2;
        QTest::newRow("empty line inside") << QByteArray("NOP\r\n\r\nEND\r\n") << 3;
        QTest::newRow("not text") << QByteArray("\0\xff\x80\n", 4) << 0;
        QTest::newRow("CALL of nothing") << QByteArray("NOP\r\nCALL \r\nEND\r\n") << 3;
    }

    void badJobs()
    {
        QFETCH(QByteArray, text);
        QFETCH(int, lines);
        const JobText job = parseJobText(text);
        QCOMPARE(job.lines.size(), lines);
        QVERIFY(job.marks.isEmpty());
    }
};

QTEST_GUILESS_MAIN(TestJobText)
#include "tst_jobtext.moc"
