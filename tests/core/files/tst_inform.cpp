// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/inform.h"

#include <QDir>
#include <QFile>
#include <QTest>
#include <random>

using namespace files;

namespace {

const QByteArray sample =
    "/JOB\r\n//NAME A12\r\n//POS\r\n///NPOS 2,0,0,1,0,0\r\n///TOOL 0\r\n///POSTYPE PULSE\r\n"
    "///PULSE\r\nC00000=1,-2,3,4,5,6\r\nC00001=1,-2,3,4,5,7\r\n///POSTYPE USER\r\n///USER 3\r\n"
    "///RECTAN\r\nP00012=1.000,2.000,3.500,180.0000,0.0000,-1.2500\r\n//INST\r\n"
    "///DATE 2026/01/31 08:30\r\n///COMM N\x83\x65\r\n///ATTR SC,RW\r\n///GROUP1 RB1\r\nNOP\r\n*L1\r\n"
    "'CALL JOB:NO\r\n  MOVJ C00000 VJ=5.00\r\nCALL JOB:SUB IF IN#(1)=ON\r\nJUMP *L1\r\nEND\r\n";

} // namespace

/// Jobs are read, and every byte of any file is kept.
class TestInform : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsAJob();
    void keepsEveryByte_data();
    void keepsEveryByte();
    void keepsRandomBytes();
    void knowsLineKinds_data();
    void knowsLineKinds();
    void countsAnnouncedPositions_data();
    void countsAnnouncedPositions();
};

void TestInform::readsAJob()
{
    const Job job = parseJob(sample);
    QVERIFY(job.isJob);
    QCOMPARE(job.name, "A12");
    QCOMPARE(job.comment, "N\x83\x65");
    QCOMPARE(job.date, "2026/01/31 08:30");
    QCOMPARE(job.attributes, (QByteArrayList {"SC", "RW"}));
    QCOMPARE(job.groups, QByteArrayList {"RB1"});
    QCOMPARE(job.announcedPositions, 3);
    QCOMPARE(job.positions.size(), 3);
    QVERIFY(job.positions[0].isPulse());
    QCOMPARE(job.positions[0].userFrame, "");
    const TaughtPosition expected {
        "P00012", "USER", "0", "3", {"1.000", "2.000", "3.500", "180.0000", "0.0000", "-1.2500"}, 12};
    QVERIFY(job.positions[2] == expected);
    QCOMPARE(job.instructions.size(), 7);
    QCOMPARE(job.instruction(0), "NOP");
    QCOMPARE(job.instruction(3), "MOVJ C00000 VJ=5.00");
    QVERIFY((job.labels() == QList<Mark> {{"L1", 1}}));
    QVERIFY((job.calls() == QList<Mark> {{"SUB", 4}}));
}

void TestInform::keepsEveryByte_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addRow("sample") << sample;
    QTest::addRow("LF") << QByteArray(sample).replace("\r\n", "\n");
    QTest::addRow("no final newline") << sample.chopped(2);
    QTest::addRow("half a final newline") << sample.chopped(1);
    QTest::addRow("CR alone") << QByteArray(sample).replace("\r\n", "\r");
    QTest::addRow("mixed") << QByteArray("NOP\n\r\n\r\r\n\n\n\rEND");
    QTest::addRow("undecodable") << QByteArray("/JOB\r\n//NAME \xFF\xFE\x80\x00\r\n\x8A\r\n", 22);
    QTest::addRow("empty") << QByteArray();
    QTest::addRow("one newline") << QByteArray("\n");
    const QDir demo {QStringLiteral(":/demo")};
    for (const QString &name : demo.entryList()) {
        QFile file {demo.filePath(name)};
        QVERIFY(file.open(QIODevice::ReadOnly));
        QTest::addRow("%s", qPrintable(name)) << file.readAll();
    }
}

void TestInform::keepsEveryByte()
{
    QFETCH(QByteArray, content);
    QCOMPARE(print(parseJob(content)), content);
}

void TestInform::keepsRandomBytes()
{
    std::mt19937 random {9};
    const QByteArray alphabet {"\r\n\n /*'=,:CPNOJB\xFF\x8A\0", 21};
    for (int run = 0; run < 2000; ++run) {
        QByteArray content;
        while (random() % 60 != 0)
            content += alphabet[qsizetype(random() % 21)];
        QCOMPARE(print(parseJob(content)), content);
        QCOMPARE(print(parseJob("/JOB\n//POS\n" + content)), "/JOB\n//POS\n" + content);
        QCOMPARE(print(parseJob("//INST\n" + content)), "//INST\n" + content);
    }
}

void TestInform::knowsLineKinds_data()
{
    QTest::addColumn<int>("index");
    QTest::addColumn<int>("kind");
    QTest::addRow("text before the sections") << 0 << int(LineKind::Foreign);
    QTest::addRow("header") << 1 << int(LineKind::Header);
    QTest::addRow("position") << 2 << int(LineKind::Position);
    QTest::addRow("no position") << 3 << int(LineKind::Foreign);
    QTest::addRow("label") << 5 << int(LineKind::Label);
    QTest::addRow("comment") << 6 << int(LineKind::Comment);
    QTest::addRow("blank") << 7 << int(LineKind::Blank);
    QTest::addRow("instruction") << 8 << int(LineKind::Instruction);
}

void TestInform::knowsLineKinds()
{
    QFETCH(int, index);
    QFETCH(int, kind);
    const Job job = parseJob("HELLO\n//POS\nC00000=1\n=1\n//INST\n*L\n'C\n \nNOP\n");
    QCOMPARE(int(job.lines[index].kind), kind);
    QVERIFY(!job.isJob);
}

void TestInform::countsAnnouncedPositions_data()
{
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<int>("count"); // -1: unknown
    QTest::addRow("six") << QByteArray("///NPOS 1,2,3,4,5,6") << 21;
    QTest::addRow("blanks") << QByteArray("///NPOS 1, 2") << 3;
    QTest::addRow("one") << QByteArray("///NPOS 7") << 7;
    QTest::addRow("no number") << QByteArray("///NPOS 1,x") << -1;
    QTest::addRow("negative") << QByteArray("///NPOS -1") << -1;
    QTest::addRow("nothing") << QByteArray("///NPOS") << -1;
    QTest::addRow("missing") << QByteArray("///TOOL 0") << -1;
}

void TestInform::countsAnnouncedPositions()
{
    QFETCH(QByteArray, line);
    QFETCH(int, count);
    QCOMPARE(parseJob("/JOB\r\n" + line + "\r\n").announcedPositions.value_or(-1), count);
}

QTEST_GUILESS_MAIN(TestInform)

#include "tst_inform.moc"
