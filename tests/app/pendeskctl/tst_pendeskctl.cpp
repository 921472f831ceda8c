// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "journal/store.h"
#include "settings/profilestore.h"
#include "settings/settingsfile.h"
#include "virtualcontroller/server.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using virtualcontroller::Server;

namespace {

struct Ended {
    int code = -1;
    QByteArray out;
    QByteArray err;
};

/// A controller in this process, and the program as a person would call it.
class Terminal
{
public:
    explicit Terminal(
        protocol::Numbering numbering = protocol::Numbering::FromZero, protocol::Model model = protocol::Model::YRC1000)
    {
        virtualcontroller::Options options;
        options.port = 0;
        options.filePort = 0;
        options.settings.numbering = numbering;
        options.settings.model = model;
        server = std::make_unique<Server>(options);
        isStarted = server->start().has_value();
    }

    Ended run(const QString &line, bool withHost = true)
    {
        QStringList arguments = line.split(u' ', Qt::SkipEmptyParts);
        arguments.replaceInStrings(QStringLiteral("DIR"), folder.path());
        if (withHost)
            arguments << QStringLiteral("--host") << QStringLiteral("127.0.0.1") << QStringLiteral("--port")
                      << QString::number(server->port()) << QStringLiteral("--file-port")
                      << QString::number(server->filePort());
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("XDG_CONFIG_HOME"), folder.path());
        environment.insert(QStringLiteral("XDG_DATA_HOME"), folder.path());
        process.setProcessEnvironment(environment);
        QSignalSpy finished {&process, &QProcess::finished};
        process.start(QStringLiteral(PENDESK_BIN "/pendeskctl"), arguments);
        if (!finished.wait(30000))
            return {};
        return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
    }

    /// Stores the controller under the name "cell", as the window would.
    void keep(settings::Profile profile) const
    {
        settings::SettingsFile file {folder.filePath(QStringLiteral("pendesk/settings.json"))};
        profile.name = QStringLiteral("cell");
        profile.host = QStringLiteral("127.0.0.1");
        profile.port = server->port();
        profile.filePort = server->filePort();
        settings::ProfileStore {file}.save(profile);
    }

    [[nodiscard]] QString journal() const { return folder.filePath(QStringLiteral("pendesk/pendesk/journal.sqlite")); }
    QString bag()
    {
        const QDir controller {folder.filePath(QStringLiteral("bk/127.0.0.1"))};
        return controller.filePath(controller.entryList(QDir::Dirs | QDir::NoDotAndDotDot).value(0));
    }

    QTemporaryDir folder;
    std::unique_ptr<Server> server;
    bool isStarted = false;
};

QJsonDocument json(const Ended &ended) { return QJsonDocument::fromJson(ended.out); }

} // namespace

/// The program in a shell: words in, lines and exit codes out.
class TestPendeskctl : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void ends_data();
    void ends();
    void hasNoDangerousVerb();
    void needsNoWidgets();
    void readsForPeople_data();
    void readsForPeople();
    void readsInTheFewestPackets();
    void writesOnlyWhenTold();
    void writesWithAVerifiedProfile_data();
    void writesWithAVerifiedProfile();
    void writesAreInTheJournal();
    void asksWhichModelItIs_data();
    void asksWhichModelItIs();
    void transfersFiles();
    void backsUpAndRestores();
    void refusesAnotherRobot();
    void showsAndComparesInWords();
    void tellsWhereThingsAreUsed();
    void saysWhatCannotBeShown();
    void countsWordsWithoutAController();
    void readsForeignText();
    void checksJobs();
    void watches();
    void watchesOnAfterAGap();
};

