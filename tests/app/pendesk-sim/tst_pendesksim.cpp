// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/requests.h"
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QUdpSocket>
#include <csignal>

namespace {

const QStringList onFreePorts {
    QStringLiteral("--port"), QStringLiteral("0"), QStringLiteral("--file-port"), QStringLiteral("0")};

/// A pendesk-sim that is ended with the test.
struct Simulator {
    QProcess process;
    QString ready; ///< Its line when it is ready.
    quint16 port = 0;

    explicit Simulator(const QStringList &arguments)
    {
        process.start(QStringLiteral(PENDESK_BIN "/pendesk-sim"), arguments);
        if (!QTest::qWaitFor([this] { return process.canReadLine() || process.state() == QProcess::NotRunning; }))
            return;
        ready = QString::fromUtf8(process.readLine()).trimmed();
        static const QRegularExpression portPattern {QStringLiteral(":(\\d+),")};
        port = portPattern.match(ready).captured(1).toUShort();
    }
    ~Simulator()
    {
        process.kill();
        process.waitForFinished();
    }
    bool ends(int exitCode)
    {
        return QTest::qWaitFor([this] { return process.state() == QProcess::NotRunning; })
            && process.exitStatus() == QProcess::NormalExit && process.exitCode() == exitCode;
    }
};

/// The payload that answers one request.
QByteArray ask(quint16 port, const protocol::Request &request)
{
    QUdpSocket socket;
    socket.connectToHost(QHostAddress::LocalHost, port);
    socket.write(protocol::encode(request, {protocol::Division::Robot, false, 1, 0}));
    if (!QTest::qWaitFor([&socket] { return socket.hasPendingDatagrams(); }))
        return {};
    return socket.read(512).sliced(protocol::headerSize);
}

QString written(const QTemporaryDir &folder, const char *name, const QByteArray &contents)
{
    QFile file {folder.filePath(QLatin1StringView {name})};
    if (file.open(QIODevice::WriteOnly))
        file.write(contents);
    return file.fileName();
}

} // namespace

class PendeskSimTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void saysWhenItIsReady();
    void servesSeveral();
    void endsOnSignals_data();
    void endsOnSignals();
    void startsAsTold();
    void explainsMistakes_data();
    void explainsMistakes();
    void saysWhenAPortIsTaken();
};

void PendeskSimTest::saysWhenItIsReady()
{
    Simulator simulator {onFreePorts};
    static const QRegularExpression line {
        QStringLiteral("^pendesk-sim: YRC1000 ready on 127\\.0\\.0\\.1:\\d+, files \\d+$")};
    QVERIFY2(line.match(simulator.ready).hasMatch(), qPrintable(simulator.ready));
    // Remote play, one cycle, servo off, idle.
    QCOMPARE(ask(simulator.port, protocol::ReadStatus {}.request()).toHex(), QByteArray("c200000000000000"));
}

void PendeskSimTest::servesSeveral()
{
    Simulator simulator {onFreePorts + QStringList {QStringLiteral("--count"), QStringLiteral("16")}};
    QCOMPARE(simulator.ready.count(QStringLiteral("files")), 16);
    for (const QString &one : simulator.ready.split(u';')) {
        const quint16 port = one.section(u':', -1).section(u',', 0, 0).toUShort();
        QCOMPARE(ask(port, protocol::ReadStatus {}.request()).size(), qsizetype(8));
    }
}

void PendeskSimTest::endsOnSignals_data()
{
    QTest::addColumn<int>("signal");
    QTest::newRow("SIGINT") << SIGINT;
    QTest::newRow("SIGTERM") << SIGTERM;
}

void PendeskSimTest::endsOnSignals()
{
    QFETCH(int, signal);
    Simulator simulator {onFreePorts};
    QVERIFY(!simulator.ready.isEmpty());
    ::kill(pid_t(simulator.process.processId()), signal);
    QVERIFY(simulator.ends(0));
}

void PendeskSimTest::startsAsTold()
{
    QTemporaryDir folder;
    const QString state = written(folder, "state.json", R"({"variables": {"B007": 42}, "status": {"servo": true}})");
    const QString script = written(folder, "script.json", R"([{"at": 0, "hold": "pendant", "on": true}])");
    Simulator simulator {onFreePorts
        + QStringList {QStringLiteral("--model"), QStringLiteral("FS100"), QStringLiteral("--numbering"),
            QStringLiteral("1"), QStringLiteral("--state"), state, QStringLiteral("--script"), script,
            QStringLiteral("--files"), folder.path()}};
    QVERIFY2(simulator.ready.contains(QStringLiteral(" FS100 ready")), simulator.process.readAllStandardError());
    QCOMPARE(ask(simulator.port, protocol::ReadStatus {}.request()).toHex(), QByteArray("c200000042000000"));
    QCOMPARE(ask(simulator.port, {0x7A, 8, 1, protocol::Service::GetSingle}), QByteArray(1, 42));
    Simulator demo {onFreePorts + QStringList {QStringLiteral("--demo")}};
    QCOMPARE(ask(demo.port, protocol::ReadStatus {}.request()).toHex(), QByteArray("cc00000040000000"));
}

void PendeskSimTest::explainsMistakes_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QString>("part");
    const auto row = [](const char *arguments, int exitCode, const char *part) {
        QTest::newRow(arguments) << QString::fromLatin1(arguments).split(u' ') << exitCode << QString::fromLatin1(part);
    };
    row("--bogus", 2, "bogus");
    row("robot", 2, "\"robot\" is not an option.");
    row("--port 65536", 2, "--port takes a number");
    row("--port x", 2, "--port takes a number");
    row("--numbering 2", 2, "--numbering takes a number");
    row("--model nx100", 2, "--model does not know \"nx100\".");
    row("--count 0", 2, "--count takes a number");
    row("--faults boom", 2, "--faults: \"boom\"");
    row("--state /nowhere/state.json", 1, "/nowhere/state.json cannot be read");
    row("--files /nowhere", 1, "/nowhere is not a folder.");
    row("--host nowhere", 1, "nowhere is not an IP address.");
}

void PendeskSimTest::explainsMistakes()
{
    QFETCH(QStringList, arguments);
    QFETCH(int, exitCode);
    QFETCH(QString, part);
    Simulator simulator {arguments};
    QVERIFY(simulator.ends(exitCode));
    QVERIFY(simulator.ready.isEmpty());
    const QString errors = QString::fromUtf8(simulator.process.readAllStandardError());
    QVERIFY2(errors.section(u'\n', 0, 0).contains(part), qPrintable(errors));
    QCOMPARE(errors.contains(QStringLiteral("Usage:")), exitCode == 2);
}

void PendeskSimTest::saysWhenAPortIsTaken()
{
    QUdpSocket socket;
    QVERIFY(socket.bind(QHostAddress::LocalHost, 0, QAbstractSocket::DontShareAddress));
    const QString port = QString::number(socket.localPort());
    Simulator simulator {{QStringLiteral("--port"), port, QStringLiteral("--file-port"), QStringLiteral("0")}};
    QVERIFY(simulator.ends(1));
    QVERIFY(simulator.process.readAllStandardError().contains("UDP port " + port.toLatin1()));
}

QTEST_GUILESS_MAIN(PendeskSimTest)
#include "tst_pendesksim.moc"
