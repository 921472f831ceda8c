// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "names/names.h"
#include <QFile>
#include <QTest>

using namespace names;
using variables::Kind;
using variables::Reference;

Q_DECLARE_METATYPE(QList<names::Remark>)

class NamesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsTheDemo();
    void readsDamagedFiles_data();
    void readsDamagedFiles();
    void readsOtherEncodings();
    void readsTwoMegabytes();
    void survivesEveryCut();
    void localNamesComeFirst();
    void localNamesAreKept();
    void finds();
};

namespace {

const protocol::Dialect &yrc() { return protocol::dialect(protocol::Model::YRC1000); }

NameFile read(const QByteArray &file, protocol::Encoding encoding = protocol::Encoding::Latin1)
{
    return readNames(file, protocol::TextCodec {encoding}, yrc());
}

} // namespace

void NamesTest::readsTheDemo()
{
    const NameFile io = read("//IONAME\r\n///GRPNAME\r\n///SHARE 0\r\n///IN\r\n0001,FIXTURE CLAMPED\r\n0009,DOOR "
                             "CLOSED\r\n///OUT\r\n0002,CLAMP, LEFT\r\n");
    QCOMPARE(io.remarkCount, 0);
    QCOMPARE(io.signalNames.size(), 3);
    QCOMPARE(io.signalNames.value({1, 0}), QStringLiteral("FIXTURE CLAMPED"));
    QCOMPARE(io.signalNames.value({2, 0}), QStringLiteral("DOOR CLOSED"));
    QCOMPARE(io.signalNames.value({1001, 1}), QStringLiteral("CLAMP, LEFT"));

    const NameFile variables = read("//VARNAME\r\n///B\r\n090,DOOR\r\n///P\r\n001,HOME BASE\r\n///BP\r\n2,TRACK\r\n");
    QCOMPARE(variables.remarkCount, 0);
    QCOMPARE(variables.variableNames.value({Kind::B, 90}), QStringLiteral("DOOR"));
    QCOMPARE(variables.variableNames.value({Kind::P, 1}), QStringLiteral("HOME BASE"));
    QCOMPARE(variables.variableNames.value({Kind::BP, 2}), QStringLiteral("TRACK"));
}

void NamesTest::readsDamagedFiles_data()
{
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<int>("kept");
    QTest::addColumn<QList<int>>("lines"); // with a remark
    QTest::newRow("empty") << QByteArray() << 0 << QList<int> {};
    QTest::newRow("line feeds") << QByteArray("//IONAME\n///IN\n1,A\n2,B\n") << 2 << QList<int> {};
    QTest::newRow("carriage returns") << QByteArray("//IONAME\r///IN\r1,A\r2,B") << 2 << QList<int> {};
    QTest::newRow("mixed ends") << QByteArray("//IONAME\r\n///IN\n1,A\r\n\r\n2,B\nx") << 2 << QList<int> {6};
    QTest::newRow("cut in a name") << QByteArray("//IONAME\n///IN\n1,A\n2,PA") << 2 << QList<int> {};
    QTest::newRow("cut in a number") << QByteArray("//IONAME\n///IN\n1,A\n00") << 1 << QList<int> {4};
    QTest::newRow("no head") << QByteArray("///IN\n1,A\n") << 1 << QList<int> {};
    QTest::newRow("no section") << QByteArray("//IONAME\n1,A\n") << 0 << QList<int> {2};
    QTest::newRow("unknown section") << QByteArray("//IONAME\n///ELBOWS\n1,A\n///IN\n1,B\n") << 1 << QList<int> {3};
    QTest::newRow("beyond the area") << QByteArray("///IN\n4096,A\n4097,B\n0,C\n4294967295,D\n") << 1
                                     << QList<int> {3, 4, 5};
    QTest::newRow("variable beyond") << QByteArray("///B\n099,A\n100,B\n") << 1 << QList<int> {3};
    QTest::newRow("named twice") << QByteArray("///B\n1,A\n1,B\n") << 1 << QList<int> {3};
    QTest::newRow("no name") << QByteArray("///B\n1,\n2, \n") << 0 << QList<int> {};
    QTest::newRow("no comma") << QByteArray("///B\n1 A\n") << 0 << QList<int> {2};
    QTest::newRow("negative") << QByteArray("///B\n-1,A\n") << 0 << QList<int> {2};
    QTest::newRow("binary") << QByteArray("\0\xFF\x01//\n///B\n1,A\n", 15) << 1 << QList<int> {1};
    QTest::newRow("undecodable") << QByteArray("///B\n1,A\x8A\n") << 1 << QList<int> {2};
}

void NamesTest::readsDamagedFiles()
{
    QFETCH(QByteArray, file);
    QFETCH(int, kept);
    const NameFile names = read(file);
    QCOMPARE(int(names.signalNames.size() + names.variableNames.size()), kept);
    QList<int> lines;
    for (const Remark &remark : names.remarks) {
        lines << remark.line;
        QVERIFY2(remark.reason.endsWith(u'.'), qPrintable(remark.reason));
    }
    QTEST(lines, "lines");
    QCOMPARE(names.remarkCount, int(lines.size()));
}