void TestPendeskctl::ends_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<int>("code");
    const auto row = [](const char *line, int code) { QTest::newRow(line) << QString::fromLatin1(line) << code; };
    row("info", 0);
    row("position --json", 0);
    row("alarms", 0);
    row("alarms --history major --json", 0);
    row("alarms --history none", 2);
    row("jobs", 0);
    row("io get 1..10", 0);
    row("io get 10..1", 2);
    row("io get 9999", 2);
    row("io set 10010 1 --yes", 2);
    row("io set 27010 1", 2);
    row("io set 27010 2 --yes", 2);
    row("registers get 0..99", 0);
    row("registers get 0..1000", 2);
    row("registers set 600 1 --yes", 2);
    row("var get B005 S003 P000..P001 --numbering 0", 0);
    row("var get B005 --quiet", 0);
    row("var get X005", 2);
    row("var set B005 77 --yes", 2);
    row("var set B005 256 --yes --numbering 0", 2);
    row("var set B005 77 --yes --numbering 2", 2);
    row("var set P005 77 --yes --numbering 0", 2);
    row("var", 2);
    row("files get NONE.JBI --to DIR", 4);
    row("files get ../x --to DIR", 2);
    row("files put DIR/none.JBI --yes", 5);
    row("files rm HOME.JBI", 2);
    row("files move A B", 2);
    row("backup", 2);
    row("backup /proc/none", 5);
    row("compare DIR/none", 5);
    row("restore DIR/none --yes", 5);
    row("watch --count 1 B000 --numbering 0", 0);
    row("files get NONE*.JBI --to DIR", 7);
    row("watch --every soon B000", 2);
    row("info --unknown", 2);
    row("status R2", 2);
    row("info now", 2);
    row("alarms minor", 2);
    row("jobs W*", 2);
    row("position R1", 0);
    row("position R2", 4); // the controller has one robot
    row("position R9", 2);
    row("position X", 2);
    row("position R1 R2", 2);
    row("backup DIR/a DIR/b", 2);
    row("backup DIR/a --keep many", 2);
    row("backup DIR/a --keep -1", 2);
    row("watch", 2);
    row("files", 2);
    row("info --encoding none", 2);
    row("var get B150 --numbering 0", 4); // asked, and refused
    row("var set B150 1 --numbering 0 --yes", 4);
}

void TestPendeskctl::ends()
{
    QFETCH(QString, line);
    QFETCH(int, code);
    Terminal terminal;
    QVERIFY(terminal.isStarted);
    const Ended ended = terminal.run(line);
    QVERIFY2(ended.code == code, ended.out + ended.err);
    QCOMPARE(ended.err.isEmpty(), code == 0 && line != u"alarms");
}

void TestPendeskctl::hasNoDangerousVerb()
{
    Terminal terminal;
    const QByteArray help = terminal.run(QStringLiteral("--help"), false).out;
    for (const char *verb : {"move", "jog", "start", "servo", "select", "hold"}) {
        QVERIFY(!help.contains(verb));
        QCOMPARE(terminal.run(QString::fromLatin1(verb)).code, 2);
    }
}

void TestPendeskctl::needsNoWidgets()
{
    QProcess ldd;
    ldd.start(QStringLiteral("ldd"), {QStringLiteral(PENDESK_BIN "/pendeskctl")});
    QVERIFY(ldd.waitForFinished());
    const QByteArray libraries = ldd.readAllStandardOutput();
    QVERIFY(
        libraries.contains("libQt6Core") && !libraries.contains("libQt6Gui") && !libraries.contains("libQt6Widgets"));
}

void TestPendeskctl::readsForPeople_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QByteArray>("out"); // a part of it
    QTest::addColumn<QByteArray>("err"); // a part of it
    QTest::addRow("unit") << QStringLiteral("position") << QByteArray(" mm\n") << QByteArray();
    QTest::addRow("axis") << QStringLiteral("position --pulse") << QByteArray("S ") << QByteArray();
    QTest::addRow("unverified numbering")
        << QStringLiteral("var get B005") << QByteArray("B005  ") << QByteArray("RS022");
    QTest::addRow("failed file") << QStringLiteral("files get NONE.JBI --to DIR") << QByteArray("NONE.JBI  failed")
                                 << QByteArray("NONE.JBI: 0xE2B3");
    QTest::addRow("words") << QStringLiteral("jobs W*") << QByteArray() << QByteArray("jobs does not take “W*”");
    QTest::addRow("encodings in the help")
        << QStringLiteral("info --help") << QByteArray("Shift_JIS, GBK") << QByteArray();
    QTest::addRow("help") << QStringLiteral("files --help") << QByteArray("[options] ls [PATTERN] | get NAME")
                          << QByteArray();
}

