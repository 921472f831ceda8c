// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "asking.h"
#include "support/golden.h"
#include "virtualcontroller/alarms.h"
#include "virtualcontroller/fileresponder.h"
#include <QTest>

using namespace virtualcontroller;
using protocol::lastBlock;
using protocol::Service;
using values::Status;

using Change = void (*)(Memory &);
Q_DECLARE_METATYPE(Change)

namespace {

const QByteArray smallJob = "/JOB\r\n//NAME SMALL\r\n//POS\r\n///NPOS 0,0,0,0,0,0\r\n//INST\r\n///DATE 2026/01/31 08:30"
                            "\r\n///ATTR SC,RW\r\n///GROUP1 RB1\r\nNOP\r\nEND\r\n";

/// A client of the file port.
struct Client {
    Memory &memory;
    QByteArray peer = "127.0.0.1:5000";
    quint8 id = 8;
    Time now {};

    Answered send(Service service, bool ack, quint32 block, const QByteArray &payload)
    {
        now = std::max(now, memory.now);
        const auto datagram = protocol::encode({0, 0, 0, service, payload}, {protocol::Division::File, ack, id, block});
        return answered(respondFile(datagram, peer, memory, now));
    }
    Answered request(Service service, const QByteArray &payload) { return send(service, false, 0, payload); }
    Answered block(quint32 block, const QByteArray &data) { return send(Service::LoadFile, true, block, data); }
    Answered acknowledge(quint32 block, Service service = Service::SaveFile) { return send(service, true, block, {}); }
};

quint32 blockOf(const Answered &answer) { return protocol::parseReply(answer.bytes)->framing.block; }

} // namespace

class FileResponderTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void lists_data();
    void lists();
    void savesBlockByBlock();
    void loadsBlockByBlock();
    void answersLikeTheGoldenTransfers_data();
    void answersLikeTheGoldenTransfers();
    void refusesRequests_data();
    void refusesRequests();
    void judgesContents_data();
    void judgesContents();
    void keepsAJobUnderItsOwnName();
    void refusesPacketsOutOfOrder();
    void answersDuplicatesTheSameWay();
    void servesOneClientAtATime();
    void aNewRequestReplacesAStaleTransfer();
    void dropsASilentClient();
    void endsWithAChangeOfMode();
    void judgesFrames_data();
    void judgesFrames();
};

void FileResponderTest::lists_data()
{
    QTest::addColumn<QByteArray>("filter");
    QTest::addColumn<QByteArray>("names");
    const QByteArray jobs = "A.JBI\r\nB.JBI\r\n";
    QTest::newRow("empty") << QByteArray() << jobs;
    QTest::newRow("star") << QByteArray("*") << jobs;
    QTest::newRow("two stars") << QByteArray("**") << jobs;
    QTest::newRow("jobs") << QByteArray("*.JBI") << jobs;
    QTest::newRow("data") << QByteArray("*.DAT") << QByteArray("VAR.DAT\r\n");
    QTest::newRow("all") << QByteArray("*.*") << QByteArray("A.JBI\r\nB.JBI\r\nVAR.DAT\r\n");
}

void FileResponderTest::lists()
{
    QFETCH(QByteArray, filter);
    Memory memory;
    memory.files = {{"B.JBI", "x"}, {"A.JBI", "x"}, {"VAR.DAT", "x"}};
    memory.status.data1.setFlag(Status::Remote, false); // a list needs no remote (reference §10.2)
    Client client {memory};
    const Answered first = client.request(Service::ListFiles, filter);
    QCOMPARE(first.status, quint8(0));
    QTEST(first.payload, "names");
    QCOMPARE(blockOf(first), lastBlock | 1);
    QVERIFY(client.acknowledge(lastBlock | 1, Service::ListFiles).bytes.isEmpty());
}

