// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/catalog.h"
#include "protocol/decoder.h"
#include "support/golden.h"
#include <QTest>

using namespace protocol;

/// Packets that we did not make decode to what they mean.
class GoldenTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void decodesEveryField_data();
    void decodesEveryField();
    void encodesHeaderBack_data() { decodesEveryField_data(); }
    void encodesHeaderBack();
    void rejectsMalformed_data();
    void rejectsMalformed();
    void knowsWhatIsRefused_data();
    void knowsWhatIsRefused();
};

namespace {

QJsonObject fieldsOf(const DecodedPacket &packet)
{
    QJsonObject object;
    for (const Field &field : packet.header + packet.payload)
        object.insert(field.name, field.value);
    return object;
}

} // namespace

void GoldenTest::decodesEveryField_data()
{
    QTest::addColumn<int>("index");
    for (int index = 0; index < golden::exchanges().size(); ++index)
        QTest::addRow("%s", qPrintable(golden::exchanges()[index].title)) << index;
}

void GoldenTest::decodesEveryField()
{
    QFETCH(int, index);
    Decoder decoder;
    for (const golden::Packet &packet : golden::exchanges()[index].packets) {
        const DecodedPacket decoded = decoder.decode(packet.bytes);
        QCOMPARE(decoded.error, QString {});
        QVERIFY(decoded.direction == (packet.isFromClient ? Direction::ToController : Direction::ToClient));
        const QJsonObject fields = fieldsOf(decoded);
        for (auto expected = packet.fields.begin(); expected != packet.fields.end(); ++expected) {
            if (expected.key() == QLatin1StringView("refused_with"))
                QVERIFY2(
                    decoded.meaning.startsWith(hexWord(quint64(expected->toInt()), 4)), qPrintable(decoded.meaning));
            else
                QVERIFY2(fields.value(expected.key()) == *expected, qPrintable(expected.key()));
        }
    }
}

void GoldenTest::encodesHeaderBack()
{
    QFETCH(int, index);
    for (const golden::Packet &packet : golden::exchanges()[index].packets) {
        if (packet.isFromClient) {
            const auto parsed = parseClientPacket(packet.bytes);
            QVERIFY(parsed);
            QCOMPARE(encode(parsed->request(), parsed->framing), packet.bytes);
        } else {
            const auto parsed = parseReply(packet.bytes);
            QVERIFY(parsed);
            QCOMPARE(encode(*parsed), packet.bytes);
        }
    }
}

void GoldenTest::rejectsMalformed_data()
{
    QTest::addColumn<int>("index");
    for (int index = 0; index < golden::malformed().size(); ++index)
        QTest::addRow("%s", qPrintable(golden::malformed()[index].title)) << index;
}

void GoldenTest::rejectsMalformed()
{
    QFETCH(int, index);
    const golden::Malformed &row = golden::malformed()[index];
    Decoder decoder;
    if (row.port)
        decoder.setDivision(row.port == filePort ? Division::File : Division::Robot);
    if (!row.replyTo.isEmpty())
        QVERIFY(decoder.setRequest(row.replyTo));
    const DecodedPacket decoded = decoder.decode(row.bytes);
    QCOMPARE(decoded.error, row.error);
    QVERIFY(decoded.payload.isEmpty());
}

void GoldenTest::knowsWhatIsRefused_data()
{
    QTest::addColumn<int>("index");
    for (int index = 0; index < golden::refused().size(); ++index)
        QTest::addRow("%s", qPrintable(golden::refused()[index].title)) << index;
}

void GoldenTest::knowsWhatIsRefused()
{
    QFETCH(int, index);
    const golden::Refused &row = golden::refused()[index];
    const Dialect *dialect = findDialect(row.model);
    QVERIFY(dialect);
    Decoder decoder {TextCodec {}, dialect->model};
    const QString problem = decoder.decode(row.bytes).problem;
    QVERIFY2(problem.startsWith(hexWord(row.code, 4)), qPrintable(problem));
}

QTEST_APPLESS_MAIN(GoldenTest)
#include "tst_golden.moc"