void TestPendeskctl::readsForPeople()
{
    QFETCH(QString, line);
    QFETCH(QByteArray, out);
    QFETCH(QByteArray, err);
    Terminal terminal;
    const Ended ended = terminal.run(line);
    QVERIFY2(ended.out.contains(out), ended.out);
    QVERIFY2(ended.err.contains(err), ended.err);
}

void TestPendeskctl::readsInTheFewestPackets()
{
    Terminal terminal;
    for (int number = 0; number < 100; ++number)
        terminal.server->memory().d[std::size_t(number)].value = number * 3;
    const Ended ended = terminal.run(QStringLiteral("var get D000..D099 --json"));
    QCOMPARE(ended.code, 0);
    QCOMPARE(json(ended).object().value(u"D099").toInt(), 297);
    QCOMPARE(json(ended).object().size(), 100);
    QCOMPARE(terminal.server->asked(0x304), 1); // 118 fit into one packet (reference §4.5)
    QCOMPARE(terminal.server->arrived(0x7C), 0);
}

void TestPendeskctl::writesOnlyWhenTold()
{
    Terminal terminal;
    auto &memory = terminal.server->memory();
    QCOMPARE(terminal.run(QStringLiteral("var set B005 77 --yes --numbering 0")).code, 0);
    QCOMPARE(memory.b[5].value, quint8(77));
    QCOMPARE(terminal.run(QStringLiteral("var set S003 PART --yes --numbering 0")).code, 0);
    QCOMPARE(memory.s[3].value.bytes().toByteArray(), "PART");
    QCOMPARE(terminal.run(QStringLiteral("registers set 5 123 --yes")).code, 0);
    QCOMPARE(memory.registers[5].value, quint16(123));
    QCOMPARE(terminal.run(QStringLiteral("io set 27012 1 --yes")).code, 0);
    QCOMPARE(memory.io[2701], quint8(4));
    QCOMPARE(terminal.run(QStringLiteral("var set I005 -7 --yes --numbering 0")).code, 0);
    QCOMPARE(memory.i[5].value, qint16(-7));
    QCOMPARE(terminal.run(QStringLiteral("var set --numbering 0 R001 -.5 --yes")).code, 0);
    QCOMPARE(memory.r[1].value, -0.5F);
    memory.resizeVariables(250, 128);
    QCOMPARE(terminal.run(QStringLiteral("var set B249 9 --yes --numbering 0")).code, 0);
    QCOMPARE(memory.b[249].value, quint8(9));
    QCOMPARE(terminal.run(QStringLiteral("var get B000..B248 --numbering 0")).code, 0); // an odd number of bytes
    QCOMPARE(terminal.run(QStringLiteral("registers set 5 1")).code, 2);
    QCOMPARE(memory.registers[5].value, quint16(123));
}

void TestPendeskctl::writesWithAVerifiedProfile_data()
{
    QTest::addColumn<QString>("software"); // that it was verified with; empty: never
    QTest::addColumn<QString>("options");
    QTest::addColumn<int>("code");
    const auto row = [](const char *name, const char *software, const char *options, int code) {
        QTest::newRow(name) << QString::fromLatin1(software) << QString::fromLatin1(options) << code;
    };
    row("never", "", "", 2);
    row("verified", "PENDESK VIRTUAL 1.00-00", "", 0);
    row("with other software", "PENDESK VIRTUAL 0.99-00", "", 4);
    row("told", "", "--numbering 1", 0);
    row("told after other software", "PENDESK VIRTUAL 0.99-00", "--numbering 1", 0);
    row("at another address", "PENDESK VIRTUAL 1.00-00", "--host localhost", 2);
}