void FileResponderTest::savesBlockByBlock()
{
    Memory memory;
    memory.settings.blockSize = 100;
    memory.files["BIG.DAT"] = QByteArray(100, 'a') + QByteArray(100, 'b') + "c";
    Client client {memory};
    Answered answer = client.request(Service::SaveFile, "BIG.DAT");
    QCOMPARE(answer.payload, QByteArray(100, 'a'));
    QCOMPARE(blockOf(answer), 1U);
    answer = client.acknowledge(1);
    QCOMPARE(answer.payload, QByteArray(100, 'b'));
    QCOMPARE(blockOf(answer), 2U);
    answer = client.acknowledge(2);
    QCOMPARE(answer.payload, QByteArray("c"));
    QCOMPARE(blockOf(answer), lastBlock | 3);
    QVERIFY(client.acknowledge(lastBlock | 3).bytes.isEmpty());

    memory.files["EXACT.DAT"] = QByteArray(100, 'x'); // fills its block: no empty one follows
    answer = client.request(Service::SaveFile, "EXACT.DAT");
    QCOMPARE(blockOf(answer), lastBlock | 1);
}

void FileResponderTest::loadsBlockByBlock()
{
    Memory memory;
    Client client {memory};
    Answered answer = client.request(Service::LoadFile, "SMALL.JBI");
    // Reference §1.5: the go-ahead has block 0.
    QCOMPARE(answer.bytes.toHex(),
        QByteArray("594552432000000003020108000000003939393939393939950000000000"
                   "0000"));
    QVERIFY(!memory.files.contains("SMALL.JBI"));
    answer = client.block(1, smallJob.first(40));
    QCOMPARE(answer.status, quint8(0));
    QCOMPARE(blockOf(answer), 1U);
    answer = client.block(lastBlock | 2, smallJob.sliced(40));
    QCOMPARE(answer.status, quint8(0));
    QCOMPARE(blockOf(answer), lastBlock | 2);
    QCOMPARE(memory.files.at("SMALL.JBI"), smallJob);
    // A single block may be marked 0x80000000 as well (reference §1.4).
    client.request(Service::LoadFile, "SMALL.JBI");
    QCOMPARE(client.block(lastBlock, smallJob).status, quint8(0));
}

void FileResponderTest::answersLikeTheGoldenTransfers_data()
{
    QTest::addColumn<QString>("title");
    for (const char *title : {"No file of the type", "A job is loaded in two blocks",
             "Loading is refused without remote", "A job is deleted", "Deleting a missing file is refused",
             "Deleting without a name is refused", "The batch backup is not set up"})
        QTest::newRow(title) << QString::fromLatin1(title);
}

void FileResponderTest::answersLikeTheGoldenTransfers()
{
    QFETCH(QString, title);
    Memory memory;
    memory.files.erase("CIOPRG.LST");
    if (title == u"A job is deleted")
        memory.files["DEMO01.JBI"] = smallJob;
    memory.status.data1.setFlag(Status::Remote, title != u"Loading is refused without remote");
    const auto &packets = golden::exchange(title).packets;
    for (qsizetype index = 0; index + 1 < packets.size(); index += 2) {
        QVERIFY(packets[index].isFromClient && !packets[index + 1].isFromClient);
        QCOMPARE(respondFile(packets[index].bytes, "peer", memory, 0ms).value_or(QByteArray {}).toHex(),
            packets[index + 1].bytes.toHex());
    }
}

