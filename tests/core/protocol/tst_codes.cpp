// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/codes.h"
#include <QTest>

using namespace protocol;
using values::Error;
using values::ErrorKind;

class CodesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tableIsSortedAndWhole();
    void effectiveCodes_data();
    void effectiveCodes();
    void notTaught();
    void busy_data();
    void busy();
    void explains_data();
    void explains();
    void explainsEveryKind();
};

namespace {

Error refusal(quint8 status, quint16 code) { return {ErrorKind::Refused, status, code, {}}; }

} // namespace

void CodesTest::tableIsSortedAndWhole()
{
    // Reference §9 has 147 codes, and 0xA102 comes from §12, conflict 8.
    QCOMPARE(statusCodes().size(), std::size_t(148));
    quint16 previous = 0;
    for (const StatusCode &row : statusCodes()) {
        QVERIFY(row.code > previous);
        QVERIFY(*row.meaning);
        QCOMPARE(findStatusCode(row.code), &row);
        previous = row.code;
    }
    for (const int missing : {0x0000, 0x1000, 0x2071, 0xFFFF})
        QVERIFY(!findStatusCode(quint16(missing)));
}

/// A position variable that was never set (reference §4.4).
void CodesTest::notTaught()
{
    QVERIFY(isNotTaught(refusal(0x1F, 0xB001)));
    QVERIFY(isNotTaught(refusal(0x1F, 0xB005)));
    QVERIFY(!isNotTaught(refusal(0x1F, 0xB00C)));
    QVERIFY(!isNotTaught(values::Error {values::ErrorKind::NoAnswer}));
}

void CodesTest::effectiveCodes_data()
{
    QTest::addColumn<int>("status");
    QTest::addColumn<int>("addedStatus");
    QTest::addColumn<int>("code");
    QTest::newRow("added status") << 0x1F << 0x2070 << 0x2070;
    QTest::newRow("bare 08") << 0x08 << 0 << 0xA000;
    QTest::newRow("bare 09") << 0x09 << 0 << 0xA002;
    QTest::newRow("bare 28") << 0x28 << 0 << 0xA001;
    QTest::newRow("bare 08 with a code") << 0x08 << 0xB003 << 0xB003;
    QTest::newRow("unknown status") << 0x31 << 0 << 0;
}

void CodesTest::effectiveCodes()
{
    QFETCH(int, status);
    QFETCH(int, addedStatus);
    QFETCH(int, code);
    QCOMPARE(int(effectiveCode(refusal(quint8(status), quint16(addedStatus)))), code);
}

void CodesTest::busy_data()
{
    QTest::addColumn<int>("code");
    QTest::addColumn<bool>("isBusyCode");
    for (const int code : {0x2090, 0xD8F1, 0xD8FA, 0xE444, 0xFFF6})
        QTest::addRow("%04X", code) << code << true;
    for (const int code : {0x2010, 0x2070, 0xA001, 0xFFF7})
        QTest::addRow("%04X", code) << code << false;
}

void CodesTest::busy()
{
    QFETCH(int, code);
    QTEST(isBusy(refusal(0x1F, quint16(code))), "isBusyCode");
    QVERIFY(!isBusy({ErrorKind::NoAnswer, 0x1F, quint16(code), {}}));
}

void CodesTest::explains_data()
{
    QTest::addColumn<int>("status");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("sentence");
    const auto row = [](const char *name, int status, int code, const char *sentence) {
        QTest::newRow(name) << status << code << QString::fromUtf8(sentence);
    };
    row("with remedy", 0x1F, 0x2070, "0x2070 servo power is off — switch servo on");
    row("without remedy", 0x1F, 0xB002, "0xB002 this data may not be used");
    row("bare status", 0x08, 0, "0xA000 the controller does not know this command");
    row("unknown code", 0x1F, 0x1234, "0x1234 refused, with a code that is not in the code list");
    row("unknown status", 0x31, 0, "refused with status 0x31, which is not in the code list");
}

void CodesTest::explains()
{
    QFETCH(int, status);
    QFETCH(int, code);
    QTEST(explain(refusal(quint8(status), quint16(code))), "sentence");
}

void CodesTest::explainsEveryKind()
{
    using enum ErrorKind;
    for (const ErrorKind kind :
        {NoAnswer, UnknownOutcome, Malformed, NotSent, Network, BadInput, LocalFile, Cancelled}) {
        const QString plain = explain({kind, 0, 0, {}});
        QVERIFY(!plain.isEmpty());
        QCOMPARE(explain({kind, 0, 0, QStringLiteral("why")}), plain + QStringLiteral(" (why)"));
    }
}

QTEST_APPLESS_MAIN(CodesTest)
#include "tst_codes.moc"