/// A controller whose B000 is instance 1: a wrong numbering would write the neighbour.
void TestPendeskctl::writesWithAVerifiedProfile()
{
    QFETCH(QString, software);
    QFETCH(QString, options);
    QFETCH(int, code);
    Terminal terminal {protocol::Numbering::FromOne};
    settings::Profile profile;
    profile.numbering = protocol::Numbering::FromOne;
    profile.numberingSoftware = software;
    if (!software.isEmpty())
        profile.numberingVerified = QDateTime::currentDateTimeUtc();
    terminal.keep(profile);
    const Ended ended = terminal.run(QStringLiteral("var set B005 77 --yes --profile cell ") + options, false);
    QVERIFY2(ended.code == code, ended.out + ended.err);
    QCOMPARE(terminal.server->memory().b[5].value, quint8(code == 0 ? 77 : 0));
    QCOMPARE(terminal.server->asked(0x7A), code == 0 ? 2 : 0); // the write, and the read back
}

/// What was written, refused and withheld is kept where the window keeps it.
void TestPendeskctl::writesAreInTheJournal()
{
    Terminal terminal;
    QCOMPARE(terminal.run(QStringLiteral("var get B005")).code, 0);
    QVERIFY(!QFile::exists(terminal.journal())); // whoever only reads keeps nothing
    QCOMPARE(terminal.run(QStringLiteral("var set B005 77 --yes --numbering 0")).code, 0);
    QCOMPARE(terminal.run(QStringLiteral("io set 27012 1 --yes")).code, 0);
    terminal.server->memory().status.data1.setFlag(values::Status::Remote, false);
    QCOMPARE(terminal.run(QStringLiteral("files rm HOME.JBI --yes --to DIR/copies")).code, 4); // REMOTE is off
    journal::Store journal {QUrl::fromLocalFile(terminal.journal())};
    QList<journal::OrderRecord> records;
    bool isRead = false;
    journal.orders({}, {}, 100, this, [&](const auto &page) {
        isRead = page.has_value();
        records = isRead ? page->records : records;
    });
    QTRY_VERIFY(isRead);
    QCOMPARE(records.size(), 3); // the newest first
    QCOMPARE(records[2].action, QStringLiteral("write-variable"));
    QCOMPARE(records[2].subject, QStringLiteral("B005"));
    QCOMPARE(records[2].newValue, QStringLiteral("77"));
    QCOMPARE(records[2].level, QStringLiteral("Engineer"));
    QCOMPARE(records[2].controller, QStringLiteral("127.0.0.1"));
    QVERIFY(records[2].outcome == journal::Outcome::Done);
    QCOMPARE(records[1].action, QStringLiteral("write-io"));
    QCOMPARE(records[0].action, QStringLiteral("delete-file"));
    QVERIFY(records[0].outcome == journal::Outcome::Withheld);
}

void TestPendeskctl::asksWhichModelItIs_data()
{
    QTest::addColumn<int>("model");
    QTest::addColumn<QByteArray>("software"); // that 0x89 tells
    QTest::addColumn<QString>("line");
    QTest::addColumn<int>("code");
    using protocol::Model;
    const auto row = [](const char *name, Model model, const char *software, const char *line, int code) {
        QTest::newRow(name) << int(model) << QByteArray(software) << QString::fromLatin1(line) << code;
    };
    // 16 bytes a string and network inputs from 2501 on: reference §4.1, §4.3
    row("DX100 told", Model::DX100, "DS3.00", "var set S003 AB --yes --numbering 0 --model dx100", 0);
    row("DX100 long", Model::DX100, "DS3.00", "var set S003 ABCDEFGHIJKLMNOP --yes --numbering 0 --model dx100", 0);
    row("DX100 input", Model::DX100, "DS3.00", "io set 25010 1 --yes --model dx100", 0);
    row("FS100 found", Model::FS100, "FS3.00", "var set S003 AB --yes --numbering 0", 0);
    row("YRC1000 found", Model::YRC1000, "YAS2.94", "io set 27010 1 --yes", 0);
    row("no input of a YRC1000", Model::YRC1000, "YAS2.94", "io set 25010 1 --yes", 2);
    row("no model", Model::YRC1000, "YAS2.94", "info --model robot", 2);
}

