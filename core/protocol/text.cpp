// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/text.h"

#include <QLatin1StringView>
#include <QStringDecoder>
#include <QStringEncoder>
#include <algorithm>
#include <array>

using values::ErrorKind;
using values::Result;

namespace protocol {

namespace {

constexpr std::array names {
    EncodingName {Encoding::Latin1, "ISO-8859-1"},
    EncodingName {Encoding::Utf8, "UTF-8"},
    EncodingName {Encoding::ShiftJis, "Shift_JIS"},
    EncodingName {Encoding::Gbk, "GBK"},
    EncodingName {Encoding::Big5, "Big5"},
    EncodingName {Encoding::EucKr, "EUC-KR"},
};

constexpr QChar opening {u'⟨'};
constexpr QChar closing {u'⟩'};

bool isAscii(char byte) { return quint8(byte) < 0x80; }
bool isAscii(QByteArrayView bytes)
{
    return std::ranges::all_of(bytes, [](char byte) { return isAscii(byte); });
}

/// A single character that a person can read: no substitute, no control character, nothing private.
bool isCharacter(QStringView text)
{
    const bool isPair = text.size() == 2 && text[0].isHighSurrogate() && text[1].isLowSurrogate();
    if (text.size() != 1 && !isPair)
        return false;
    const char32_t character = isPair ? QChar::surrogateToUcs4(text[0], text[1]) : text[0].unicode();
    const auto category = QChar::category(character);
    return character != QChar::ReplacementCharacter && category != QChar::Other_Control
        && category != QChar::Other_PrivateUse && category != QChar::Other_NotAssigned
        && category != QChar::Other_Surrogate;
}

struct Character {
    qsizetype bytes;
    QString text; ///< Empty if the first byte begins no character.
};

/// Takes a text apart, character by character.
class Scanner
{
public:
    explicit Scanner(Encoding encoding) : m_decoder {encodingKey(encoding)} { }

    /// The character that `bytes`, which is not empty, begins with.
    Character next(QByteArrayView bytes)
    {
        constexpr qsizetype longest = 4;
        if (isAscii(bytes.front()))
            return {1, QString {QLatin1Char(bytes.front())}};
        for (qsizetype size = 1; size <= std::min(bytes.size(), longest); ++size) {
            m_decoder.resetState();
            const QString text = m_decoder.decode(bytes.first(size));
            if (isCharacter(text)) // a decoder that once saw an error keeps saying so, even after resetState()
                return {size, text};
        }
        return {1, {}};
    }

private:
    QStringDecoder m_decoder;
};

QString undecodable(char byte)
{
    return opening + QString::number(quint8(byte), 16).toUpper().rightJustified(2, u'0') + closing;
}

/// The byte that "⟨8A⟩" at the start of `text` stands for.
std::optional<char> markedByte(QStringView text)
{
    constexpr qsizetype size = 4;
    if (text.size() < size || text[0] != opening || text[size - 1] != closing)
        return std::nullopt;
    bool isNumber = false;
    const uint byte = text.sliced(1, 2).toUInt(&isNumber, 16);
    return isNumber && byte >= 0x80 ? std::optional {char(byte)} : std::nullopt;
}

/// The bytes of one character that is not ASCII; empty if the encoding does not hold it.
QByteArray encodeCharacter(QStringEncoder &encoder, Scanner &scanner, QStringView character)
{
    encoder.resetState();
    const QByteArray bytes = encoder.encode(character);
    if (encoder.hasError() || bytes.isEmpty())
        return {};
    // A converter may put a substitute without a word, or one of two look-alikes: only what comes back the same counts.
    const Character back = scanner.next(bytes);
    return back.bytes == bytes.size() && back.text == character ? bytes : QByteArray {};
}

tl::unexpected<values::Error> cannotHold(QStringView character, Encoding encoding)
{
    return values::badInput(QStringLiteral("%1 does not hold the character \"%2\"")
                                .arg(QLatin1StringView(encodingKey(encoding)), character));
}

} // namespace

const char *encodingKey(Encoding encoding) { return std::ranges::find(names, encoding, &EncodingName::encoding)->key; }

std::span<const EncodingName> encodings() { return names; }

std::optional<Encoding> findEncoding(QStringView key)
{
    const auto found = std::ranges::find_if(names,
        [key](const EncodingName &row) { return key.compare(QLatin1StringView(row.key), Qt::CaseInsensitive) == 0; });
    return found == names.end() ? std::nullopt : std::optional {found->encoding};
}

QString TextCodec::decode(QByteArrayView bytes) const
{
    if (isAscii(bytes))
        return QString::fromLatin1(bytes);
    Scanner scanner {m_encoding};
    QString text;
    while (!bytes.isEmpty()) {
        const Character character = scanner.next(bytes);
        text += character.text.isEmpty() ? undecodable(bytes.front()) : character.text;
        bytes = bytes.sliced(character.bytes);
    }
    return text;
}

Result<QByteArray> TextCodec::encode(QStringView text) const
{
    QStringEncoder encoder {encodingKey(m_encoding)};
    Scanner scanner {m_encoding};
    QByteArray bytes;
    while (!text.isEmpty()) {
        const bool isPair = text.size() > 1 && text[0].isHighSurrogate() && text[1].isLowSurrogate();
        QStringView character = text.first(isPair ? 2 : 1);
        if (const auto marked = markedByte(text)) {
            bytes += *marked;
            character = text.first(4);
        } else if (text[0].unicode() < 0x80) {
            bytes += char(text[0].unicode());
        } else if (const auto encoded = encodeCharacter(encoder, scanner, character); !encoded.isEmpty()) {
            bytes += encoded;
        } else {
            return cannotHold(character, m_encoding);
        }
        text = text.sliced(character.size());
    }
    return bytes;
}

QByteArrayView TextCodec::fit(QByteArrayView bytes, qsizetype size) const
{
    if (bytes.size() <= size)
        return bytes;
    Scanner scanner {m_encoding};
    qsizetype end = 0;
    for (;;) {
        const qsizetype next = end + scanner.next(bytes.sliced(end)).bytes;
        if (next > size)
            return bytes.first(end);
        end = next;
    }
}

Result<qsizetype> TextCodec::byteCount(QStringView text) const
{
    return encode(text).map([](const QByteArray &bytes) { return bytes.size(); });
}

} // namespace protocol
