// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/golden.h"
#include "traffic/capture.h"

#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>

using namespace traffic;
using namespace std::chrono_literals;
using protocol::Division;

namespace {

constexpr Endpoint desk {0x0A000005, 50001};
constexpr Endpoint robot {0x0A000014, 10040};
constexpr Endpoint files {0x0A000014, 10041};
const WallTime begin {std::chrono::seconds {1'700'000'000} + 123'456us};

/// Every packet of the golden file, as if it had passed our sockets one after the other.
QList<Packet> goldenPackets()
{
    QList<Packet> packets;
    for (const golden::Exchange &exchange : golden::exchanges()) {
        for (const golden::Packet &golden : exchange.packets) {
            const auto division = Division(golden.bytes[9]); // reference §1.1
            Packet packet;
            packet.number = quint64(packets.size() + 1);
            packet.at = begin + std::chrono::microseconds {packets.size() * 1500};
            packet.passage = golden.isFromClient ? Passage::Sent : Passage::Received;
            packet.division = division;
            packet.own = desk;
            packet.other = division == Division::File ? files : robot;
            packet.bytes = golden.bytes;
            packets << packet;
        }
    }
    return packets;
}

/// What a capture cannot say is left out of the comparison: who answered whom is found anew.
Packet withoutPartner(Packet packet)
{
    packet.partner = 0;
    packet.fate = Fate::Used;
    return packet;
}

template <typename Number> QByteArray big(Number value)
{
    value = qToBigEndian(value);
    return QByteArray {reinterpret_cast<const char *>(&value), sizeof value};
}

QByteArray udpIn(const QByteArray &payload, quint16 from, quint16 to)
{
    return big(from) + big(to) + big(quint16(payload.size() + 8)) + big(quint16(0)) + payload;
}

/// An IPv4 packet written by hand (RFC 791); `flags` is the word of flags and fragment offset.
QByteArray ipv4(const QByteArray &content, quint16 flags = 0, quint8 protocolNumber = 17, int optionWords = 0)
{
    return big(quint8(0x45 + optionWords)) + big(quint8(0)) + big(quint16(20 + 4 * optionWords + content.size()))
        + big(quint16(1)) + big(flags) + big(quint8(64)) + big(protocolNumber) + big(quint16(0)) + big(desk.address)
        + big(robot.address) + QByteArray(4 * optionWords, '\1') + content;
}

QByteArray aRequest() { return golden::exchanges().first().packets.first().bytes; }

/// A capture in the older format pcap, little-endian, with one frame.
QByteArray pcap(quint32 linkType, const QByteArray &frame, qsizetype kept = -1)
{
    const auto little = [](auto value) {
        value = qToLittleEndian(value);
        return QByteArray {reinterpret_cast<const char *>(&value), sizeof value};
    };
    const QByteArray head = little(quint32(0xA1B2C3D4)) + little(quint16(2)) + little(quint16(4)) + little(quint32(0))
        + little(quint32(0)) + little(quint32(65535)) + little(linkType);
    const QByteArray data = frame.left(kept < 0 ? frame.size() : kept);
    return head + little(quint32(1'700'000'000)) + little(quint32(42)) + little(quint32(data.size()))
        + little(quint32(frame.size())) + data;
}

QByteArray etherFrame(const QByteArray &content, const QByteArray &type = QByteArray("\x08\x00", 2))
{
    return QByteArray(12, '\x02') + type + content;
}

} // namespace

class TestCapture : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsWrittenIsRead()
    {
        const QList<Packet> packets = goldenPackets();
        QVERIFY(packets.size() > 50);
        const auto capture = readCapture(toPcapng(packets, [](const Packet &) { return QStringLiteral("ä comment"); }));
        QVERIFY(capture);
        QCOMPARE(capture->packets.size(), packets.size());
        for (qsizetype i = 0; i < packets.size(); ++i)
            QCOMPARE(withoutPartner(capture->packets[i]), withoutPartner(packets[i]));
        QCOMPARE(capture->others, qsizetype {0});
        QCOMPARE(capture->fragments, qsizetype {0});
        QVERIFY(capture->controllers.contains(robot) && capture->controllers.contains(files));
        QVERIFY(capture->trouble.isEmpty());
        QCOMPARE(capture->packets[1].partner, quint64 {1}); // the reply of the first exchange
    }

    void nothingIsACaptureToo()
    {
        const auto capture = readCapture(toPcapng({}));
        QVERIFY(capture);
        QVERIFY(capture->packets.isEmpty());
    }

    /// A program that has nothing of ours sees the addresses, ports and bytes of every packet.
    void tsharkReadsIt()
    {
        const QString tshark = QStandardPaths::findExecutable(QStringLiteral("tshark"));
        QVERIFY2(!tshark.isEmpty(), "tests/run installs tshark");
        QTemporaryDir folder;
        QFile file {folder.filePath(QStringLiteral("golden.pcapng"))};
        QVERIFY(file.open(QIODevice::WriteOnly));
        const QList<Packet> packets = goldenPackets();
        const auto comment = [](const Packet &packet) { return QStringLiteral("packet %1").arg(packet.number); };
        file.write(toPcapng(packets, comment));
        file.close();
        QProcess process;
        process.start(tshark,
            {QStringLiteral("-r"), file.fileName(), QStringLiteral("-T"), QStringLiteral("fields"),
                QStringLiteral("-E"), QStringLiteral("separator=|"), QStringLiteral("-e"), QStringLiteral("ip.src"),
                QStringLiteral("-e"), QStringLiteral("ip.dst"), QStringLiteral("-e"), QStringLiteral("udp.srcport"),
                QStringLiteral("-e"), QStringLiteral("udp.dstport"), QStringLiteral("-e"),
                QStringLiteral("udp.payload"), QStringLiteral("-e"), QStringLiteral("frame.comment"),
                QStringLiteral("-e"), QStringLiteral("frame.time_epoch"), QStringLiteral("-e"),
                QStringLiteral("ip.checksum.status"), QStringLiteral("-o"), QStringLiteral("ip.check_checksum:TRUE")});
        QVERIFY2(process.waitForFinished(), qPrintable(process.errorString()));
        const QList<QByteArray> lines = process.readAllStandardOutput().trimmed().split('\n');
        QCOMPARE(lines.size(), packets.size());
        for (qsizetype i = 0; i < packets.size(); ++i) {
            const Packet &packet = packets[i];
            const QByteArray port = QByteArray::number(packet.other.port);
            const bool isSent = packet.passage == Passage::Sent;
            const auto micros = packet.at.time_since_epoch().count();
            const QByteArray time = QByteArray::number(micros / 1'000'000) + '.'
                + QByteArray::number(micros % 1'000'000).rightJustified(6, '0') + "000";
            const QByteArray expected =
                (isSent ? "10.0.0.5|10.0.0.20|50001|" + port : "10.0.0.20|10.0.0.5|" + port + "|50001") + '|'
                + packet.bytes.toHex() + "|packet " + QByteArray::number(packet.number) + '|' + time + "|1";
            QCOMPARE(lines[i], expected);
        }
    }

    void framesOfManyLinks_data()
    {
        QTest::addColumn<QByteArray>("file");
        QTest::addColumn<int>("packets");
        QTest::addColumn<int>("others");
        QTest::addColumn<int>("fragments");
        const QByteArray whole = ipv4(udpIn(aRequest(), 50001, 10040));
        const QByteArray vlan("\x81\x00\x00\x05\x08\x00", 6);
        QTest::addRow("Ethernet") << pcap(1, etherFrame(whole)) << 1 << 0 << 0;
        QTest::addRow("Ethernet with a VLAN tag") << pcap(1, etherFrame(whole, vlan)) << 1 << 0 << 0;
        QTest::addRow("Ethernet with IPv6") << pcap(1, etherFrame(whole, QByteArray("\x86\xDD", 2))) << 0 << 1 << 0;
        QTest::addRow("raw") << pcap(101, whole) << 1 << 0 << 0;
        QTest::addRow("IPv4") << pcap(228, whole) << 1 << 0 << 0;
        QTest::addRow("BSD loopback") << pcap(0, QByteArray("\x02\0\0\0", 4) + whole) << 1 << 0 << 0;
        QTest::addRow("Linux any") << pcap(113, QByteArray(14, '\0') + QByteArray("\x08\x00", 2) + whole) << 1 << 0
                                   << 0;
        QTest::addRow("Linux any, second form")
            << pcap(276, QByteArray("\x08\x00", 2) + QByteArray(18, '\0') + whole) << 1 << 0 << 0;
        QTest::addRow("IP options") << pcap(228, ipv4(udpIn(aRequest(), 50001, 10040), 0, 17, 3)) << 1 << 0 << 0;
        QTest::addRow("another port") << pcap(228, ipv4(udpIn(aRequest(), 50001, 53))) << 0 << 1 << 0;
        QTest::addRow("TCP") << pcap(228, ipv4(udpIn(aRequest(), 50001, 10040), 0, 6)) << 0 << 1 << 0;
        QTest::addRow("first fragment") << pcap(228, ipv4(udpIn(aRequest(), 50001, 10040), 0x2000)) << 0 << 0 << 1;
        QTest::addRow("do not fragment") << pcap(228, ipv4(udpIn(aRequest(), 50001, 10040), 0x4000)) << 1 << 0 << 0;
        QTest::addRow("cut by the capture") << pcap(228, whole, whole.size() - 4) << 0 << 0 << 1;
        QTest::addRow("headers cut") << pcap(228, whole, 24) << 0 << 1 << 0;
        QTest::addRow("no frame") << pcap(1, {}) << 0 << 1 << 0;
    }
    void framesOfManyLinks()
    {
        QFETCH(QByteArray, file);
        const auto capture = readCapture(file);
        QVERIFY2(capture, capture ? "" : qPrintable(capture.error().detail));
        QTEST(int(capture->packets.size()), "packets");
        QTEST(int(capture->others), "others");
        QTEST(int(capture->fragments), "fragments");
        if (!capture->packets.isEmpty())
            QCOMPARE(capture->packets.first().bytes, aRequest());
    }

    void whatIsNoCaptureIsRefused_data()
    {
        QTest::addColumn<QByteArray>("file");
        QTest::addRow("nothing") << QByteArray {};
        QTest::addRow("text") << QByteArray {"this is a text file and no capture at all"};
        QTest::addRow("a cut head") << toPcapng({}).left(11);
        QTest::addRow("a link without IP") << pcap(127, QByteArray(40, 'w'));
    }
    void whatIsNoCaptureIsRefused()
    {
        QFETCH(QByteArray, file);
        const auto capture = readCapture(file);
        QVERIFY(!capture);
        QCOMPARE(capture.error().kind, values::ErrorKind::Malformed);
        QVERIFY(!capture.error().detail.isEmpty());
    }

    void aCutFileGivesWhatIsWhole()
    {
        const QByteArray file = toPcapng(goldenPackets().first(10));
        const auto capture = readCapture(file.chopped(5));
        QVERIFY(capture);
        QCOMPARE(capture->packets.size(), qsizetype {9});
        QVERIFY(!capture->trouble.isEmpty());
    }

    void aHugeFileIsReadInPart()
    {
        const auto capture = readCapture(toPcapng(goldenPackets().first(10)), {}, 4);
        QVERIFY(capture);
        QCOMPARE(capture->packets.size(), qsizetype {4});
        QVERIFY(!capture->trouble.isEmpty());
    }
};

QTEST_GUILESS_MAIN(TestCapture)
#include "tst_capture.moc"