void TestPendeskctl::asksWhichModelItIs()
{
    QFETCH(int, model);
    QFETCH(QByteArray, software);
    QFETCH(QString, line);
    QFETCH(int, code);
    Terminal terminal {protocol::Numbering::FromZero, protocol::Model(model)};
    terminal.server->memory().systemInformation[11].software = values::FixedText<24> {software};
    const Ended ended = terminal.run(line);
    QVERIFY2(ended.code == code, ended.out + ended.err);
}

void TestPendeskctl::transfersFiles()
{
    Terminal terminal;
    auto &files = terminal.server->memory().files;
    const QByteArray home = files["HOME.JBI"];
    QCOMPARE(terminal.run(QStringLiteral("files get *.JBI VARNAME.DAT --to DIR/in")).code, 0);
    QFile local {terminal.folder.filePath(QStringLiteral("in/HOME.JBI"))};
    QVERIFY(local.open(QIODevice::ReadOnly));
    QCOMPARE(local.readAll(), home);
    QCOMPARE(terminal.run(QStringLiteral("files get HOME.JBI --to DIR/in")).code, 7); // it exists
    files["HOME.JBI"] = "changed";
    QCOMPARE(terminal.run(QStringLiteral("files put DIR/in/HOME.JBI --yes")).code, 7);
    QCOMPARE(files["HOME.JBI"], "changed");
    const Ended put = terminal.run(QStringLiteral("files put DIR/in/HOME.JBI --yes --replace --json"));
    QCOMPARE(put.code, 0);
    QCOMPARE(json(put).array().at(0).toObject().value(u"result").toString(), QStringLiteral("identical"));
    QCOMPARE(files["HOME.JBI"], home);
    QCOMPARE(terminal.run(QStringLiteral("files rm HOME.JBI --yes --to DIR/copies")).code, 0);
    QVERIFY(!files.contains("HOME.JBI"));
    QVERIFY(QFile::exists(terminal.folder.filePath(QStringLiteral("copies/HOME.JBI"))));
    terminal.server->memory().status.data1 |= values::Status::Running;
    terminal.server->memory().isJobRunning = true;
    QCOMPARE(terminal.run(QStringLiteral("files put DIR/in/HOME.JBI --yes --replace")).code, 4);
}

void TestPendeskctl::backsUpAndRestores()
{
    Terminal terminal;
    auto &files = terminal.server->memory().files;
    QCOMPARE(terminal.run(QStringLiteral("backup DIR/bk")).code, 0);
    const QString bag = terminal.bag();
    QCOMPARE(terminal.run(QStringLiteral("verify ") + bag, false).code, 0);
    QCOMPARE(terminal.run(QStringLiteral("compare ") + bag).code, 0);
    const QByteArray weld = files["WELD_A12.JBI"];
    files["WELD_A12.JBI"] = QByteArray(weld).replace("V=25.0", "V=50.0");
    const Ended compared = terminal.run(QStringLiteral("compare --json ") + bag);
    QCOMPARE(compared.code, 1);
    const auto change = json(compared).array().at(0).toObject();
    QCOMPARE(change.value(u"name").toString(), QStringLiteral("WELD_A12.JBI"));
    QCOMPARE(change.value(u"edits").toArray().at(0).toString(), QStringLiteral("Line 8 MOVL: V 25.0 → 50.0"));
    QCOMPARE(terminal.run(QStringLiteral("restore --dry-run ") + bag).code, 1);
    QCOMPARE(terminal.run(QStringLiteral("restore ") + bag).code, 2);
    QVERIFY(files["WELD_A12.JBI"] != weld);
    const Ended restored = terminal.run(QStringLiteral("restore --yes %1 WELD_A12.JBI").arg(bag));
    QVERIFY2(restored.code == 0, restored.err);
    QCOMPARE(files["WELD_A12.JBI"], weld);
    QVERIFY(QFile::remove(bag + QStringLiteral("/data/HOME.JBI")));
    QCOMPARE(terminal.run(QStringLiteral("verify ") + bag, false).code, 6);
    QCOMPARE(terminal.run(QStringLiteral("restore --yes ") + bag).code, 6);
    QCOMPARE(terminal.run(QStringLiteral("compare ") + bag).code, 6);
    QCOMPARE(terminal.run(QStringLiteral("compare %1 %1").arg(bag), false).code, 6);
    files["EMPTY.DAT"] = "";
    QCOMPARE(terminal.run(QStringLiteral("backup DIR/bk")).code, 7);
}

