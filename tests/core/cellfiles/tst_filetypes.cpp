// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cellfiles/filetypes.h"
#include "support/samples.h"
#include <QDirIterator>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

using namespace cellfiles;

class FileTypesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void knowsTypes_data();
    void knowsTypes();
    void cells_data();
    void cells();
    void everySampleHasAView();
    void secretsAreMasked();
    void bytesStayBytes();
};

void FileTypesTest::knowsTypes_data()
{
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("pattern");
    QTest::addColumn<int>("fileClass");
    QTest::addColumn<int>("restore");
    QTest::addColumn<bool>("isSafety");
    const auto row = [](const char *name, const char *pattern, FileClass fileClass, Restore restore, bool isSafety) {
        QTest::newRow(name) << QByteArray {name} << QByteArray {pattern} << int(fileClass) << int(restore) << isSafety;
    };
    row("MAIN.JBI", "*.JBI", FileClass::Configuration, Restore::Allowed, false);
    row("tool.cnd", "TOOL.CND", FileClass::Configuration, Restore::Care, true);
    row("VAR.DAT", "VAR.DAT", FileClass::Data, Restore::Allowed, false);
    row("VARNAME.DAT", "VARNAME.DAT", FileClass::Configuration, Restore::Allowed, false);
    row("S1C.PRM", "*.PRM", FileClass::Configuration, Restore::Never, true);
    row("ABSO.DAT", "ABSO.DAT", FileClass::Configuration, Restore::Never, true);
    row("HOME2.DAT", "HOME2.DAT", FileClass::Configuration, Restore::Never, true);
    row("OPEORG.DAT", "OPEORG.DAT", FileClass::Configuration, Restore::Never, true);
    row("RBCALIB.DAT", "RBCALIB.DAT", FileClass::Configuration, Restore::Never, true);
    row("CIOPRG.LST", "CIOPRG.LST", FileClass::Configuration, Restore::Never, true);
    row("IPNETCFG.DAT", "IPNETCFG.DAT", FileClass::Configuration, Restore::Never, false);
    row("SPDLMT.DAT", "SPDLMT.DAT", FileClass::Configuration, Restore::Never, true);
    row("LOGDATA.DAT", "LOGDATA.DAT", FileClass::Log, Restore::Never, false);
    row("ALMHIST.DAT", "ALMHIST.DAT", FileClass::Log, Restore::Never, false);
    row("PMHARD.DAT", "PMHARD.DAT", FileClass::Counter, Restore::Never, false);
    row("CMOS.BIN", "*.BIN", FileClass::Configuration, Restore::Never, false);
    row("USRGRPOT.DAT", "USRGRP*.DAT", FileClass::Configuration, Restore::Allowed, false);
    row("CNVYR.CND", "*", FileClass::Configuration, Restore::Care, false);
}

void FileTypesTest::knowsTypes()
{
    QFETCH(QByteArray, name);
    const FileType &type = fileTypeOf(name);
    QTEST(QByteArray {type.pattern}, "pattern");
    QTEST(int(type.fileClass), "fileClass");
    QTEST(int(type.restore), "restore");
    QTEST(type.isSafety, "isSafety");
}

