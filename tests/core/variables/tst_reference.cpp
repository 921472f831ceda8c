// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "variables/reference.h"
#include <QTest>

using namespace variables;

Q_DECLARE_METATYPE(variables::Range)

/// References as the pendant writes them (reference §4.2 to §4.4: B I D R S 0 to 99, P BP EX 0 to 127, M 0 to 999).
class ReferenceTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void reads_data();
    void reads();
    void refuses_data();
    void refuses();
    void prints();
    void knowsHowMany();
};

namespace {

const protocol::Dialect &yrc() { return protocol::dialect(protocol::Model::YRC1000); }

} // namespace

void ReferenceTest::reads_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<Range>("range");
    const auto row = [](const char *text, const Range &range) {
        QTest::newRow(text) << QString::fromUtf8(text) << range;
    };
    row("P012", {Kind::P, 12, 12});
    row("b 7", {Kind::B, 7, 7});
    row("B007", {Kind::B, 7, 7});
    row("  i99 ", {Kind::I, 99, 99});
    row("B010", {Kind::B, 10, 10}); // ten, never eight
    row("bp127", {Kind::BP, 127, 127});
    row("EX 0", {Kind::EX, 0, 0});
    row("m999", {Kind::M, 999, 999});
    row("Ｂ００７", {Kind::B, 7, 7}); // as a Japanese keyboard types it
    row("D000..D099", {Kind::D, 0, 99});
    row("D0..99", {Kind::D, 0, 99});
    row("d 5 .. d 6", {Kind::D, 5, 6});
    row("S3..S3", {Kind::S, 3, 3});
}

void ReferenceTest::reads()
{
    QFETCH(QString, text);
    QFETCH(Range, range);
    const auto read = rangeFromText(text, yrc());
    QVERIFY2(read, read ? "" : qPrintable(read.error().detail));
    QVERIFY(*read == range);
    if (!text.contains(u"..")) {
        const auto one = referenceFromText(text, yrc());
        QVERIFY(one);
        QCOMPARE(one->number, range.first);
    }
}

void ReferenceTest::refuses_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("part"); // of the sentence
    const auto row = [](const char *text, const char *part) {
        QTest::newRow(text) << QString::fromUtf8(text) << QString::fromUtf8(part);
    };
    row("", "is not a variable");
    row("B", "is not a variable");
    row("7", "is not a variable");
    row("X007", "is not a variable");
    row("LB007", "is not a variable");
    row("B-1", "is not a variable");
    row("B0x10", "is not a variable");
    row("B1.5", "is not a variable");
    row("B 7 7", "is not a variable");
    row("B100", "There is no B100: this controller has B000 to B099.");
    row("B99999999999999999999", "There is no B");
    row("P128", "P000 to P127");
    row("M1000", "M000 to M999");
    row("D000..", "is not a variable");
    row("..D099", "is not a variable");
    row("D000..B099", "is not a range");
    row("D9..D3", "is not a range");
    row("D0..D100", "There is no D100");
}

void ReferenceTest::refuses()
{
    QFETCH(QString, text);
    QFETCH(QString, part);
    const auto read = rangeFromText(text, yrc());
    QVERIFY(!read);
    QVERIFY(read.error().kind == values::ErrorKind::BadInput);
    QVERIFY2(read.error().detail.contains(part), qPrintable(read.error().detail));
    QVERIFY(read.error().detail.endsWith(u'.'));
}

void ReferenceTest::prints()
{
    QCOMPARE(toString(Reference {Kind::B, 7}), QStringLiteral("B007"));
    QCOMPARE(toString(Reference {Kind::BP, 127}), QStringLiteral("BP127"));
    for (const Kind kind : allKinds)
        QVERIFY(findKind(letters(kind).toLower()) == kind);
}

void ReferenceTest::knowsHowMany()
{
    protocol::Dialect extended = yrc();
    extended.variables = 1000;
    QCOMPARE(countOf(Kind::B, extended), 1000);
    QVERIFY(referenceFromText(u"B999", extended));
    QCOMPARE(countOf(Kind::EX, yrc()), 128);
    QCOMPARE(writableCountOf(Kind::M, yrc()), 560); // reference §4.2
    QCOMPARE(writableCountOf(Kind::S, yrc()), 100);
}

QTEST_APPLESS_MAIN(ReferenceTest)
#include "tst_reference.moc"
