// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/text.h"
#include <QTest>

using namespace protocol;

Q_DECLARE_METATYPE(protocol::Encoding)

class TextTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void converts_data();
    void converts();
    void showsUndecodableBytes_data();
    void showsUndecodableBytes();
    void namesWhatCannotBeHeld_data();
    void namesWhatCannotBeHeld();
    void fits_data();
    void fits();
    void keepsEveryByteOfAscii();
    void findsEncodings();
};

namespace {

using enum Encoding;

/// Text that exists in the encoding, and its bytes.
void addConversions()
{
    QTest::addColumn<Encoding>("encoding");
    QTest::addColumn<QByteArray>("hex");
    QTest::addColumn<QString>("text");
    const auto row = [](const char *name, Encoding encoding, const char *hex, const char *text) {
        QTest::newRow(name) << encoding << QByteArray(hex) << QString::fromUtf8(text);
    };
    row("empty", Utf8, "", "");
    row("ascii", ShiftJis, "5365727620312f32", "Serv 1/2");
    row("latin-1", Latin1, "47e9", "Gé");
    row("utf-8", Utf8, "47c3a9e38386f09fa496", "Géテ🤖");
    row("shift-jis", ShiftJis, "836583588367", "テスト");
    row("shift-jis with a backslash byte", ShiftJis, "835c8145", "ソ・");
    row("shift-jis half-width", ShiftJis, "b1b2", "ｱｲ");
    row("shift-jis mixed", ShiftJis, "414283658358", "ABテス");
    row("backslash and tilde", ShiftJis, "5c7e", "\\~");
    row("gbk", Gbk, "b2e2cad4", "测试");
    row("big5", Big5, "b4fab8d5", "測試");
    row("euc-kr", EucKr, "bdc3c7e8", "시험");
}

} // namespace

void TextTest::converts_data() { addConversions(); }

void TextTest::converts()
{
    QFETCH(Encoding, encoding);
    QFETCH(QByteArray, hex);
    QFETCH(QString, text);
    const QByteArray bytes = QByteArray::fromHex(hex);
    const TextCodec codec {encoding};
    QCOMPARE(codec.decode(bytes), text);
    const auto encoded = codec.encode(text);
    QVERIFY(encoded);
    QCOMPARE(encoded->toHex(), hex);
    QCOMPARE(*codec.byteCount(text), bytes.size());
}

void TextTest::showsUndecodableBytes_data()
{
    QTest::addColumn<Encoding>("encoding");
    QTest::addColumn<QByteArray>("hex");
    QTest::addColumn<QString>("text");
    const auto row = [](const char *name, Encoding encoding, const char *hex, const char *text) {
        QTest::newRow(name) << encoding << QByteArray(hex) << QString::fromUtf8(text);
    };
    row("control byte in latin-1", Latin1, "418a42", "A⟨8A⟩B");
    row("cut at the end", ShiftJis, "418a", "A⟨8A⟩");
    row("lead byte before a digit", ShiftJis, "8a31", "⟨8A⟩1");
    row("no lead byte", ShiftJis, "ff41", "⟨FF⟩A");
    row("character behind it", ShiftJis, "ff8365ff8358", "⟨FF⟩テ⟨FF⟩ス");
    row("private character", ShiftJis, "f0408365", "⟨F0⟩@テ");
    row("character behind a cut one", Utf8, "e383c3a9", "⟨E3⟩⟨83⟩é");
    row("stray continuation", Utf8, "8a", "⟨8A⟩");
    row("overlong", Utf8, "c080", "⟨C0⟩⟨80⟩");
    row("cut character", Utf8, "41e383", "A⟨E3⟩⟨83⟩");
    row("surrogate in utf-8", Utf8, "eda080", "⟨ED⟩⟨A0⟩⟨80⟩");
    row("gbk", Gbk, "ff", "⟨FF⟩");
    row("big5", Big5, "80", "⟨80⟩");
    row("euc-kr", EucKr, "83", "⟨83⟩");
    row("euc-kr in front of a character", EucKr, "ffbdc366", "⟨FF⟩시f");
}