void TestPendeskctl::refusesAnotherRobot()
{
    Terminal terminal;
    auto &files = terminal.server->memory().files;
    QCOMPARE(terminal.run(QStringLiteral("backup DIR/bk")).code, 0);
    const QString bag = terminal.bag();
    terminal.server->memory().systemInformation[11].model = values::FixedText<16> {"1-06VX88-A0*"};
    files["HOME.JBI"].replace("VJ=10.00", "VJ=20.00");
    const auto before = files;
    const auto writes = [&] {
        const auto &arrived = terminal.server->arrivals().files;
        return arrived.count(protocol::Service::LoadFile) + arrived.count(protocol::Service::DeleteFile);
    };
    const Ended refused = terminal.run(QStringLiteral("restore --yes ") + bag);
    QCOMPARE(refused.code, 4);
    QVERIFY2(refused.err.contains("VIRTUAL-A00") && refused.err.contains("1-06VX88-A0*"), refused.err);
    QCOMPARE(terminal.run(QStringLiteral("restore --yes %1 ABSO.DAT TOOL.CND VAR.DAT").arg(bag)).code, 4);
    QCOMPARE(writes(), 0U);
    QVERIFY(files == before);
    // One job that an engineer names may be sent.
    QCOMPARE(terminal.run(QStringLiteral("restore --yes %1 HOME.JBI").arg(bag)).code, 0);
    QVERIFY(files["HOME.JBI"].contains("VJ=10.00"));
}

/// The expectations stand in the list that came with the sample jobs.
void TestPendeskctl::tellsWhereThingsAreUsed()
{
    Terminal terminal;
    const QString jobs = QStringLiteral(PENDESK_TEST_DATA "/jobs");
    const Ended uses = terminal.run(QStringLiteral("xref %1 B003 OT#(24) RELUSER2 B088").arg(jobs), false);
    QCOMPARE(uses.code, 0);
    QVERIFY2(uses.out.contains("RELUSER line 8") && uses.out.contains("MAIN-FLOW line 2"), uses.out);
    QVERIFY2(uses.out.contains("CALL JOB:RELUSER2 UF#(4) IF B003>=2"), uses.out);
    const QJsonObject inJson = json(terminal.run(QStringLiteral("xref %1 OT#(24) --json").arg(jobs), false)).object();
    const QJsonArray ofOutput = inJson[u"OT#(24)"].toArray();
    const auto use = std::find_if(ofOutput.begin(), ofOutput.end(),
        [](const QJsonValue &each) { return each[u"name"].toString() == u"MAIN-FLOW"; });
    QVERIFY(use != ofOutput.end());
    QCOMPARE((*use)[u"how"].toString(), QStringLiteral("writes"));
    QCOMPARE((*use)[u"line"].toInt(), 2);
    QCOMPARE((*use)[u"through"].toString(), QStringLiteral("OG#(3)"));
    const Ended calls = terminal.run(QStringLiteral("calls %1").arg(jobs), false);
    QVERIFY2(calls.out.contains("MAIN-FLOW line 15  PULSE6\n"), calls.out);
    const QJsonArray tree = json(terminal.run(QStringLiteral("calls %1 --json").arg(jobs), false)).array();
    const auto isMissing = [](const QJsonValue &call) { return call[u"missing"].toBool(); };
    QCOMPARE(std::count_if(tree.begin(), tree.end(), isMissing), 1); // RELUSER2
    const Ended unused = terminal.run(QStringLiteral("unused %1").arg(jobs), false);
    QVERIFY2(unused.out.contains("RELUSER2"), unused.out);
    QCOMPARE(terminal.run(QStringLiteral("xref %1").arg(jobs), false).code, 2);
    QCOMPARE(terminal.run(QStringLiteral("calls %1/none").arg(jobs), false).code, 5);
}