void FileResponderTest::refusesRequests_data()
{
    QTest::addColumn<Service>("service");
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<Change>("change");
    QTest::addColumn<quint16>("code");
    const Change none = [](Memory &) {};
    const Change local = [](Memory &m) { m.status.data1.setFlag(Status::Remote, false); };
    const Change editing = [](Memory &m) { m.interlocks.isEditing = true; };
    const Change filesInUse = [](Memory &m) { m.interlocks.areFilesInUse = true; };
    const Change running = [](Memory &m) {
        m.status.data2.setFlag(Status::ServoOn);
        virtualcontroller::selectJob(m, 0, "WELD_A12", 0);
        startJob(m);
    };
    const Change noOverwriting = [](Memory &m) { m.settings.mayOverwriteFiles = false; };
    const Change noOverwriting4030 = [](Memory &m) {
        m.settings.mayOverwriteFiles = false;
        m.settings.overwriteRefusal = 0x4030;
    };
    const auto row = [](const char *title, Service service, const QByteArray &name, Change change, quint16 code) {
        QTest::newRow(title) << service << name << change << code;
    };
    using enum Service;
    for (const auto &[service, name] : {std::pair {SaveFile, "save"}, {LoadFile, "load"}, {DeleteFile, "delete"}}) {
        const auto each = [&](const char *what, const QByteArray &file, Change change, quint16 code) {
            QTest::addRow("%s %s", name, what) << service << file << change << code;
        };
        each("without a name", "", none, 0xE49D);
        each("without a name, before remote", "", local, 0xE49D);
        each("without remote", "HOME.JBI", local, 0xE2B2);
        each("while edited", "HOME.JBI", editing, 0x2130);
        each("while files are in use", "HOME.JBI", filesInUse, 0x2090);
        each("with a folder", "../HOME.JBI", none, 0xE2A0);
        each("with a backslash", "A\\HOME.JBI", none, 0xE2A0);
        each("with 33 characters", QByteArray(33, 'A') + ".JBI", none, 0xE2B4);
    }
    row("save missing", SaveFile, "NONE.JBI", none, 0xE2B3);
    row(
        "save empty", SaveFile, "EMPTY.DAT", [](Memory &m) { m.files["EMPTY.DAT"] = ""; }, 0xE29C);
    row("save backup", SaveFile, "/SPDRV/CMOSBK.BIN", none, 0xE24F);
    row("delete missing", DeleteFile, "NONE.JBI", none, 0xE2B3);
    row("delete with a terminator", DeleteFile, QByteArray("HOME.JBI", 9), none, 0xE49D); // §12, conflict 51
    row("delete data", DeleteFile, "IONAME.DAT", none, 0xE2AF);
    row("delete protected", DeleteFile, "SAFETY.JBI", none, 0x4020);
    row("delete running", DeleteFile, "WELD_A12.JBI", running, 0x2010);
    row("load over protected", LoadFile, "SAFETY.JBI", none, 0x4020);
    row("load over running", LoadFile, "WELD_A12.JBI", running, 0x2010);
    row("load over another", LoadFile, "HOME.JBI", noOverwriting, 0xE28C);
    row("load over another, other code", LoadFile, "HOME.JBI", noOverwriting4030, 0x4030);
    row("load with an illegal name", LoadFile, "A:B.JBI", none, 0x4190);
    row("load system", LoadFile, "SYSTEM.SYS", none, 0x2120);
    row("load unknown type", LoadFile, "PICTURE.PNG", none, 0xE2A7);
    row("list unknown type", ListFiles, "*.PNG", none, 0xE2A7);
    row("list nothing", ListFiles, "*.JBR", none, 0xE2A7);
    row("unknown service", Service(0x17), "A", none, 0xA000);
    row("robot service", GetAll, "A", none, 0xA000);
}

void FileResponderTest::refusesRequests()
{
    QFETCH(Service, service);
    QFETCH(QByteArray, name);
    QFETCH(Change, change);
    QFETCH(quint16, code);
    Memory memory;
    change(memory);
    const auto before = memory.files;
    Client client {memory};
    const Answered refusal = client.request(service, name);
    QCOMPARE(refusal.code, code);
    QCOMPARE(refusal.status, quint8(0x1F));
    QVERIFY(!memory.transfer);
    QCOMPARE(memory.files, before);
}

void FileResponderTest::judgesContents_data()
{
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("contents");
    QTest::addColumn<quint16>("code");
    const auto job = [](QByteArray from, QByteArray to) { return QByteArray {smallJob}.replace(from, to); };
    const auto row = [](const char *title, const QByteArray &contents, quint16 code) {
        QTest::newRow(title) << QByteArray("SMALL.JBI") << contents << code;
    };
    row("good", smallJob, 0);
    row("line feeds alone", job("\r\n", "\n"), 0);
    row("no NOP", job("NOP\r\n", ""), 0x5130);
    row("no END", job("END\r\n", ""), 0x5130);
    row("END and more", job("END\r\n", "END\r\nNOP\r\n"), 0x5130);
    row("unknown pseudo instruction", job("///ATTR", "///ATTER"), 0x5340);
    row("wrong position type", job("//INST", "///POSTYPE POLAR\r\n//INST"), 0x5340);
    row("wrong count", job("///NPOS 0", "///NPOS 1"), 0x5180);
    row("no instruction", job("NOP\r\n", "NOP\r\nmovj\r\n"), 0x5110);
    row("no job", job("/JOB\r\n", ""), 0x5310);
    row("text before", "HELLO\r\n" + smallJob, 0x5310);
    row("illegal name", job("NAME SMALL", "NAME SM.ALL"), 0x4190);
    row("no name", job("NAME SMALL", "NAME"), 0x4190);
    row("another protected job", job("NAME SMALL", "NAME SAFETY"), 0x4020);
    QTest::newRow("data") << QByteArray("VAR.DAT") << QByteArray("//VAR\r\n") << quint16(0);
    QTest::newRow("no data") << QByteArray("VAR.DAT") << QByteArray("PK\3\4") << quint16(0x5310);
}

