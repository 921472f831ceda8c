// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cell/comparison.h"
#include "support/samples.h"
#include <QDir>
#include <QTest>

using namespace cell;

class ComparisonTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nextDay_data();
    void nextDay();
    void everythingElseIsTheSame();
    void words_data();
    void words();
    void damagedIsNotDeleted_data();
    void damagedIsNotDeleted();
    void folds();
    void secretsAreNotSaid();
    void knowsTheCell();
};

namespace {

Knowledge knowledge(const QString &folder)
{
    const QDir dir {QStringLiteral(PENDESK_TEST_DATA "/cell/") + folder};
    QByteArrayList names;
    for (const QString &name : dir.entryList(QDir::Files))
        names << name.toLatin1();
    const auto read = [&](const QByteArray &name) -> std::optional<QByteArray> {
        return dir.exists(QString::fromLatin1(name))
            ? std::optional {samples::read(folder + u'/' + QString::fromLatin1(name))}
            : std::nullopt;
    };
    return knowledgeOf(names, read, samples::codec());
}

QStringList texts(const Statements &statements)
{
    QStringList list;
    for (const Statement &statement : statements)
        list << statement.text;
    return list;
}

QStringList compared(const QByteArray &name, const QByteArray &older, const QByteArray &newer)
{
    return texts(statementsOf(name, {older, newer}, knowledge(QStringLiteral("yrc1000")), samples::codec()));
}

} // namespace

/// The same controller on the next day: exactly these differences.
void ComparisonTest::nextDay_data()
{
    QTest::addColumn<QStringList>("sentences");
    QTest::addColumn<bool>("isDifferent");
    QTest::newRow("TOOL.CND") << QStringList {QStringLiteral("Tool 1 “GRIPPER A”: point moved 1.75 mm (Z 163.250 → "
                                                             "165.000); weight 4.200 → 4.250 kg. Used by 1 job(s)."),
        QStringLiteral(
            "Tool 3 “PROBE”: name nothing → PROBE; point moved 101.5 mm (Z 0.000 → 101.500); kind of entry 1 → 2.")}
                              << true;
    QTest::newRow("VAR.DAT") << QStringList {QStringLiteral("B007 “MODE”: 255 → 1."),
        QStringLiteral("I012 “OFFSET X”: -5 → -6."),
        QStringLiteral("P002 “PICK POS”: moved 0.5 mm (X 512.250 → 512.750)."), QStringLiteral("P004: no longer set."),
        QStringLiteral("P006: now set (pulse).")}
                             << true;
    QTest::newRow("IONAME.DAT") << QStringList {QStringLiteral("IN#(2) “PART PRESENT” is now named “PART AT STOP”."),
        QStringLiteral("IN#(17) lost its name “AIR OK”."), QStringLiteral("OUT#(11) is now named “VACUUM ON”.")}
                                << true;
    QTest::newRow("RS.PRM") << QStringList {QStringLiteral(
        "RS022 1 → 0 (numbering of variables for network clients; 1: by their number, 0: by their number plus one).")}
                            << true;
    QTest::newRow("CIOPRG.LST") << QStringList {QStringLiteral(
        "User part, instruction 14: AND #20017 became AND-NOT #20017; decides #00010 “CYCLE START”.")}
                                << true;
    QTest::newRow("FD.PRM") << QStringList {} << false;
    QTest::newRow("SYSTEM.SYS") << QStringList {QStringLiteral("1 h 26 min powered in between.")} << false;
    QTest::newRow("LOGDATA.DAT") << QStringList {QStringLiteral("4 new entry(ies).")} << false;
}

void ComparisonTest::nextDay()
{
    const QByteArray name = QTest::currentDataTag();
    const QString path = QString::fromLatin1(name);
    const Versions versions {
        samples::read(QStringLiteral("yrc1000/") + path), samples::read(QStringLiteral("yrc1000-later/") + path)};
    const Statements statements = statementsOf(name, versions, knowledge(QStringLiteral("yrc1000")), samples::codec());
    QTEST(texts(statements), "sentences");
    QTEST(isDifference(statements), "isDifferent");
    const bool isSafety = name == "TOOL.CND" || name == "RS.PRM" || name == "CIOPRG.LST";
    for (const Statement &statement : statements)
        QCOMPARE(statement.isSafety, isSafety);
}