void TestPendeskctl::showsAndComparesInWords()
{
    Terminal terminal;
    const QString cell = QStringLiteral(PENDESK_TEST_DATA "/cell/");
    const Ended shown =
        terminal.run(QStringLiteral("show --json %1yrc1000/IPNETCFG.DAT %1yrc1000/TOOL.CND").arg(cell), false);
    QCOMPARE(shown.code, 0);
    QVERIFY(!shown.out.contains("10.20.30.40") && !shown.out.contains("A1B2C3D4") && !shown.out.contains("cellbackup"));
    const auto tools =
        json(shown).object()[cell + QStringLiteral("yrc1000/TOOL.CND")][u"TOOL.CND"][u"tables"][u"tools"];
    QCOMPARE(tools[1][u"name"].toString(), QStringLiteral("GRIPPER A"));
    QCOMPARE(tools[1][u"weight kg"].toDouble(), 4.2);
    QCOMPARE(terminal.run(QStringLiteral("show %1damaged/EMPTY.DAT").arg(cell), false).code, 0);
    QCOMPARE(terminal.run(QStringLiteral("show %1none").arg(cell), false).code, 5);
    const Ended same = terminal.run(QStringLiteral("compare %1yrc1000/FD.PRM %1yrc1000-later/FD.PRM").arg(cell), false);
    QCOMPARE(same.code, 0); // the check line is another one at every save
    const Ended later =
        terminal.run(QStringLiteral("compare %1yrc1000/TOOL.CND %1yrc1000-later/TOOL.CND").arg(cell), false);
    QCOMPARE(later.code, 1);
    QVERIFY2(later.out.contains("! Tool 1 “GRIPPER A”: point moved 1.75 mm (Z 163.250 → 165.000)"), later.out);
}

/// What JSON cannot hold is null, and nothing that a controller sends does anything to a terminal.
void TestPendeskctl::saysWhatCannotBeShown()
{
    Terminal terminal;
    auto &memory = terminal.server->memory();
    memory.r[1].value = std::numeric_limits<float>::quiet_NaN();
    memory.r[2].value = -std::numeric_limits<float>::infinity();
    const QJsonObject values = json(terminal.run(QStringLiteral("var get R000..R002 --numbering 0 --json"))).object();
    QCOMPARE(values.value(u"R000").toDouble(), 12.5);
    QVERIFY(values.contains(u"R001") && values.value(u"R001").isNull());
    QVERIFY(!values.value(u"R001_text").toString().isEmpty());
    QVERIFY(values.contains(u"R002") && values.value(u"R002").isNull());
    QVERIFY(!values.contains(u"R000_text"));
    const QByteArray encodings = terminal.run(QStringLiteral("decode --encoding none 00"), false).err;
    QVERIFY2(encodings.contains("ISO-8859-1, UTF-8, Shift_JIS"), encodings);
    const QByteArray models = terminal.run(QStringLiteral("decode --model none 00"), false).err;
    QVERIFY2(models.contains("dx100, dx200"), models);
    memory.s[3].value = values::FixedText<32> {"\x1b[2J\r\nR002  1\x9b"
                                               "31m"};
    const Ended text = terminal.run(QStringLiteral("var get S003 --numbering 0"));
    QCOMPARE(text.out, QByteArray("S003  ⟨1B⟩[2J⟨0D⟩⟨0A⟩R002  1⟨9B⟩31m\n"));
    const Ended inJson = terminal.run(QStringLiteral("var get S003 --numbering 0 --json"));
    QVERIFY(!inJson.out.contains('\x1b') && !inJson.out.contains("\xc2\x9b"));
    // A byte that is no text is marked, as everywhere; what is ASCII stays what it was.
    QCOMPARE(json(inJson).object().value(u"S003").toString(), QStringLiteral("\x1b[2J\r\nR002  1⟨9B⟩31m"));
}