void TextTest::showsUndecodableBytes()
{
    QFETCH(Encoding, encoding);
    QFETCH(QByteArray, hex);
    const TextCodec codec {encoding};
    QTEST(codec.decode(QByteArray::fromHex(hex)), "text");
    QFETCH(QString, text);
    const auto back = codec.encode(text);
    QVERIFY(back);
    QCOMPARE(back->toHex(), hex);
}

void TextTest::namesWhatCannotBeHeld_data()
{
    QTest::addColumn<Encoding>("encoding");
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("character");
    const auto row = [](const char *name, Encoding encoding, const char *text, const char *character) {
        QTest::newRow(name) << encoding << QString::fromUtf8(text) << QString::fromUtf8(character);
    };
    row("japanese in latin-1", Latin1, "Aテ", "\"テ\"");
    row("korean in shift-jis", ShiftJis, "テ시", "\"시\"");
    row("snowman in shift-jis", ShiftJis, "☃", "\"☃\"");
    row("pair in shift-jis", ShiftJis, "x🤖", "\"🤖\"");
    row("euro in latin-1", Latin1, "5 €", "\"€\"");
    row("arabic in big5", Big5, "ع", "\"ع\"");
    row("arabic in euc-kr", EucKr, "ع", "\"ع\"");
}

void TextTest::namesWhatCannotBeHeld()
{
    QFETCH(Encoding, encoding);
    QFETCH(QString, text);
    QFETCH(QString, character);
    const auto encoded = TextCodec {encoding}.encode(text);
    QVERIFY(!encoded);
    QCOMPARE(encoded.error().kind, values::ErrorKind::BadInput);
    QVERIFY2(encoded.error().detail.endsWith(character), qPrintable(encoded.error().detail));
}

void TextTest::fits_data()
{
    QTest::addColumn<Encoding>("encoding");
    QTest::addColumn<QByteArray>("hex");
    QTest::addColumn<int>("size");
    QTest::addColumn<int>("kept");
    const auto row = [](const char *name, Encoding encoding, const char *hex, int size, int kept) {
        QTest::newRow(name) << encoding << QByteArray(hex) << size << kept;
    };
    row("all", ShiftJis, "836583588367", 6, 6);
    row("room to spare", ShiftJis, "8365", 30, 2);
    row("cuts no character", ShiftJis, "836583588367", 5, 4);
    row("at a border", ShiftJis, "836583588367", 4, 4);
    row("nothing fits", ShiftJis, "8365", 1, 0);
    row("nothing wanted", ShiftJis, "8365", 0, 0);
    row("ascii", Latin1, "414243", 2, 2);
    row("utf-8", Utf8, "41f09fa496", 4, 1);
    row("undecodable", ShiftJis, "ffffff", 2, 2);
}

void TextTest::fits()
{
    QFETCH(Encoding, encoding);
    QFETCH(QByteArray, hex);
    QFETCH(int, size);
    QFETCH(int, kept);
    const QByteArray bytes = QByteArray::fromHex(hex);
    const auto fitted = TextCodec {encoding}.fit(bytes, size);
    QCOMPARE(fitted.toByteArray(), bytes.first(kept));
}

void TextTest::keepsEveryByteOfAscii()
{
    for (const auto &[encoding, key] : encodings()) {
        for (char byte = 0; quint8(byte) < 0x80; ++byte) {
            const QByteArray bytes {"\x41" + QByteArray(1, byte)};
            QCOMPARE(TextCodec {encoding}.decode(bytes), QString::fromLatin1(bytes));
            if (byte == 0x7F)
                break;
        }
    }
}

void TextTest::findsEncodings()
{
    for (const auto &[encoding, key] : encodings())
        QVERIFY(findEncoding(QString::fromLatin1(key).toLower()) == encoding);
    QVERIFY(!findEncoding(u"EBCDIC"));
}

QTEST_APPLESS_MAIN(TextTest)
#include "tst_text.moc"
