// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/fileblocks.h"
#include "support/golden.h"
#include "support/typedrequests.h"
#include <QTest>

using namespace protocol;
using Step = BlockCollector::Step;

class FileBlocksTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void makesGoldenRequests();
    void loadsInGoldenBlocks();
    void acknowledgesGoldenBlocks();
    void splitsContent_data();
    void splitsContent();
    void checksGoAhead_data();
    void checksGoAhead();
    void checksAcknowledgement_data();
    void checksAcknowledgement();
    void collects_data();
    void collects();
    void staysCompleteAfterRefusal();
    void parsesLists_data();
    void parsesLists();
};

namespace {

const golden::Exchange &named(const char *title) { return golden::exchange(QString::fromUtf8(title)); }

Reply reply(quint32 block, QByteArrayView payload = {}, quint8 status = 0)
{
    return {{Division::File, true, 1, block}, replyService(Service::SaveFile), status, quint8(status ? 1 : 0),
        quint16(status ? 0xE2B3 : 0), payload};
}

} // namespace

void FileBlocksTest::makesGoldenRequests()
{
    for (const typed::FileRow &row : typed::fileRows()) {
        const QByteArray &expected = named(row.title).packets.first().bytes;
        QCOMPARE(encodeFileRequest(row.request, quint8(expected[11])).toHex(), expected.toHex());
    }
}

void FileBlocksTest::loadsInGoldenBlocks()
{
    const auto &packets = named("A job is loaded in two blocks").packets;
    const QByteArray content = packets[2].bytes.sliced(headerSize) + packets[4].bytes.sliced(headerSize);
    const auto id = quint8(packets[0].bytes[11]);
    QCOMPARE(blockCount(content), 2U);
    QVERIFY(checkGoAhead(*parseReply(packets[1].bytes)));
    QCOMPARE(encodeLoadBlock(content, 1, id).toHex(), packets[2].bytes.toHex());
    QVERIFY(checkAcknowledgement(*parseReply(packets[3].bytes), blockNumber(1, 2)));
    QCOMPARE(encodeLoadBlock(content, 2, id).toHex(), packets[4].bytes.toHex());
    QVERIFY(checkAcknowledgement(*parseReply(packets[5].bytes), blockNumber(2, 2)));
    QVERIFY(!checkAcknowledgement(*parseReply(packets[3].bytes), blockNumber(2, 2)));
}

void FileBlocksTest::acknowledgesGoldenBlocks()
{
    for (const char *title :
        {"A job is saved in two blocks", "List of jobs in one block", "A list over two blocks, cut within a name",
            "A saved file in one block that is marked as a single reply", "An empty list as one empty last block"}) {
        const auto &packets = named(title).packets;
        const auto request = parseClientPacket(packets[0].bytes);
        BlockCollector collector;
        for (qsizetype at = 1; at < packets.size(); at += 2) {
            const auto block = parseReply(packets[at].bytes);
            const auto step = collector.take(*block);
            QVERIFY(step);
            QCOMPARE(*step == Step::Complete, at + 2 >= packets.size());
            QCOMPARE(encodeAcknowledgement(request->service, block->framing.id, block->framing.block).toHex(),
                packets[at + 1].bytes.toHex());
        }
        QVERIFY(collector.isComplete());
    }
}

void FileBlocksTest::splitsContent_data()
{
    QTest::addColumn<int>("size");
    QTest::addColumn<quint32>("count");
    QTest::addColumn<int>("sizeOfLast");
    QTest::newRow("one byte") << 1 << 1U << 1;
    QTest::newRow("one full block") << 400 << 1U << 400;
    QTest::newRow("one byte more") << 401 << 2U << 1;
    QTest::newRow("many") << 400 * 70 + 5 << 71U << 5;
}

void FileBlocksTest::splitsContent()
{
    QFETCH(int, size);
    QFETCH(quint32, count);
    QFETCH(int, sizeOfLast);
    const QByteArray content(size, 'x');
    QCOMPARE(blockCount(content), count);
    QByteArray joined;
    for (quint32 index = 1; index <= count; ++index) {
        const QByteArray datagram = encodeLoadBlock(content, index, 3);
        const auto packet = parseClientPacket(datagram);
        QVERIFY(packet);
        QVERIFY(packet->framing.ack);
        QCOMPARE(packet->framing.block, index == count ? index | 0x80000000U : index);
        QCOMPARE(packet->payload.size(), qsizetype(index == count ? sizeOfLast : 400));
        joined += packet->payload;
    }
    QCOMPARE(joined, content);
}

void FileBlocksTest::checksGoAhead_data()
{
    QTest::addColumn<quint32>("block");
    QTest::addColumn<int>("status");
    QTest::addColumn<bool>("isGoAhead");
    QTest::newRow("block 0") << 0U << 0 << true;
    QTest::newRow("as a single reply") << 0x80000000U << 0 << true;
    QTest::newRow("block 1") << 1U << 0 << false;
    QTest::newRow("refused") << 0x80000000U << 0x1F << false;
}

void FileBlocksTest::checksGoAhead()
{
    QFETCH(quint32, block);
    QFETCH(int, status);
    QTEST(checkGoAhead(reply(block, {}, quint8(status))).has_value(), "isGoAhead");
}