void ComparisonTest::everythingElseIsTheSame()
{
    const QDir folder {QStringLiteral(PENDESK_TEST_DATA "/cell/yrc1000")};
    const Knowledge known = knowledge(QStringLiteral("yrc1000"));
    for (const QString &name : folder.entryList(QDir::Files)) {
        const QByteArray file = samples::read(QStringLiteral("yrc1000/") + name);
        QByteArray lineFeeds = file;
        lineFeeds.replace("\r\n", "\n");
        QVERIFY2(statementsOf(name.toLatin1(), {file, file}, known, samples::codec()).isEmpty(), qPrintable(name));
        const auto reformatted = statementsOf(name.toLatin1(), {file, lineFeeds}, known, samples::codec());
        QVERIFY2(reformatted.isEmpty(), qPrintable(name + u' ' + texts(reformatted).join(u'\n')));
    }
}

void ComparisonTest::words_data()
{
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("before"); // in the file of the sample
    QTest::addColumn<QByteArray>("after");
    QTest::addColumn<QString>("sentence");
    const auto row = [](const char *name, const char *before, const char *after, const char *sentence) {
        QTest::newRow(sentence) << QByteArray {name} << QByteArray {before} << QByteArray {after}
                                << QString::fromUtf8(sentence);
    };
    row("UFRAME.CND", "100.000,-200.500,0.000,0.0000,0.0000,90.0000", "102.000,-200.500,0.000,0.0000,0.0000,90.1200",
        "User frame 5: moved 2 mm (X 100.000 → 102.000); turned 0.12 deg (Rz 90.0000 → 90.1200). Used by 1 job(s).");
    row("CUBEINTF.CND", "820000,410500", "780000,410500", "Area 1 “PRESS”: upper X 820.000 → 780.000 mm.");
    row("SHOCKLVL.CND", "1,80", "0,80", "Collision detection, set 1, group 1: switched off.");
    row("ABSO.DAT", "1,22100", "1,22104",
        "Home position of R1 axis U recalibrated (22100 → 22104): taught points may be off.");
    row("PSEUDOIN.DAT", "96,0,1", "64,0,1",
        "Pseudo input #87015 switched off. Command remote select: HSES control will be refused.");
    row("SC.PRM", "232107,295253", "163840,295253", "S1C1G800 232107 → 163840 (robot 1 limit S + 170.0 → 120.0 deg).");
    row("CIOPRG.LST", "OUT #30010", "OUT #30017", "Now also written: #30017 “ROBOT READY”.");
    row("CIOPRG.LST", "AIR PRESSURE LOW", "AIR LOW", "ALARM1 9000: AIR PRESSURE LOW → AIR LOW.");
    row("SYSTEM.SYS", "YAS4.50.00A", "YAS4.81.00A", "Software YAS4.50.00A(JP/EN)-00 → YAS4.81.00A(JP/EN)-00.");
    row("SYSTEM.SYS", "00412:33'07", "00400:33'07",
        "The hours of control power went back by 12 h 0 min: another controller, or its memory was cleared.");
    row("WEAV.CND", "3.500,1.000,60.00,30.00,1.500,4.0", "3.500,1.000,60.00,30.00,1.750,4.0",
        "WEAV 2 amplitude mm: value 1.500 → 1.750.");
    row("VARNAME.DAT", "0007 1,0,MODE", "0007 1,0,RECIPE", "B007 “MODE” is now named “RECIPE”.");
    row("UWORD.DAT", "2,RESET", "2,STOP", "UWORD 2: value 2,RESET → 2,STOP.");
}

