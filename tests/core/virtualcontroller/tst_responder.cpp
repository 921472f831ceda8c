// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "asking.h"
#include "protocol/catalog.h"
#include "protocol/plural.h"
#include "support/golden.h"
#include "virtualcontroller/alarms.h"
#include "virtualcontroller/handlers.h"
#include <QTest>

using namespace virtualcontroller;
using protocol::Request;
using protocol::Service;
using values::Status;

/// Changes a memory: what stands against an order.
using Change = void (*)(Memory &);
Q_DECLARE_METATYPE(Change)
Q_DECLARE_METATYPE(Request)

namespace {

Request reading(quint16 command, quint16 instance = 1, quint8 attribute = 0)
{
    return {command, instance, attribute, attribute ? Service::GetSingle : Service::GetAll};
}

/// A robot-port request as it stands on the wire.
QByteArray packet(const Request &request)
{
    return protocol::encode(request, {protocol::Division::Robot, false, 9, 0});
}

QByteArray changed(QByteArray bytes, qsizetype at, char value)
{
    bytes[at] = value;
    return bytes;
}

} // namespace

class ResponderTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void refusesInOrder_data();
    void refusesInOrder();
    void allowsReadsAlways();
    void judgesFrames_data();
    void judgesFrames();
    void refusesEachWrongField_data();
    void refusesEachWrongField();
    void refusesAsTheGoldenRows_data();
    void refusesAsTheGoldenRows();
    void answersEveryGoldenRequest_data();
    void answersEveryGoldenRequest();
    void keepsWhatIsWritten_data();
    void keepsWhatIsWritten();
    void refusesWrongValues_data();
    void refusesWrongValues();
    void simulatesEveryCommand();
    void answersBareStatuses();
    void numbersVariablesBothWays();
    void writesAllItemsOrNone();
    void tellsTheState();
};

