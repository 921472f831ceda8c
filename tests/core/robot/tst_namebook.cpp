// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/namebook.h"
#include "robot/numbering.h"
#include "robot/signalwatch.h"
#include "robot/variablehistory.h"
#include "settings/profilestore.h"
#include "settings/settingsfile.h"
#include "values/utc.h"
#include "virtualcontroller/server.h"
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace std::chrono_literals;
using namespace robot;
using values::ByteVariable;
using variables::Reference;
using VariableKind = variables::Kind;

Q_DECLARE_METATYPE(QList<robot::PendantValue>)
Q_DECLARE_METATYPE(robot::NumberingVerdict)

namespace {

const Time start {std::chrono::seconds {1000}};

QList<ByteVariable> bytes(std::initializer_list<int> list)
{
    QList<ByteVariable> result;
    for (const int value : list)
        result << ByteVariable {quint8(value)};
    return result;
}

} // namespace

/// What is known around variables and signals: names, the numbering, what they were before.
class TestNameBook : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsTheControllersFiles();
    void aMissingFileIsSaidOnce();
    void localNamesAndRemarksAreKept();
    void judgesTheNumbering_data();
    void judgesTheNumbering();
    void proposesTellingNumbers();
    void countsEdges();
    void remembersWhatWas();
    void aVerifiedNumberingHoldsForItsSoftware();
};

void TestNameBook::readsTheControllersFiles()
{
    QTemporaryDir folder;
    settings::SettingsFile file {folder.filePath(QStringLiteral("settings.json"))};
    virtualcontroller::Options options;
    options.port = 0;
    options.filePort = 0;
    virtualcontroller::Server server {options};
    QVERIFY(server.start());
    server.memory().files["IONAME.DAT"] = "/IONAME\r\n//IN\r\nDOOR,,,\r\n,,,LAMP,NONSENSE\r\n";
    server.memory().files["VARNAME.DAT"] = "//VARNAME\r\n///B\r\n0007 1,0,PARTS\r\n";
    settings::Profile profile;
    profile.name = QStringLiteral("CELL 4");
    profile.host = QStringLiteral("127.0.0.1");
    profile.port = server.port();
    profile.filePort = server.filePort();
    server.memory().files["EXIONAME.DAT"] = "/EXIONAME\r\n//EXOUT\r\nREADY,,,\r\n";
    server.memory().files["IOMNAME.DAT"] = "/IOMMAME\r\n//NAME\r\n\r\nSPEED\r\n";
    Controller controller {profile};
    NameBook book {profile, settings::Notes {file, profile.name}};
    book.follow(controller);
    controller.open();
    QTRY_COMPARE(book.names().of(names::Signal {1, 0}).text, QStringLiteral("DOOR"));
    QTRY_COMPARE(book.names().of(Reference {VariableKind::B, 7}).text, QStringLiteral("PARTS"));
    QTRY_COMPARE(book.names().of(names::Signal {3001, 0}).text, QStringLiteral("READY"));
    QTRY_COMPARE(book.names().of(Reference {VariableKind::M, 1}).text, QStringLiteral("SPEED"));
    QCOMPARE(book.names().of(names::Signal {1, 7}).text, QStringLiteral("LAMP"));
    QCOMPARE(book.signalFetch().warnings.count(), 1);
    QCOMPARE(book.signalFetch().warnings.list().first().line, 4);
    QVERIFY(!book.variableFetch().error);
}

void TestNameBook::aMissingFileIsSaidOnce()
{
    QTemporaryDir folder;
    settings::SettingsFile file {folder.filePath(QStringLiteral("settings.json"))};
    virtualcontroller::Options options;
    options.port = 0;
    options.filePort = 0;
    virtualcontroller::Server server {options};
    QVERIFY(server.start());
    server.memory().files.clear();
    settings::Profile profile;
    profile.host = QStringLiteral("127.0.0.1");
    profile.port = server.port();
    profile.filePort = server.filePort();
    Controller controller {profile};
    NameBook book {profile, settings::Notes {file, profile.name}};
    book.follow(controller);
    controller.open();
    QTRY_VERIFY(book.signalFetch().error && book.variableFetch().error);
    QVERIFY(book.signalFetch().error->kind == values::ErrorKind::Refused);
    QVERIFY(!book.signalFetch().isUnderWay);
}