void FileResponderTest::judgesContents()
{
    QFETCH(QByteArray, name);
    QFETCH(QByteArray, contents);
    QFETCH(quint16, code);
    Memory memory;
    const auto before = memory.files;
    Client client {memory};
    QCOMPARE(client.request(Service::LoadFile, name).status, quint8(0));
    const Answered answer = client.block(lastBlock | 1, contents);
    QCOMPARE(answer.code, code);
    if (code)
        QCOMPARE(memory.files, before);
    else
        QCOMPARE(memory.files.at(name), contents);
}

void FileResponderTest::keepsAJobUnderItsOwnName()
{
    Memory memory;
    Client client {memory};
    client.request(Service::LoadFile, "OTHER.JBI");
    QCOMPARE(client.block(lastBlock | 1, smallJob).status, quint8(0));
    QVERIFY(memory.files.contains("SMALL.JBI") && !memory.files.contains("OTHER.JBI"));
}

void FileResponderTest::refusesPacketsOutOfOrder()
{
    Memory memory;
    memory.settings.blockSize = 10;
    memory.files["BIG.DAT"] = QByteArray(35, 'a');
    Client client {memory};
    QCOMPARE(client.acknowledge(1).code, quint16(0xE4A2)); // nothing goes on
    QCOMPARE(client.send(Service::SaveFile, false, 1, "BIG.DAT").code, quint16(0xE4A1));
    client.request(Service::SaveFile, "BIG.DAT");
    QCOMPARE(client.acknowledge(2).code, quint16(0xE4A1));
    QCOMPARE(client.acknowledge(lastBlock | 1).code, quint16(0xE4A1));
    QCOMPARE(client.acknowledge(1, Service::ListFiles).code, quint16(0xE4A2));
    client.id = 9;
    QCOMPARE(client.acknowledge(1).code, quint16(0xE4A2));
    client.id = 8;
    QCOMPARE(blockOf(client.acknowledge(1)), 2U); // it still goes on

    client.request(Service::LoadFile, "SMALL.JBI");
    QCOMPARE(client.block(2, "x").code, quint16(0xE4A1));
    QCOMPARE(client.block(0, "x").code, quint16(0xE4A1));
    QCOMPARE(client.block(1, "").code, quint16(0xE49D));
    QCOMPARE(client.block(1, "x").code, quint16(0));
    QCOMPARE(client.block(lastBlock, "x").code, quint16(0xE4A1)); // only for a single block
    QCOMPARE(client.block(3, "x").code, quint16(0xE4A1));
}

void FileResponderTest::answersDuplicatesTheSameWay()
{
    Memory memory;
    memory.settings.blockSize = 10;
    memory.files["BIG.DAT"] = "0123456789abcdefghijXYZ";
    Client client {memory};
    const Answered first = client.request(Service::SaveFile, "BIG.DAT");
    QCOMPARE(client.request(Service::SaveFile, "BIG.DAT").bytes, first.bytes);
    const Answered second = client.acknowledge(1);
    QCOMPARE(second.payload, QByteArray("abcdefghij"));
    QCOMPARE(client.acknowledge(1).bytes, second.bytes);
    QCOMPARE(client.acknowledge(2).payload, QByteArray("XYZ"));
    QVERIFY(client.acknowledge(lastBlock | 3).bytes.isEmpty());
    QVERIFY(client.acknowledge(lastBlock | 3).bytes.isEmpty());

    client.request(Service::LoadFile, "SMALL.JBI");
    const Answered taken = client.block(1, smallJob.first(40));
    QCOMPARE(client.block(1, smallJob.first(40)).bytes, taken.bytes);
    const Answered last = client.block(lastBlock | 2, smallJob.sliced(40));
    QCOMPARE(last.status, quint8(0));
    QCOMPARE(client.block(lastBlock | 2, smallJob.sliced(40)).bytes, last.bytes);
    QCOMPARE(memory.files.at("SMALL.JBI"), smallJob); // nothing was taken twice
}