void NamesTest::readsOtherEncodings()
{
    const QByteArray file = "///S\n000," + QByteArray::fromHex("836583588367") + "\n001,A" + QByteArray::fromHex("8a");
    const NameFile names = read(file, protocol::Encoding::ShiftJis);
    QCOMPARE(names.variableNames.value({Kind::S, 0}), QStringLiteral("テスト"));
    QCOMPARE(names.variableNames.value({Kind::S, 1}), QStringLiteral("A⟨8A⟩"));
    QCOMPARE(names.remarkCount, 1);
}

void NamesTest::readsTwoMegabytes()
{
    QByteArray file = "//IONAME\r\n///IN\r\n";
    int line = 0;
    while (file.size() < 2'000'000)
        file += QByteArray::number(++line % 6000) + ",NAME OF A SIGNAL " + QByteArray::fromHex("8365") + "\r\n";
    const NameFile names = read(file, protocol::Encoding::ShiftJis);
    QCOMPARE(names.signalNames.size(), 4096);
    QCOMPARE(names.remarks.size(), NameFile::maxRemarks);
    QVERIFY(names.remarkCount > NameFile::maxRemarks);
}

void NamesTest::survivesEveryCut()
{
    const QByteArray file = "//IONAME\r\n///IN\r\n0001,A\x8A\r\n///OUT\r\n2,B\r\n";
    for (qsizetype size = 0; size <= file.size(); ++size)
        QVERIFY(read(file.first(size)).signalNames.size() <= 2);
}

void NamesTest::localNamesComeFirst()
{
    Names names;
    names.takeSignalNames(read("///IN\n1,FIXTURE\n"));
    names.takeVariableNames(read("///B\n0,PARTS\n"));
    const Signal input {1, 0};
    QVERIFY((names.of(input) == Name {QStringLiteral("FIXTURE"), false}));
    names.setLocal(input, QStringLiteral(" Clamp "));
    QVERIFY((names.of(input) == Name {QStringLiteral("Clamp"), true}));
    QCOMPARE(names.own(input), QStringLiteral("FIXTURE"));
    names.setLocal(input, QStringLiteral("  "));
    QVERIFY((names.of(input) == Name {QStringLiteral("FIXTURE"), false}));
    QVERIFY((names.of(Reference {Kind::B, 0}) == Name {QStringLiteral("PARTS"), false}));
    QVERIFY((names.of(Reference {Kind::B, 1}) == Name {}));
    // Another file of the controller takes nothing local away.
    names.setLocal(Reference {Kind::B, 1}, QStringLiteral("mine"));
    names.takeVariableNames({});
    QVERIFY((names.of(Reference {Kind::B, 0}) == Name {}));
    QVERIFY(names.of(Reference {Kind::B, 1}).isLocal);
    QVERIFY((names.of(input) == Name {QStringLiteral("FIXTURE"), false}));
}

void NamesTest::localNamesAreKept()
{
    Names names;
    names.setLocal(Signal {2701, 3}, QStringLiteral("Request 溶接"));
    names.setLocal(Reference {Kind::EX, 12}, QStringLiteral("Track"));
    const QJsonObject json = names.localNames();
    QCOMPARE(json.keys(), (QStringList {QStringLiteral("#27013"), QStringLiteral("EX012")}));
    Names again;
    again.setLocalNames(json, yrc());
    QCOMPARE(again.localNames(), json);
    QVERIFY(again.of(Signal {2701, 3}).isLocal);
    // What does not belong there is left out.
    again.setLocalNames({{QStringLiteral("#99999"), QStringLiteral("A")}, {QStringLiteral("B100"), QStringLiteral("B")},
                            {QStringLiteral("B001"), 17}, {QStringLiteral("B002"), QStringLiteral("C")}},
        yrc());
    QCOMPARE(again.localNames().keys(), QStringList {QStringLiteral("B002")});
}

void NamesTest::finds()
{
    Names names;
    names.takeSignalNames(read("///IN\n1,DOOR CLOSED\n2,PART\n///OUT\n1,OPEN DOOR\n"));
    names.setLocal(Signal {1, 1}, QStringLiteral("Back door"));
    QCOMPARE(names.findSignals(QStringLiteral("door"), 10).size(), 3);
    QCOMPARE(names.findSignals(QStringLiteral("door"), 2).size(), 2);
    QCOMPARE(names.findSignals(QStringLiteral("part"), 10).size(), 0); // it has another name here
    QCOMPARE(names.findSignals(QStringLiteral("DOOR open"), 10).first().number(), 10010);
    QVERIFY(names.findVariables(QStringLiteral("door"), 10).isEmpty());
}

QTEST_APPLESS_MAIN(NamesTest)
#include "tst_names.moc"