void FileTypesTest::cells_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QStringList>("row"); // some row of a table begins with these cells
    const auto row = [](const char *path, const QStringList &cells) {
        QTest::newRow(path + QByteArray {" "} + cells.join(u' ').toUtf8()) << QString::fromLatin1(path) << cells;
    };
    const auto text = [](const char *value) { return QString::fromUtf8(value); };
    row("yrc1000/WEAV.CND", {text("WEAV 2"), text("form"), text("1")});
    row("yrc1000/WEAV.CND", {text("WEAV 2"), text("flags"), text("10100000")});
    row("yrc1000/WEAV.CND", {text("WEAV 2"), text("angle deg"), text("60.00")});
    row("yrc1000/WEAV.CND", {text("WEAV 2"), text("amplitude mm"), text("1.500")});
    row("yrc1000/WEAV.CND", {text("WEAV 2"), text("frequency Hz"), text("4.0")});
    row("yrc1000/WEAV.CND", {text("WEAV 255"), text("form"), text("0")});
    row("dx200/WEAV.CND", {text("WEAV 2"), text("5"), text("0,0.0,0")});
    row("yrc1000/SHOCKLVL.CND", {text("1"), text("1"), text("1"), text("80")});
    row("yrc1000/SHOCKLVL.CND", {text("2"), text("1"), text("1"), text("100")});
    row("yrc1000/SHOCKLVL.CND", {text("9"), text("1"), text("0"), text("0")});
    row("yrc1000/FORMCUT.CND", {text("FORMCUT 1"), text("diameter mm"), text("7.500")});
    row("yrc1000/USRGRPIN.DAT", {text("USRGRPIN 2"), text("NAME"), text("RECIPE NO")});
    row("yrc1000/USRGRPIN.DAT", {text("USRGRPIN 2"), text("bits"), text("8")});
    row("yrc1000/USRGRPOT.DAT", {text("USRGRPOT 2"), text("first"), text("17")});
    row("yrc1000/UWORD.DAT", {text("UWORD"), text("2"), text("2,RESET")});
    row("yrc1000/RBSTPFCT.DAT", {text("1"), text("2024/03/05 14:22:07"), text("HOLD")});
    row("yrc1000/RBSTPFCT.DAT",
        {text("2"), text("2024/03/05 14:00:58"), text("PP ENABLE SWITCH, CONTACTOR OR STO OFF1 SV#1")});
    row("yrc1000/IOMSGHST.DAT", {text("IOMSGHST"), text("1"), text("1000")});
    row("yrc1000/CRCMON.DAT",
        {text("CRCMON"), text("MONCRC 5"), text("TOOL,0,1992/00/00 00:00:00,2864434397,2024/03/05 14:18:02")});
    row("yrc1000/PMTMMNG.DAT", {text("PMTMMNG"), text("REDUCER 2"), text("129600000,129570000,0,0,0,0,0,0,0,0")});
    row("yrc1000/RBCALIB.DAT",
        {text("RBCALIB 1"), text("SRANG"), text("1850.250,12.500,-3.750,0.0500,-0.2500,90.5000")});
    row("yrc1000/EIOALLOC.DAT", {text("EIOALLOC"), text("INPUT 2"), text("0,6,15,0,254,0,0,16,Ethernet/IP CPU")});
    row("yrc1000/IFPANEL.DAT", {text("IFPANEL_EX 15"), text("NAME")});
    row("yrc1000/TMVAR.DAT", {text("TMVAR"), text("TF 1"), text("1,1,1,1,1,1,1,1,1,1,")});
    row("yrc1000-fsu/SPDLMT.DAT", {text("SPDLMT 1"), text("COMMENT"), text("TEACH CELL")});
    row("yrc1000-fsu/SPDLMT.DAT", {text("SPDLMT 1"), text("speed mm/s"), text("250.0")});
    row("dx200/WELDER.DAT", {text("WELDER 8"), text("NAME"), text("1,DEMOWELD 350")});
    row("dx200/ARCSRT.CND", {text("ARCSRT EN 1"), text("current 1"), text("185")});
    row("dx200/ARCSRT.CND", {text("ARCSRT EN 1"), text("speed"), text("11.5")});
    row("dx200/ARCEND.CND", {text("ARCEND EN 5"), text("COMMENT"), text("CRATER")});
    row("dx200/ARCEND.CND", {text("ARCEND EN 1"), text("current 1"), text("145")});
    row("dx100/MACRO.DAT", {text("MACRO1 1"), text("JOB1"), text("GRIP_CLOSE")});
    row("dx100/MACRO.DAT", {text("MACRO1 1"), text("COMMENT1 1"), text("FORCE")});
    row("dx100/USRIOVAR.DAT", {text("USRIOVAR"), text("2"), text("#00250,")});
    row("yrc1000/TOOL.CND", {text("1"), text("GRIPPER A"), text("0.000"), text("12.500"), text("163.250")});
    row("yrc1000/VAR.DAT", {text("P000"), text("pulse"), text("1"), text(""), text("000000"), text("41000")});
    row("yrc1000/VAR.DAT", {text("S002"), text("A,B \"Q\" 100%")});
    row("yrc1000/RS.PRM", {text("RS022"), text("1")});
    row("yrc1000/CIOPRG.LST", {text("14"), text("2"), text("AND #20017")});
    row("yrc1000/CIOPRG.LST", {text("ALARM1"), text("9127"), text("GRIPPER NOT REFERENCED")});
    row("damaged/VAR-realforms.DAT", {text("R002"), text("3.402823E+38")}); // known by its first header
    row("yrc1000/PANELBOX.LOG", {text("26"), text("PARALLEL START INSTRUCTION"), text("7")});
}