void FileBlocksTest::checksAcknowledgement_data()
{
    QTest::addColumn<quint32>("block");
    QTest::addColumn<bool>("isGood");
    QTest::newRow("same") << 0x80000002U << true;
    QTest::newRow("without the mark") << 2U << false;
    QTest::newRow("earlier") << 1U << false;
    QTest::newRow("zero") << 0U << false;
}

void FileBlocksTest::checksAcknowledgement()
{
    QFETCH(quint32, block);
    QTEST(checkAcknowledgement(reply(block), 0x80000002U).has_value(), "isGood");
    QCOMPARE(checkAcknowledgement(reply(block, {}, 0x1F), block).error().addedStatus, quint16(0xE2B3));
}

void FileBlocksTest::collects_data()
{
    QTest::addColumn<QList<quint32>>("blocks");
    QTest::addColumn<QString>("steps"); // n next, r repeated, c complete, x out of turn
    QTest::newRow("one") << QList<quint32> {0x80000001U} << QStringLiteral("c");
    QTest::newRow("one, marked as a single reply") << QList<quint32> {0x80000000U} << QStringLiteral("c");
    QTest::newRow("three") << QList<quint32> {1, 2, 0x80000003U} << QStringLiteral("nnc");
    QTest::newRow("repeated") << QList<quint32> {1, 1, 2, 2, 0x80000003U, 0x80000003U} << QStringLiteral("nrnrcr");
    QTest::newRow("gap") << QList<quint32> {1, 3} << QStringLiteral("nx");
    QTest::newRow("older than the last") << QList<quint32> {1, 2, 1} << QStringLiteral("nnx");
    QTest::newRow("starts at 2") << QList<quint32> {2} << QStringLiteral("x");
    QTest::newRow("starts at 0") << QList<quint32> {0} << QStringLiteral("x");
    QTest::newRow("goes on after the last") << QList<quint32> {0x80000001U, 2} << QStringLiteral("cx");
    QTest::newRow("single mark after a block") << QList<quint32> {1, 2, 0x80000000U} << QStringLiteral("nnx");
}

void FileBlocksTest::collects()
{
    QFETCH(QList<quint32>, blocks);
    QFETCH(QString, steps);
    BlockCollector collector;
    QString taken;
    QByteArray content;
    for (const quint32 block : blocks) {
        const QByteArray data = QByteArray::number(block);
        const auto step = collector.take(reply(block, data));
        taken += !step ? u'x' : *step == Step::Next ? u'n' : *step == Step::Repeated ? u'r' : u'c';
        if (step && *step != Step::Repeated)
            content += data;
    }
    QCOMPARE(taken, steps);
    QCOMPARE(collector.content(), content);
}

void FileBlocksTest::staysCompleteAfterRefusal()
{
    BlockCollector collector;
    QVERIFY(collector.take(reply(1, "abc")));
    const auto refused = collector.take(reply(0x80000000U, {}, 0x1F));
    QVERIFY(!refused);
    QCOMPARE(refused.error().addedStatus, quint16(0xE2B3));
    QVERIFY(!collector.isComplete());
    QVERIFY(collector.take(reply(0x80000002U, "d")));
    QCOMPARE(collector.content(), QByteArray("abcd"));
}

void FileBlocksTest::parsesLists_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QByteArrayList>("names");
    QTest::addColumn<QByteArrayList>("rejected");
    QTest::newRow("empty") << QByteArray {} << QByteArrayList {} << QByteArrayList {};
    QTest::newRow("two") << QByteArray("A.JBI\r\nB.JBI\r\n") << QByteArrayList {"A.JBI", "B.JBI"} << QByteArrayList {};
    QTest::newRow("last one open") << QByteArray("A.JBI\r\nB.JBI") << QByteArrayList {"A.JBI", "B.JBI"}
                                   << QByteArrayList {};
    QTest::newRow("empty lines") << QByteArray("\r\n\r\nA.JBI\r\n\r\n") << QByteArrayList {"A.JBI"}
                                 << QByteArrayList {};
    QTest::newRow("space in a name") << QByteArray("A B.JBI\r\n") << QByteArrayList {"A B.JBI"} << QByteArrayList {};
    QTest::newRow("leads out of a folder") << QByteArray("../x\r\nA.JBI\r\n/etc/passwd\r\n") << QByteArrayList {"A.JBI"}
                                           << QByteArrayList {"../x", "/etc/passwd"};
    QTest::newRow("line feed alone") << QByteArray("A.JBI\nB.JBI\n") << QByteArrayList {"A.JBI", "B.JBI"}
                                     << QByteArrayList {};
    QTest::newRow("carriage return alone")
        << QByteArray("A.JBI\rB.JBI\n") << QByteArrayList {} << QByteArrayList {"A.JBI\rB.JBI"};
}

void FileBlocksTest::parsesLists()
{
    QFETCH(QByteArray, content);
    const FileList list = parseFileList(content);
    QByteArrayList names;
    for (const auto &name : list.names)
        names += name.bytes();
    QTEST(names, "names");
    QTEST(list.rejected, "rejected");
}

QTEST_APPLESS_MAIN(FileBlocksTest)
#include "tst_fileblocks.moc"