/// The verbs that need no controller count their words too.
void TestPendeskctl::countsWordsWithoutAController()
{
    Terminal terminal;
    for (const char *verb : {"verify", "show", "check"}) {
        const QString name = QString::fromLatin1(verb);
        QCOMPARE(terminal.run(name, false).code, 2);
        QVERIFY(terminal.run(name + QStringLiteral(" DIR/none"), false).code != 2);
    }
}

void TestPendeskctl::readsForeignText()
{
    Terminal terminal;
    auto &memory = terminal.server->memory();
    virtualcontroller::ActiveAlarm alarm;
    alarm.alarm.alarm = {4416, {}, values::FixedText<16> {"2026/01/31 08:30"}, values::FixedText<32> {"\x83\x65"}};
    memory.alarms.push_front(alarm);
    memory.systemInformation[11].model = values::FixedText<16> {"\x83\x65"};
    for (const char *verb : {"alarms", "info", "status"}) {
        const Ended ended = terminal.run(QString::fromLatin1(verb) + QStringLiteral(" --encoding Shift_JIS"));
        QVERIFY2(ended.code == 0, ended.err);
    }
    QVERIFY(terminal.run(QStringLiteral("alarms --encoding Shift_JIS")).out.contains("テ"));
    QVERIFY(terminal.run(QStringLiteral("info --encoding Shift_JIS")).out.contains("テ"));
}

void TestPendeskctl::checksJobs()
{
    const QString folder = QStringLiteral(PENDESK_TEST_DATA "/jobs");
    Terminal terminal;
    QCOMPARE(terminal.run(QStringLiteral("check %1").arg(folder), false).code, 0);
    QCOMPARE(terminal.run(QStringLiteral("check %1/broken").arg(folder), false).code, 1);
    QCOMPARE(terminal.run(QStringLiteral("check %1/broken/UNKNOWN-WORD.JBI").arg(folder), false).code, 0);
    const Ended ended = terminal.run(QStringLiteral("check --json %1/broken/NO-LABEL.JBI").arg(folder), false);
    QCOMPARE(ended.code, 1);
    const auto finding = json(ended).array().at(0).toObject();
    QCOMPARE(finding.value(u"severity").toString(), QStringLiteral("error"));
    QCOMPARE(finding.value(u"fileLine").toInt(), 17);
    QCOMPARE(finding.value(u"jobLine").toInt(), 3);
    QCOMPARE(finding.value(u"what").toString(), QStringLiteral("Line 3 (17 in the file): There is no label *AGAIN."));
    QCOMPARE(terminal.run(QStringLiteral("check"), false).code, 2);
    QCOMPARE(terminal.run(QStringLiteral("check DIR/no.JBI"), false).code, 5);
}

void TestPendeskctl::watches()
{
    Terminal terminal;
    const Ended ended = terminal.run(QStringLiteral("watch --every 20ms --count 3 --json B000 M005"));
    QCOMPARE(ended.code, 0);
    QCOMPARE(ended.out.trimmed().split('\n').size(), 3);
}

/// The third reading is not answered at all.
void TestPendeskctl::watchesOnAfterAGap()
{
    Terminal terminal;
    terminal.server->setFaults(
        *virtualcontroller::Faults::parse(QStringLiteral("seed=1; 0x79 request lose after=2 times=3")));
    const Ended ended = terminal.run(QStringLiteral("watch --every 20ms --count 4 --json --timeout 20ms --quiet M005"));
    QVERIFY2(ended.code == 0, ended.err);
    QCOMPARE(ended.out.trimmed().split('\n').size(), 4);
    QVERIFY(ended.err.contains("did not answer") && ended.err.contains("Answers again"));
}

QTEST_GUILESS_MAIN(TestPendeskctl)

#include "tst_pendeskctl.moc"