void ComparisonTest::words()
{
    QFETCH(QByteArray, name);
    QFETCH(QByteArray, before);
    QFETCH(QByteArray, after);
    QFETCH(QString, sentence);
    const QByteArray older = samples::read(QStringLiteral("yrc1000/") + QString::fromLatin1(name));
    QByteArray newer = older;
    QVERIFY(older.contains(before));
    newer.replace(older.indexOf(before), before.size(), after);
    const QStringList found = compared(name, older, newer);
    QVERIFY2(found.contains(sentence), qPrintable(found.join(u'\n')));
}

void ComparisonTest::damagedIsNotDeleted_data()
{
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QString>("damaged");
    QTest::newRow("cut in P002") << QByteArray {"VAR.DAT"} << QStringLiteral("damaged/VAR-cut.DAT");
    QTest::newRow("counts") << QByteArray {"VAR.DAT"} << QStringLiteral("damaged/VAR-badline.DAT");
}

void ComparisonTest::damagedIsNotDeleted()
{
    QFETCH(QByteArray, name);
    QFETCH(QString, damaged);
    const QByteArray older = samples::read(QStringLiteral("yrc1000/") + QString::fromLatin1(name));
    for (const QString &sentence : compared(name, older, samples::read(damaged)))
        QVERIFY2(!sentence.contains(QStringLiteral("no longer")) && !sentence.contains(QStringLiteral("gone")),
            qPrintable(sentence));
    const QStringList empty = compared(name, older, samples::read(QStringLiteral("damaged/EMPTY.DAT")));
    QCOMPARE(empty.size(), 1);
    QVERIFY(empty.first().contains(QStringLiteral("is empty")));
}

void ComparisonTest::folds()
{
    QByteArray older = "//VAR\r\n///PFNUM 6,0,0,0\r\n///SHARE 0,0,1000,0,0,0,0,0\r\n///D\r\n";
    QByteArray newer = older;
    for (int row = 0; row < 100; ++row) {
        older += "0,0,0,0,0,0,0,0,0,0\r\n";
        newer += "1,1,1,1,1,1,1,1,1,1\r\n";
    }
    const QStringList found = compared("VAR.DAT", older, newer);
    QCOMPARE(int(found.size()), mostStatements);
    QCOMPARE(found.last(), QStringLiteral("And 801 more difference(s)."));
}

void ComparisonTest::secretsAreNotSaid()
{
    const QByteArray older = samples::read(QStringLiteral("yrc1000/IPNETCFG.DAT"));
    QByteArray newer = older;
    newer.replace("10.20.30.40", "10.20.30.99").replace("A1B2C3D4", "FFFFFFFF").replace("cellbackup", "other");
    const QStringList found = compared("IPNETCFG.DAT", older, newer);
    QCOMPARE(int(found.size()), 3);
    for (const QString &sentence : found)
        QVERIFY2(sentence.endsWith(QStringLiteral("changed.")) && !sentence.contains(QStringLiteral("10.20")),
            qPrintable(sentence));
    const QByteArray rs = samples::read(QStringLiteral("dx200/RS.PRM"));
    QByteArray moved = rs;
    moved.replace("10,20,30,41", "10,20,30,77");
    QVERIFY(!compared("RS.PRM", rs, moved).first().contains(QStringLiteral("77 ")));
}

void ComparisonTest::knowsTheCell()
{
    const Knowledge known = knowledge(QStringLiteral("yrc1000"));
    QCOMPARE(known.signalText(10), QStringLiteral("IN#(1) “CYCLE START”"));
    QCOMPARE(known.signalText(20010), QStringLiteral("#20010 “PLC HEARTBEAT”"));
    QCOMPARE(known.text({variables::Kind::M, 0}), QStringLiteral("M000 “SPINDLE RPM”"));
    QCOMPARE(known.text({variables::Kind::B, 1}), QStringLiteral("B001"));
    QVERIFY(known.arms[0].isStandard());
    QCOMPARE(known.toolJobs.value(1), 1);
    QCOMPARE(known.frameJobs.value(5), 1);
}

QTEST_APPLESS_MAIN(ComparisonTest)
#include "tst_comparison.moc"