void FileResponderTest::servesOneClientAtATime()
{
    Memory memory;
    memory.settings.blockSize = 100;
    Client first {memory};
    Client second {memory, "127.0.0.1:5001"};
    QCOMPARE(first.request(Service::SaveFile, "WELD_A12.JBI").status, quint8(0));
    QCOMPARE(second.request(Service::ListFiles, "*.JBI").code, quint16(0xE444));
    QCOMPARE(second.request(Service::DeleteFile, "HOME.JBI").code, quint16(0xE444));
    QCOMPARE(second.acknowledge(1).code, quint16(0xE4A2));
    Answered answer = first.acknowledge(1);
    while (!(blockOf(answer) & lastBlock))
        answer = first.acknowledge(blockOf(answer));
    QCOMPARE(second.request(Service::ListFiles, "*.JBI").code, quint16(0xE444)); // the last word is missing
    first.acknowledge(blockOf(answer));
    QCOMPARE(second.request(Service::ListFiles, "*.JBI").code, quint16(0));
}

void FileResponderTest::aNewRequestReplacesAStaleTransfer()
{
    Memory memory;
    Client client {memory};
    client.request(Service::LoadFile, "SMALL.JBI");
    client.block(1, smallJob.first(40));
    client.id = 9;
    client.request(Service::LoadFile, "SMALL.JBI");
    QCOMPARE(client.block(lastBlock | 1, smallJob).status, quint8(0));
    QCOMPARE(memory.files.at("SMALL.JBI"), smallJob);
}

void FileResponderTest::dropsASilentClient()
{
    Memory memory;
    memory.settings.blockSize = 100;
    Client first {memory};
    Client second {memory, "127.0.0.1:5001"};
    first.request(Service::SaveFile, "WELD_A12.JBI");
    first.now = 10s;
    QCOMPARE(first.acknowledge(1).code, quint16(0)); // ten seconds are just in time
    first.now = 20001ms;
    QCOMPARE(first.acknowledge(2).code, quint16(0xE28B));
    QCOMPARE(first.acknowledge(2).code, quint16(0xE4A2));
    first.request(Service::SaveFile, "WELD_A12.JBI");
    second.now = 40s;
    QCOMPARE(second.request(Service::ListFiles, "*.JBI").code, quint16(0));
}

void FileResponderTest::endsWithAChangeOfMode()
{
    Memory memory;
    memory.settings.blockSize = 100;
    Client client {memory};
    client.request(Service::SaveFile, "WELD_A12.JBI");
    setTeachMode(memory);
    QCOMPARE(client.acknowledge(1).code, quint16(0xFFFE));
    QCOMPARE(client.request(Service::SaveFile, "WELD_A12.JBI").code, quint16(0xE2B2));
}

void FileResponderTest::judgesFrames_data()
{
    QTest::addColumn<int>("at");
    QTest::addColumn<char>("value");
    QTest::addColumn<int>("code");
    QTest::newRow("identifier") << 0 << 'X' << -1;
    QTest::newRow("header size") << 4 << '!' << 0xE4A5;
    QTest::newRow("payload size") << 6 << '!' << 0xE4A7;
    QTest::newRow("robot division") << 9 << '\1' << 0xE4A3;
    QTest::newRow("ACK 2") << 10 << '\2' << 0xE4A2;
    QTest::newRow("command") << 24 << '\1' << 0xA000;
    QTest::newRow("instance") << 26 << '\1' << 0xA001;
    QTest::newRow("attribute") << 28 << '\1' << 0xA002;
}

void FileResponderTest::judgesFrames()
{
    QFETCH(int, at);
    QFETCH(char, value);
    QFETCH(int, code);
    Memory memory;
    QByteArray datagram = protocol::encode({0, 0, 0, Service::ListFiles, {}}, {protocol::Division::File, false, 1, 0});
    datagram[at] = value;
    const auto reply = respondFile(datagram, "peer", memory, 0ms);
    QCOMPARE(reply.has_value(), code >= 0);
    if (reply)
        QCOMPARE(int(protocol::parseReply(*reply)->addedStatus), code);
}

QTEST_GUILESS_MAIN(FileResponderTest)
#include "tst_fileresponder.moc"