void ResponderTest::refusesInOrder_data()
{
    // Reference §10.2. A row is an order and its conditions in their order; each test step breaks one condition more,
    // from the last one to the first, and the first broken one must be told.
    QTest::addColumn<Request>("request");
    QTest::addColumn<QList<Change>>("changes");
    QTest::addColumn<QList<quint16>>("codes");

    const Change local = [](Memory &m) { m.status.data1.setFlag(Status::Remote, false); };
    const Change teach = [](Memory &m) {
        m.status.data1.setFlag(Status::Play, false);
        m.status.data1.setFlag(Status::Teach);
    };
    const Change alarm = [](Memory &m) { m.status.data2.setFlag(Status::Alarm); };
    const Change error = [](Memory &m) { m.status.data2.setFlag(Status::Error); };
    const Change open = [](Memory &m) { m.interlocks.isSafetyChainClosed = false; };
    const Change editing = [](Memory &m) { m.interlocks.isEditing = true; };
    const Change filesInUse = [](Memory &m) { m.interlocks.areFilesInUse = true; };
    const Change dataLocked = [](Memory &m) { m.interlocks.isDataLocked = true; };
    const Change panel = [](Memory &m) { m.interlocks.isPanelLocked = true; };
    const Change pendantHold = [](Memory &m) { m.status.data2.setFlag(Status::HeldByPendant); };
    const Change externalHold = [](Memory &m) { m.status.data2.setFlag(Status::HeldExternally); };
    const Change commandHold = [](Memory &m) { m.status.data2.setFlag(Status::HeldByCommand); };
    const Change servoOff = [](Memory &m) { m.status.data2.setFlag(Status::ServoOn, false); };
    const Change running = [](Memory &m) { m.status.data1.setFlag(Status::Running); };
    const Change noJob = [](Memory &m) { m.tasks.front().stack.clear(); };
    const Change noHome = [](Memory &m) { m.interlocks.isHomeConfirmed = false; };
    const Change startLocked = [](Memory &m) { m.interlocks.isStartLocked = true; };
    const Change missing = [](Memory &m) { m.files.erase("HOME.JBI"); };
    const Change selectLocked = [](Memory &m) { m.interlocks.isJobSelectPermitted = false; };
    const Change noMaster = [](Memory &m) { m.interlocks.isMasterCallPermitted = false; };
    const Change masterCalled = [](Memory &m) { m.interlocks.isMasterCalled = true; };
    const Change teachLocked = [](Memory &m) { m.interlocks.isTeachLocked = true; };

    using Changes = QList<Change>;
    using Codes = QList<quint16>;
    const auto row = [](const char *name, const Request &request, const Changes &changes, const Codes &codes) {
        QTest::newRow(name) << request << changes << codes;
    };
    row("HOLD on", order(0x83, 1, 1), {}, {});
    row("HOLD off", order(0x83, 1, 2), {local}, {0x2100});
    row("servo on", order(0x83, 2, 1), {local, teach, alarm, open}, {0x2100, 0x2080, 0x2060, 0x3450});
    row("servo off", order(0x83, 2, 2), {local}, {0x2100});
    row("HLOCK on", order(0x83, 3, 1), {local, editing, filesInUse}, {0x2100, 0x2130, 0x2090});
    row("HLOCK off", order(0x83, 3, 2), {local, editing, filesInUse}, {0x2100, 0x2130, 0x2090});
    row("reset", order(0x82, 1, 1), {local}, {0x2100});
    row("cancel", order(0x82, 2, 1), {local}, {0x2100});
    row("cycle", order(0x84, 2, 1), {local, panel}, {0x2100, 0x3220});
    row("message", {0x85, 1, 1, Service::SetSingle, QByteArray(32, 'A').replace(30, 2, QByteArray(2, '\0'))}, {local},
        {0x2100});
    row("start", order(0x86, 1, 1),
        {local, teach, error, pendantHold, externalHold, commandHold, servoOff, running, noJob, noHome, startLocked},
        {0x2100, 0x2080, 0x2060, 0x2020, 0x2040, 0x2050, 0x2070, 0x2010, 0x4060, 0x3040, 0x3230});
    row("select", ::selectJob("HOME"), {local, selectLocked, running, editing, missing},
        {0x2100, 0x2080, 0x2010, 0x2130, 0x4040});
    row("select master", ::selectJob("HOME", 0, 10),
        {local, running, editing, missing, noMaster, masterCalled, teachLocked},
        {0x2100, 0x2010, 0x2130, 0x4040, 0x3400, 0x3410, 0x3420});
    const Changes toMove {
        local, teach, alarm, pendantHold, externalHold, commandHold, servoOff, running, noHome, startLocked};
    const Codes notMoved {0x2100, 0x2080, 0x2060, 0x2020, 0x2040, 0x2050, 0x2070, 0x2010, 0x3040, 0x3230};
    row("move cartesian", moveTo(cartesian(1'085'000, 0, 620'000)), toMove, notMoved);
    values::PulseTarget pulses;
    pulses.speed = {values::SpeedClass::Percent, 1000};
    row("move pulse", moveTo(pulses), toMove, notMoved);
    row("write B", {0x7A, 0, 1, Service::SetSingle, QByteArray(1, '\1')}, {dataLocked, editing}, {0x2110, 0x2130});
    row("write P", {0x7F, 0, 0, Service::SetAll, protocol::encode(values::PositionVariable {})}, {dataLocked, editing},
        {0x2110, 0x2130});
    row("write register", {0x79, 0, 1, Service::SetSingle, QByteArray(2, '\1')}, {dataLocked, editing},
        {0x2110, 0x2130});
    row("write network input", {0x78, 2701, 1, Service::SetSingle, QByteArray(1, '\1')}, {dataLocked, editing},
        {0x2110, 0x2130});
    row("write network inputs", {0x300, 2701, 0, Service::WritePlural, word(2) + QByteArray(2, '\1')},
        {dataLocked, editing}, {0x2110, 0x2130});
}

void ResponderTest::refusesInOrder()
{
    QFETCH(Request, request);
    QFETCH(QList<Change>, changes);
    QFETCH(QList<quint16>, codes);
    Memory memory = ready();
    virtualcontroller::selectJob(memory, 0, "CLAMP", 0);
    Memory untouched = memory;
    const Answered done = ask(untouched, request);
    QCOMPARE(done.status, quint8(0));
    for (qsizetype broken = changes.size() - 1; broken >= 0; --broken) {
        changes[broken](memory);
        const Memory before = memory;
        const Answered refusal = ask(memory, request);
        QCOMPARE(refusal.status, quint8(0x1F));
        QCOMPARE(refusal.code, codes[broken]);
        QCOMPARE(refusal.payload, QByteArray());
        QCOMPARE(memory.status, before.status); // a refused order changes nothing
    }
}

void ResponderTest::allowsReadsAlways()
{
    Memory memory;
    setTeachMode(memory);
    raiseAlarm(memory, 1000, "SOMETHING");
    memory.interlocks.isEditing = memory.interlocks.isDataLocked = memory.interlocks.areFilesInUse = true;
    for (const int command : {0x70, 0x72, 0x73, 0x75, 0x76, 0x77, 0x7A, 0x79})
        QCOMPARE(ask(memory, reading(quint16(command), 1, 1)).status, quint8(0));
}

void ResponderTest::judgesFrames_data()
{
    QTest::addColumn<QByteArray>("datagram");
    QTest::addColumn<int>("code"); // -1: dropped
    const QByteArray good = packet(reading(0x72));
    QTest::newRow("good") << good << 0;
    QTest::newRow("empty") << QByteArray() << -1;
    QTest::newRow("31 bytes") << good.first(31) << -1;
    QTest::newRow("wrong identifier") << changed(good, 0, 'X') << -1;
    QTest::newRow("header size") << changed(good, 4, 0x21) << 0xE4A5;
    QTest::newRow("payload announced and missing") << changed(good, 6, 4) << 0xE4A7;
    QTest::newRow("payload not announced") << good + QByteArray(4, '\0') << 0xE4A7;
    const QByteArray large = changed(changed(good + QByteArray(480, '\0'), 6, char(0xE0)), 7, 1);
    QTest::newRow("512 bytes") << large << 0xE49E;
    QTest::newRow("division 0") << changed(good, 9, 0) << 0xE4A3;
    QTest::newRow("division of files") << changed(good, 9, 2) << 0xE4A3;
    QTest::newRow("division 3") << changed(good, 9, 3) << 0xE4A3;
    QTest::newRow("ACK 1") << changed(good, 10, 1) << 0xE4A2;
    QTest::newRow("ACK 2") << changed(good, 10, 2) << 0xE4A2;
    QTest::newRow("block 1") << changed(good, 12, 1) << 0xE4A1;
    // The simulator ignores reserve 1 (reference §12, conflict 48).
    QTest::newRow("reserve 1") << changed(good, 8, 0x33) << 0;
    QTest::newRow("header size before payload size") << changed(changed(good, 4, 0), 6, 1) << 0xE4A5;
}

void ResponderTest::judgesFrames()
{
    QFETCH(QByteArray, datagram);
    QFETCH(int, code);
    Memory memory;
    const auto reply = respond(datagram, memory, 0ms);
    QCOMPARE(reply.has_value(), code >= 0);
    if (!reply)
        return;
    const auto parsed = protocol::parseReply(*reply);
    QVERIFY(parsed);
    QCOMPARE(int(parsed->addedStatus), code);
    QCOMPARE(parsed->status, quint8(code ? 0x1F : 0));
    QCOMPARE(parsed->addedStatusSize, quint8(code ? 1 : 0));
    QCOMPARE(parsed->framing.id, quint8(9));
    QCOMPARE(parsed->framing.block, protocol::lastBlock);
    QCOMPARE(parsed->service, quint8(0x81));
    if (code)
        QCOMPARE(reply->size(), qsizetype(32));
}

void ResponderTest::refusesEachWrongField_data()
{
    // For each command: a request that is right, with one field wrong in turn (reference §1.7).
    QTest::addColumn<quint16>("command");
    for (const auto &command : protocol::commands())
        QTest::addRow("%s", command.name) << command.number;
}

void ResponderTest::refusesEachWrongField()
{
    QFETCH(quint16, command);
    const auto &row = *protocol::findCommand(command);
    Memory memory = ready();
    const auto ranges = row.instances(memory.dialect);
    const bool isPlural = row.isPlural();
    const Service service = row.services.first();
    const bool reads = protocol::requestPayload(service) != protocol::PayloadKind::Value;
    const QByteArray payload = isPlural ? word(2) : reads ? QByteArray {} : QByteArray(row.size, '\1');
    const quint8 attribute = isPlural ? 0 : row.hasAttribute(service, 1) ? 1 : 0;
    const Request good {command, ranges.first().first, attribute, service, payload};

    const auto codeOf = [&memory](const Request &request) { return ask(memory, request).code; };
    const quint16 answer = codeOf(good);
    QVERIFY2(answer != 0xA000 && answer != 0xA001 && answer != 0xA002 && answer != 0xB003,
        qPrintable(QString::number(answer, 16)));

    Request wrong = good;
    wrong.instance = 9999;
    QCOMPARE(codeOf(wrong), quint16(0xA001));
    wrong = good;
    wrong.attribute = 99;
    QCOMPARE(codeOf(wrong), quint16(0xA002));
    wrong = good;
    wrong.service = Service::ListFiles;
    QCOMPARE(codeOf(wrong), quint16(0xA002));
    wrong = good;
    wrong.payload.append(480 - wrong.payload.size() - 1, '\0');
    QCOMPARE(codeOf(wrong), quint16(0xB003));
    // The first wrong field is told.
    wrong.attribute = 99;
    QCOMPARE(codeOf(wrong), quint16(0xA002));
    wrong.instance = 9999;
    QCOMPARE(codeOf(wrong), quint16(0xA001));
    wrong.command = 0xFF;
    QCOMPARE(codeOf(wrong), quint16(0xA000));
}

void ResponderTest::refusesAsTheGoldenRows_data()
{
    QTest::addColumn<int>("index");
    for (int index = 0; index < golden::refused().size(); ++index) {
        const auto &row = golden::refused()[index];
        // The simulator pads a short text (reference §12, conflict 22).
        if (row.title != u"S written with 15 bytes")
            QTest::newRow(qPrintable(row.title)) << index;
    }
}

void ResponderTest::refusesAsTheGoldenRows()
{
    QFETCH(int, index);
    const auto &row = golden::refused()[index];
    Settings settings;
    if (const auto *dialect = protocol::findDialect(row.model))
        settings.model = dialect->model;
    Memory memory {settings};
    const Answered refusal = answered(respond(row.bytes, memory, 0ms));
    QCOMPARE(refusal.code, row.code);
    QCOMPARE(refusal.status, quint8(0x1F));
}

void ResponderTest::answersEveryGoldenRequest_data()
{
    QTest::addColumn<QByteArray>("request");
    QTest::addColumn<QByteArray>("reply");
    for (const auto &exchange : golden::exchanges()) {
        if (exchange.packets.size() == 2 && quint8(exchange.packets[0].bytes[9]) == 1)
            QTest::newRow(qPrintable(exchange.title)) << exchange.packets[0].bytes << exchange.packets[1].bytes;
    }
}

void ResponderTest::answersEveryGoldenRequest()
{
    QFETCH(QByteArray, request);
    QFETCH(QByteArray, reply);
    Memory memory = ready();
    const auto ours = respond(request, memory, 0ms);
    QVERIFY(ours);
    // The frame apart from the answer: identifier to reserve 2 without the payload size, and the service.
    QCOMPARE(ours->first(6), reply.first(6));
    QCOMPARE(ours->sliced(8, 17), reply.sliced(8, 17));
    QVERIFY(protocol::parseReply(*ours));
    // What is refused for what it says is refused everywhere.
    const auto theirs = protocol::parseReply(reply);
    const quint16 code = theirs->addedStatus;
    if (code >= 0xA000 && code < 0xC000)
        QCOMPARE(protocol::parseReply(*ours)->addedStatus, code);
}

void ResponderTest::keepsWhatIsWritten_data()
{
    QTest::addColumn<QByteArray>("request");
    for (const auto &exchange : golden::exchanges()) {
        const auto packet = protocol::parseClientPacket(exchange.packets.first().bytes);
        if (!packet || packet->framing.division != protocol::Division::Robot)
            continue;
        const bool isData = (packet->command >= 0x78 && packet->command <= 0x81) || packet->command == 0x8C
            || (packet->command >= 0x300 && packet->command <= 0x309) || packet->command == 0x30C;
        const auto reply = protocol::parseReply(exchange.packets.last().bytes);
        const bool isWrite = packet->service == Service::SetSingle || packet->service == Service::SetAll
            || packet->service == Service::WritePlural;
        if (isData && isWrite && reply && !reply->isRefusal())
            QTest::newRow(qPrintable(exchange.title)) << exchange.packets.first().bytes;
    }
}

void ResponderTest::keepsWhatIsWritten()
{
    QFETCH(QByteArray, request);
    Memory memory;
    const Answered written = answered(respond(request, memory, 0ms));
    QCOMPARE(written.status, quint8(0));
    Request read = protocol::parseClientPacket(request)->request();
    const QByteArray payload = read.payload;
    const bool isPlural = read.service == Service::WritePlural;
    read.service = isPlural                  ? Service::ReadPlural
        : read.service == Service::SetSingle ? Service::GetSingle
                                             : Service::GetAll;
    read.payload = isPlural ? payload.first(4) : QByteArray {};
    QCOMPARE(ask(memory, read).payload, payload);
    if (isPlural)
        QCOMPARE(written.payload, payload.first(4)); // reference §4.5
}

void ResponderTest::refusesWrongValues_data()
{
    QTest::addColumn<Request>("request");
    QTest::addColumn<quint16>("code");
    const auto row = [](const char *name, const Request &request, quint16 code) {
        QTest::newRow(name) << request << code;
    };
    row("reset 2", order(0x82, 1, 2), 0xB004);
    row("hold 0", order(0x83, 1, 0), 0xB004);
    row("servo 3", order(0x83, 2, 3), 0xB004);
    row("cycle 0", order(0x84, 2, 0), 0xB004);
    row("cycle 4", order(0x84, 2, 4), 0xB004);
    row("start 0", order(0x86, 1, 0), 0xB004);
    row("text of 31", {0x85, 1, 1, Service::SetSingle, QByteArray(31, 'A') + '\0'}, 0xB004);
    row("line 10000", ::selectJob("HOME", 10000), 0xB004);
    row("read-only I/O", {0x78, 1, 1, Service::SetSingle, QByteArray(1, '\1')}, 0xB002);
    row("I/O outside", reading(0x78, 0, 1), 0xA001);
    row("register 560", {0x79, 560, 1, Service::SetSingle, QByteArray(2, '\1')}, 0xB002);
    row("registers 559 and 560", {0x301, 559, 0, Service::WritePlural, word(2) + QByteArray(4, '\1')}, 0xB002);
    row("P never taught", reading(0x7F, 99), 0xB001);
    row("BP never taught", reading(0x80, 99), 0xB001);
    row("P type 1", {0x7F, 0, 0, Service::SetAll, word(1) + QByteArray(48, '\0')}, 0xB00C);
    row("P tool 64", {0x7F, 0, 3, Service::SetSingle, word(64)}, 0xB00D);
    row("P user frame 0", {0x7F, 0, 0, Service::SetAll, word(18) + QByteArray(48, '\0')}, 0xB00E);
    row("BP type 17", {0x80, 0, 1, Service::SetSingle, word(17)}, 0xB00C);
    row("EX type 16", {0x81, 0, 1, Service::SetSingle, word(16)}, 0xB00C);
    row("0 B", {0x302, 0, 0, Service::ReadPlural, word(0)}, 0xB003);
    row("3 B", {0x302, 0, 0, Service::ReadPlural, word(3)}, 0xB003);
    row("B beyond the last", {0x302, 98, 0, Service::ReadPlural, word(4)}, 0xB004);
    row("10 P", {0x307, 0, 0, Service::ReadPlural, word(10)}, 0xB003);
    row("a P never taught among others", {0x307, 0, 0, Service::ReadPlural, word(3)}, 0xB001);
    row("no such control group", reading(0x75, 2), 0xA001);
    row("no such task", reading(0x73, 2), 0xA001);

    // Reference §6.2 and §6.3, the first fault first.
    auto target = cartesian(1'085'000, 0, 620'000);
    const auto move = [&](const char *name, auto change, quint16 code, quint16 instance = 2) {
        auto changedTarget = target;
        change(changedTarget);
        row(name, moveTo(changedTarget, instance), code);
    };
    move(
        "robot and station", [](auto &t) { t.station = 1; }, 0xB008);
    move(
        "no group", [](auto &t) { t.robot = 0; }, 0xB008);
    move(
        "robot 2", [](auto &t) { t.robot = 2; }, 0xB008);
    move(
        "percent goes straight", [](auto &t) { t.speed.kind = values::SpeedClass::Percent; }, 0xB009);
    move(
        "mm/s goes by joints", [](auto &) {}, 0xB009, 1);
    move(
        "speed class 3", [](auto &t) { t.speed.kind = values::SpeedClass(3); }, 0xB009);
    move(
        "speed 0", [](auto &t) { t.speed.value = 0; }, 0xB00A);
    move(
        "over 100 %",
        [](auto &t) {
            t.speed = {values::SpeedClass::Percent, 10001};
        },
        0xB009, 1);
    move(
        "coordinate 0", [](auto &t) { t.frame = values::PositionType::Pulse; }, 0xB00B);
    move(
        "coordinate 20", [](auto &t) { t.frame = values::PositionType(20); }, 0xB00B);
    move(
        "form", [](auto &t) { t.form = 256; }, 0xB00C);
    move(
        "tool", [](auto &t) { t.tool = 64; }, 0xB00D);
    move(
        "user frame 0", [](auto &t) { t.frame = values::PositionType::User; }, 0xB00E);
    move(
        "user frame 64", [](auto &t) { t.userFrame = 64; }, 0xB00E);
    move(
        "group before speed", [](auto &t) { t.robot = t.speed.value = 0; }, 0xB008);
    move(
        "speed before coordinate",
        [](auto &t) {
            t.speed.value = 0;
            t.frame = values::PositionType::Pulse;
        },
        0xB00A);
    values::PulseTarget pulses;
    pulses.tool = 64;
    pulses.speed = {values::SpeedClass::Percent, 100};
    row("pulse move with tool 64", moveTo(pulses), 0xB00D);
}

void ResponderTest::refusesWrongValues()
{
    QFETCH(Request, request);
    QFETCH(quint16, code);
    Memory memory; // servo off: a wrong value comes before the state
    QCOMPARE(ask(memory, request).code, code);
}

void ResponderTest::simulatesEveryCommand()
{
    for (const auto &command : protocol::commands())
        QVERIFY2(findHandler(command.number), command.name);
}

void ResponderTest::answersBareStatuses()
{
    Settings settings;
    settings.usesBareStatuses = true;
    Memory memory {settings};
    const auto bare = [&](const Request &request) {
        const Answered refusal = ask(memory, request);
        return std::pair {refusal.status, refusal.code};
    };
    using Pair = std::pair<quint8, quint16>;
    QCOMPARE(bare(reading(0xFF)), Pair(0x08, 0));
    QCOMPARE(bare(reading(0x72, 2)), Pair(0x28, 0));
    QCOMPARE(bare(reading(0x72, 1, 3)), Pair(0x09, 0));
    QCOMPARE(bare(order(0x84, 2, 9)), Pair(0x1F, 0xB004));
}

void ResponderTest::numbersVariablesBothWays()
{
    Settings settings;
    settings.numbering = protocol::Numbering::FromOne;
    Memory memory {settings};
    memory.b[0].value = 7;
    memory.b[99].value = 9;
    QCOMPARE(ask(memory, reading(0x7A, 1, 1)).payload, QByteArray(1, 7));
    QCOMPARE(ask(memory, reading(0x7A, 100, 1)).payload, QByteArray(1, 9));
    QCOMPARE(ask(memory, reading(0x7A, 0, 1)).code, quint16(0xA001));
    QCOMPARE(ask(memory, {0x302, 99, 0, Service::ReadPlural, word(2)}).payload, word(2) + QByteArray("\0\x9", 2));
    memory.registers[0].value = 5; // registers have their number
    QCOMPARE(ask(memory, reading(0x79, 0, 1)).code, quint16(0));
    QCOMPARE(ask(memory, {0x79, 0, 1, Service::GetSingle}).payload, QByteArray("\x5\0", 2));
}

void ResponderTest::writesAllItemsOrNone()
{
    Memory memory;
    QByteArray payload = word(2) + protocol::encode(values::ExternalPosition {});
    payload += word(16) + QByteArray(32, '\0'); // EX in a base frame is wrong
    QCOMPARE(ask(memory, {0x309, 10, 0, Service::WritePlural, payload}).code, quint16(0xB00C));
    QVERIFY(!memory.ex[10]);
}

void ResponderTest::tellsTheState()
{
    Memory memory = ready();
    memory.switchedOn = QDateTime {QDate {2026, 1, 31}, QTime {8, 30}};
    raiseAlarm(memory, 4107, "OUT OF RANGE", {1, values::AlarmDataType::AxesSlurbt});
    // Reference §3.1: number, data, type, time, name.
    const QByteArray expected =
        word(4107) + word(1) + word(3) + "2026/01/31 08:30" + QByteArray("OUT OF RANGE").leftJustified(32, '\0');
    QCOMPARE(ask(memory, reading(0x70, 1)).payload, expected);
    QCOMPARE(ask(memory, reading(0x70, 2)).payload, QByteArray(60, '\0'));
    QCOMPARE(ask(memory, reading(0x71, 1001)).payload, expected);
    QCOMPARE(ask(memory, reading(0x30A, 1)).payload.size(), qsizetype(268));
    QCOMPARE(ask(memory, reading(0x72)).payload, word(0xC2) + word(0x50));
    QCOMPARE(
        ask(memory, reading(0x74, 1)).payload.trimmed().replace('\0', ' ').simplified(), QByteArray("S L U R B T"));
    QCOMPARE(ask(memory, reading(0x75, 101)).payload.size(), qsizetype(44));
    QCOMPARE(ask(memory, reading(0x75, 101, 6)).payload, word(1'085'000));
    QCOMPARE(ask(memory, reading(0x77, 1)).payload.size(), qsizetype(24));
    memory.times[1].elapsed = 18h + 19min + 2s;
    QCOMPARE(ask(memory, reading(0x88, 1, 2)).payload, QByteArray("18:19'02").leftJustified(12, '\0'));
    QCOMPARE(ask(memory, reading(0x89, 11)).payload.size(), qsizetype(48));
}

QTEST_GUILESS_MAIN(ResponderTest)
#include "tst_responder.moc"