void FileTypesTest::cells()
{
    QFETCH(QString, path);
    QFETCH(QStringList, row);
    const QByteArray file = samples::read(path);
    const View view = viewOf(path.section(u'/', -1).toLatin1(), file, samples::codec());
    QCOMPARE(view.warnings.count(), 0);
    const bool isThere = std::ranges::any_of(view.tables, [&](const Table &table) {
        return std::ranges::any_of(table.rows, [&](const Row &found) { return found.cells.mid(0, row.size()) == row; });
    });
    QVERIFY(isThere);
}

void FileTypesTest::everySampleHasAView()
{
    QDirIterator files {QStringLiteral(PENDESK_TEST_DATA "/cell"), QDir::Files, QDirIterator::Subdirectories};
    int count = 0;
    while (files.hasNext()) {
        const QString path = files.next();
        if (path.endsWith(QStringLiteral(".gitattributes")))
            continue;
        QFile file {path};
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray content = file.readAll();
        const View view = viewOf(path.section(u'/', -1).toLatin1(), content, samples::codec());
        QVERIFY2(!view.tables.isEmpty(), qPrintable(path));
        for (const Table &table : view.tables) {
            for (const Row &row : table.rows)
                QVERIFY2(row.cells.size() <= table.columns.size(), qPrintable(path));
        }
        QVERIFY(!QJsonDocument {toJson(view)}.toJson().isEmpty());
        ++count;
    }
    QVERIFY(count > 100);
}

void FileTypesTest::secretsAreMasked()
{
    const QByteArray file = samples::read(QStringLiteral("yrc1000/IPNETCFG.DAT"));
    const QByteArray json = QJsonDocument {toJson(viewOf("IPNETCFG.DAT", file, samples::codec()))}.toJson();
    for (const char *secret : {"10.20.30.40", "10.20.30.1", "02:00:00:00:00:01", "cellbackup", "A1B2C3D4", "5E6F5E6F"})
        QVERIFY2(!json.contains(secret), secret);
    QVERIFY(json.contains("MY-HOST"));
    const QByteArray rs = samples::read(QStringLiteral("dx200/RS.PRM"));
    const View view = viewOf("RS.PRM", rs, samples::codec());
    for (const Row &row : view.tables.first().rows) {
        if (row.cells.first() == u"RS073")
            QCOMPARE(shownCells(view.tables.first(), row)[1], mask());
    }
}

void FileTypesTest::bytesStayBytes()
{
    const QByteArray image("$$NX.CMOSTYPE\x01\x02\x03", 16);
    QVERIFY(!isText(image));
    QVERIFY(viewOf("CMOS.BIN", image, samples::codec()).tables.isEmpty());
    QVERIFY(viewOf("ODD.DAT", image, samples::codec()).tables.isEmpty());
    const View unknown = viewOf("ODD.DAT", "//ODD 1\r\n///PART A\r\n1,2\r\n", samples::codec());
    QCOMPARE(unknown.tables.first().rows.size(), 2);
    QCOMPARE(unknown.tables.first().rows[1].cells,
        (QStringList {QStringLiteral("ODD 1"), QStringLiteral("PART 1"), QStringLiteral("1,2")}));
}

QTEST_APPLESS_MAIN(FileTypesTest)
#include "tst_filetypes.moc"