void TestNameBook::localNamesAndRemarksAreKept()
{
    QTemporaryDir folder;
    settings::SettingsFile file {folder.filePath(QStringLiteral("settings.json"))};
    settings::ProfileStore store {file};
    settings::Profile profile;
    profile.name = QStringLiteral("CELL 4 / Schweißen");
    const Reference b7 {VariableKind::B, 7};
    {
        NameBook book {profile, store.notes(profile.name)};
        QSignalSpy changed {&book, &NameBook::changed};
        book.setLocalName(b7, QStringLiteral("Recipe"));
        book.setLocalName(names::Signal {2701, 3}, QStringLiteral("Request"));
        book.setRemark(b7, QStringLiteral("1 to 6"));
        QCOMPARE(changed.count(), 3);
    }
    NameBook again {profile, store.notes(profile.name)};
    QVERIFY(again.names().of(b7).isLocal);
    QCOMPARE(again.names().of(names::Signal {2701, 3}).text, QStringLiteral("Request"));
    QCOMPARE(again.remark(b7), QStringLiteral("1 to 6"));
    again.setRemark(b7, {});
    again.setLocalName(b7, {});
    // Another controller has its own; the profiles are not touched.
    NameBook other {profile, store.notes(QStringLiteral("CELL 5"))};
    QVERIFY(other.names().of(names::Signal {2701, 3}).text.isEmpty());
    QVERIFY(NameBook(profile, store.notes(profile.name)).remark(b7).isEmpty());
    QVERIFY(store.profiles().isEmpty());
}

void TestNameBook::judgesTheNumbering_data()
{
    QTest::addColumn<QList<PendantValue>>("pendant");
    QTest::addColumn<NumberingVerdict>("verdict");
    // On the wire, from instance 1: 10 20 30 30 40.
    const auto row = [](const char *name, const QList<PendantValue> &pendant, NumberingVerdict verdict) {
        QTest::newRow(name) << pendant << verdict;
    };
    row("instance is the number", {{1, 10}, {2, 20}}, NumberingVerdict::FromZero);
    row("shifted", {{1, 20}, {2, 30}}, NumberingVerdict::FromOne);
    row("shifted, the first variable", {{0, 10}}, NumberingVerdict::FromOne);
    row("equal neighbours", {{3, 30}}, NumberingVerdict::Ambiguous);
    row("one of two tells", {{3, 30}, {2, 20}}, NumberingVerdict::FromZero);
    row("contradiction", {{1, 10}, {2, 30}}, NumberingVerdict::Neither);
    row("read wrong", {{1, 99}}, NumberingVerdict::Neither);
    row("not read", {{1, -1}}, NumberingVerdict::Neither);
    row("beyond", {{50, 10}}, NumberingVerdict::Neither);
}

void TestNameBook::judgesTheNumbering()
{
    QFETCH(QList<PendantValue>, pendant);
    QFETCH(NumberingVerdict, verdict);
    QVERIFY(judgeNumbering(pendant, bytes({10, 20, 30, 30, 40}), 1) == verdict);
}

void TestNameBook::proposesTellingNumbers()
{
    QCOMPARE(tellingNumbers(bytes({0, 0, 5, 5, 6, 0}), 1, 2), (QList<int> {2, 4}));
    QVERIFY(tellingNumbers(bytes({0, 0, 0}), 1, 2).isEmpty());
    QVERIFY(tellingNumbers({}, 1, 2).isEmpty());
}

