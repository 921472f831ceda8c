// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/catalog.h"
#include "support/golden.h"
#include "support/typedrequests.h"
#include <QTest>

using namespace protocol;
using namespace values;

/// Typed requests make the bytes of the reference and understand its replies.
class RequestsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyRequest_data();
    void everyRequest();
    void isNotRefusedForItsAddress_data() { everyRequest_data(); }
    void isNotRefusedForItsAddress();
    void effectIsThatOfTheCatalogue_data() { everyRequest_data(); }
    void effectIsThatOfTheCatalogue();
    void acceptsAlarmTextsOfAnyLength_data();
    void acceptsAlarmTextsOfAnyLength();
    void pluralCounts_data();
    void pluralCounts();
    void pluralReplyWithAnotherCount();
    void pluralWriteReply();
    void unexpectedPayload();
};

void RequestsTest::everyRequest_data()
{
    QTest::addColumn<int>("index");
    for (int index = 0; index < typed::rows().size(); ++index)
        QTest::addRow("%s", typed::rows()[index].title) << index;
}

void RequestsTest::everyRequest()
{
    QFETCH(int, index);
    const typed::Row &row = typed::rows()[index];
    const auto &packets = golden::exchange(QString::fromUtf8(row.title)).packets;
    const auto request = parseClientPacket(packets[0].bytes);
    QVERIFY(request);
    QCOMPARE(encode(row.request, request->framing).toHex(), packets[0].bytes.toHex());
    const auto reply = parseReply(packets[1].bytes);
    QVERIFY(reply);
    QCOMPARE(row.check(reply->payload), QString {});
    if (!reply->payload.isEmpty())
        QCOMPARE(row.reply.toHex(), reply->payload.toByteArray().toHex());
}

void RequestsTest::isNotRefusedForItsAddress()
{
    QFETCH(int, index);
    QCOMPARE(addressFault(typed::rows()[index].request, dialect(Model::YRC1000)), quint16(0));
}

void RequestsTest::effectIsThatOfTheCatalogue()
{
    QFETCH(int, index);
    const typed::Row &row = typed::rows()[index];
    QCOMPARE(row.effect, effectOf(row.request));
}

void RequestsTest::acceptsAlarmTextsOfAnyLength_data()
{
    QTest::addColumn<int>("length");
    QTest::addColumn<bool>("isAccepted");
    for (const int length : {60, 61, 76, 100, 172, 184, 267, 268, 269, 479})
        QTest::addRow("%d bytes", length) << length << true;
    for (const int length : {0, 59})
        QTest::addRow("%d bytes", length) << length << false;
}

void RequestsTest::acceptsAlarmTextsOfAnyLength()
{
    QFETCH(int, length);
    QFETCH(bool, isAccepted);
    const QByteArray payload(length, 'A');
    const auto alarm = ReadAlarmWithTexts {1}.decode(payload);
    QCOMPARE(alarm.has_value(), isAccepted);
    if (isAccepted)
        QCOMPARE(alarm->subText.bytes().size(), std::clamp(length - 76, 0, 96));
}

void RequestsTest::pluralCounts_data()
{
    QTest::addColumn<qsizetype>("itemSize");
    QTest::addColumn<quint32>("count");
    QTest::addColumn<bool>("isAllowed");
    const auto limit = [](const char *name, qsizetype size, quint32 most, quint32 step) {
        QTest::addRow("%s: most", name) << size << most << true;
        QTest::addRow("%s: above", name) << size << most + step << false;
        QTest::addRow("%s: one", name) << size << 1U << (step == 1);
        QTest::addRow("%s: none", name) << size << 0U << false;
    };
    // The table of reference §4.5.
    limit("I/O and B", pluralRule<IoGroup>().itemSize, 474, 2);
    limit("register", pluralRule<Register>().itemSize, 237, 1);
    limit("I", pluralRule<IntegerVariable>().itemSize, 237, 1);
    limit("D", pluralRule<DoubleVariable>().itemSize, 118, 1);
    limit("R", pluralRule<RealVariable>().itemSize, 118, 1);
    limit("S 16", pluralRule<StringVariable16>().itemSize, 29, 1);
    limit("P", pluralRule<PositionVariable>().itemSize, 9, 1);
    limit("BP", pluralRule<BasePosition>().itemSize, 13, 1);
    limit("EX", pluralRule<ExternalPosition>().itemSize, 13, 1);
    limit("S 32", pluralRule<StringVariable32>().itemSize, 14, 1);
    QTest::newRow("odd B") << qsizetype(1) << 473U << false;
}

void RequestsTest::pluralCounts()
{
    QFETCH(qsizetype, itemSize);
    QFETCH(quint32, count);
    QFETCH(bool, isAllowed);
    QCOMPARE(PluralRule {itemSize}.allows(count), isAllowed);
    if (itemSize == 1)
        QCOMPARE(ReadItems<ByteVariable>::create(0, int(count)).has_value(), isAllowed);
}

void RequestsTest::pluralReplyWithAnotherCount()
{
    const auto request = ReadItems<Register>::create(0, 2);
    QVERIFY(request);
    QVERIFY(request->decode(QByteArray::fromHex("0200000001000200")));
    for (const char *wrong : {"0100000001000200", "02000000010002", "020000000100020003", "020000", ""})
        QVERIFY2(!request->decode(QByteArray::fromHex(wrong)), wrong);
}

void RequestsTest::pluralWriteReply()
{
    const auto request = WriteItems<Register>::create(0, {{1}, {2}});
    QVERIFY(request);
    QVERIFY(request->decode({})); // reference §12, conflict 46: both forms
    QVERIFY(request->decode(QByteArray::fromHex("02000000")));
    QVERIFY(!request->decode(QByteArray::fromHex("01000000")));
    QVERIFY(!request->decode(QByteArray::fromHex("0200000001000200")));
}

void RequestsTest::unexpectedPayload()
{
    QVERIFY(HoldOn {}.decode({}));
    QVERIFY(!HoldOn {}.decode(QByteArrayView {"\0", 1}));
}

QTEST_APPLESS_MAIN(RequestsTest)
#include "tst_requests.moc"
