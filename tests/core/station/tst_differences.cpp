// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "station/differences.h"
#include "support/samples.h"
#include <QTest>

using namespace station;
using files::Change;
using values::FileName;

class DifferencesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void counts_data();
    void counts();
    void allParametersRepeat();
    void safetyComesFirst();
};

namespace {

using Contents = std::map<FileName, QByteArray>;

FileName fileName(const QByteArray &name) { return *FileName::create(name); }

QByteArray sample(const QByteArray &name)
{
    return samples::read(QStringLiteral("yrc1000/") + QString::fromLatin1(name));
}

QList<FileDifference> differences(const Contents &older, const Contents &newer)
{
    return differencesOf(files::fileSetOf(older), files::fileSetOf(newer), files::NoiseFilter {}, samples::codec());
}

} // namespace

/// One replacement in one file: is it a difference?
void DifferencesTest::counts_data()
{
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<QByteArray>("after");
    QTest::addColumn<bool>("counts");
    const auto row = [](const char *name, const char *before, const char *after, bool counts) {
        QTest::addRow("%s %s", name, after) << QByteArray {name} << QByteArray {before} << QByteArray {after} << counts;
    };
    row("FD.PRM", "9C41D0E27A3B5F18", "02B7715E90AC4416", false);
    row("SYSTEM.SYS", "2024/03/05 15:00:12", "2024/03/06 09:30:00", false);
    row("SYSTEM.SYS", "YAS4.50.00A", "YAS4.81.00A", true);
    row("PANELBOX.LOG", "00412:33'07", "00413:33'07", false);
    row("PANELBOX.LOG", "RELATIVE JOB                    NOT USED", "RELATIVE JOB                    USED    ", true);
    row("VAR.DAT", "PART-0042", "2024/01/31", true);
    row("VAR.DAT", "PART-0042", "PART-0042  ", true); // blanks in a string are part of it
    row("PMTMMNG.DAT", "129570000", "129560000", false);
    row("LOGDATA.DAT", "HOLD", "DONE", false);
    row("CRCMON.DAT", "2864434397", "2864434398", false);
    row("TOOL.CND", "4.200", "4.250", true);
    row("UWORD.DAT", "\r\n", "\n", false);
}

void DifferencesTest::counts()
{
    QFETCH(QByteArray, name);
    QFETCH(QByteArray, before);
    QFETCH(QByteArray, after);
    const QByteArray older = sample(name);
    QVERIFY(older.contains(before));
    const auto found =
        differences({{fileName(name), older}}, {{fileName(name), QByteArray {older}.replace(before, after)}});
    QCOMPARE(found.size(), 1);
    QTEST(found.first().counts(), "counts");
}

void DifferencesTest::allParametersRepeat()
{
    Contents older;
    for (const char *name : {"ALL.PRM", "RC.PRM", "RS.PRM"})
        older[fileName(name)] = sample(name);
    Contents newer = older;
    for (const char *name : {"ALL.PRM", "RS.PRM"})
        newer[fileName(name)].replace("0,0,1,0,0,0,0,0,0,1", "0,0,0,0,0,0,0,0,0,1");
    const auto found = differences(older, newer);
    QCOMPARE(int(std::ranges::count_if(found, &FileDifference::counts)), 1);
    QCOMPARE(found.first().name, fileName("RS.PRM"));
    // A backup that left it out has not lost it.
    newer = older;
    newer.erase(fileName("ALL.PRM"));
    QVERIFY(std::ranges::none_of(differences(older, newer), &FileDifference::counts));
}

void DifferencesTest::safetyComesFirst()
{
    const Contents older {{fileName("IONAME.DAT"), sample("IONAME.DAT")},
        {fileName("LOGDATA.DAT"), sample("LOGDATA.DAT")}, {fileName("TOOL.CND"), sample("TOOL.CND")}};
    const auto later = [](const char *name) {
        return samples::read(QStringLiteral("yrc1000-later/") + QString::fromLatin1(name));
    };
    const Contents newer {{fileName("IONAME.DAT"), later("IONAME.DAT")},
        {fileName("LOGDATA.DAT"), later("LOGDATA.DAT")}, {fileName("TOOL.CND"), later("TOOL.CND")},
        {fileName("PMLOG.DAT"), "//PMLOG\r\n"}};
    const auto found = differences(older, newer);
    QCOMPARE(found.size(), 4);
    QCOMPARE(found[0].name, fileName("TOOL.CND"));
    QVERIFY(found[0].isSafety() && !found[1].isSafety());
    QCOMPARE(foldedCount(found, cellfiles::FileClass::Log), 1);
    QCOMPARE(foldedCount(found, cellfiles::FileClass::Counter), 1);
}

QTEST_APPLESS_MAIN(DifferencesTest)
#include "tst_differences.moc"