void TestNameBook::countsEdges()
{
    RobotState state;
    state.setLinkUp(true, values::now());
    SignalWatch watch {state};
    QSignalSpy listChanged {&watch, &SignalWatch::listChanged};
    const names::Signal door {1, 0};
    watch.add(door);
    watch.add(door);
    watch.add({1, 1});
    watch.add({2701, 0});
    QCOMPARE(listChanged.count(), 3);
    QCOMPARE(watch.topics().size(), 2);
    for (const int bits : {0, 1, 1, 0, 3, 2})
        state.take<Kind::IoGroup>(1, values::IoGroup {quint8(bits)}, values::now());
    QCOMPARE(watch.traces()[0].rises, 2);
    QCOMPARE(watch.traces()[0].falls, 2);
    QCOMPARE(watch.traces()[1].rises, 1);
    QVERIFY(watch.traces()[0].changed.isValid());
    QVERIFY(!watch.traces()[2].spans.back().isOn); // never read
    // A gap counts nothing.
    state.setLinkUp(false, values::now());
    QVERIFY(!watch.traces()[0].spans.back().isOn);
    state.setLinkUp(true, values::now());
    state.take<Kind::IoGroup>(1, values::IoGroup {1}, values::now());
    watch.reset();
    QCOMPARE(watch.traces()[0].rises, 0);
    watch.remove(door);
    QVERIFY(!watch.isWatched(door));
}

void TestNameBook::remembersWhatWas()
{
    RobotState state;
    VariableHistory history {state};
    QSignalSpy changed {&history, &VariableHistory::changed};
    state.setLinkUp(true, start);
    const Reference b7 {VariableKind::B, 7};
    state.take<Kind::ByteVariable>(7, ByteVariable {17}, start);
    QVERIFY(!history.of(b7).previous);
    state.take<Kind::ByteVariable>(7, ByteVariable {17}, start);
    QVERIFY(!history.of(b7).changed.isValid());
    state.take<Kind::ByteVariable>(7, ByteVariable {18}, start);
    QVERIFY(history.of(b7).previous == variables::Value {ByteVariable {17}});
    QVERIFY(history.of(b7).changed.isValid());
    QCOMPARE(changed.count(), 3);
    QVERIFY(changed.last().first().value<variables::Range>() == (variables::Range {VariableKind::B, 7, 7}));
    state.take<Kind::Register>(7, values::Register {5}, start);
    QVERIFY(history.of(b7).latest == variables::Value {ByteVariable {18}});
}

void TestNameBook::aVerifiedNumberingHoldsForItsSoftware()
{
    settings::Profile profile;
    profile.name = QStringLiteral("CELL 4");
    profile.host = QStringLiteral("127.0.0.1");
    profile.numberingVerified = values::utc(QDate(2026, 11, 10), QTime(8, 0));
    profile.numberingSoftware = QStringLiteral("YAS4.12.00A(EN/EN)-00");
    AccessRules rules;
    Access access {rules};
    Arming arming;
    Controller controller {profile};
    Orders orders {controller, access, arming};
    NumberingGuard guard {orders};
    auto &state = const_cast<RobotState &>(controller.state());
    const auto read = [&](const char *software) {
        values::SystemInformation system;
        system.software = values::FixedText<24> {software};
        state.take<Kind::SystemInformation>(topics::systemInformation.number, system, start);
        return orders.situation().isNumberingVerified;
    };
    QVERIFY(!orders.situation().isNumberingVerified); // the software is not known yet
    QVERIFY(read("YAS4.12.00A(EN/EN)-00"));
    QVERIFY(!read("YAS4.13.00A(EN/EN)-00"));
    controller.setNumbering(
        protocol::Numbering::FromOne, QDateTime::currentDateTimeUtc(), QStringLiteral("YAS4.13.00A(EN/EN)-00"));
    QVERIFY(controller.profile().numbering == protocol::Numbering::FromOne);
    QVERIFY(read("YAS4.13.00A(EN/EN)-00"));
}

QTEST_GUILESS_MAIN(TestNameBook)
#include "tst_namebook.moc"
