// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "protocol/text.h"

using namespace protocol;
using namespace values;

namespace fuzz {

namespace {

/// A text with the mark of a byte: on its way out that byte may join with what follows it.
bool hasMarks(const QString &text) { return text.contains(u'\u27E8'); }

/// Bytes become a text, and that becomes bytes that mean the same.
void comesBack(const TextCodec &codec, QByteArrayView bytes)
{
    const QString decoded = codec.decode(bytes);
    require(decoded.isEmpty() == bytes.isEmpty(), "a text was dropped");
    const auto encoded = codec.encode(decoded);
    require(encoded.has_value(), "a text that came cannot be sent");
    require(hasMarks(decoded) || codec.decode(*encoded) == decoded, "a text changed on the way back");
}

void isFitted(const TextCodec &codec, QByteArrayView bytes, qsizetype size)
{
    const auto fitted = codec.fit(bytes, size);
    require(fitted.size() <= size && bytes.startsWith(fitted), "fit() is no start of the text");
    require(codec.decode(bytes).startsWith(codec.decode(fitted)), "fit() cut a character");
}

/// A typed text becomes bytes that mean the same, or none.
void goesOut(const TextCodec &codec, const QString &typed)
{
    if (const auto encoded = codec.encode(typed))
        require(hasMarks(typed) || codec.decode(*encoded) == typed, "a text changed on the way out");
}

void take(QByteArrayView data)
{
    Source source {data};
    const TextCodec codec {source.choose(encodings()).encoding};
    const quint8 direction = source.byte();
    const qsizetype size = source.byte();
    switch (direction % 3) {
    case 0: comesBack(codec, source.rest()); break;
    case 1: isFitted(codec, source.rest(), size); break;
    default: goesOut(codec, QString::fromUtf8(source.rest()));
    }
}

Seeds seeds()
{
    Seeds seeds;
    for (const QString &text : {QStringLiteral("MOVE"), QStringLiteral("Grüße"), QStringLiteral("ロボットﾃｽﾄ"),
             QStringLiteral("机器人"), QStringLiteral("로봇"), QStringLiteral("⟨8A⟩")}) {
        for (quint8 number = 0; number < encodings().size(); ++number) {
            const auto bytes = TextCodec {encodings()[number].encoding}.encode(text);
            if (!bytes)
                continue;
            for (const char direction : {'\0', '\1'})
                seeds << char(number) + QByteArray {1, direction} + '\5' + *bytes;
            seeds << char(number) + QByteArrayLiteral("\2\5") + text.toUtf8();
        }
    }
    return seeds;
}

} // namespace

extern const Target text;
const Target text {"text", take, seeds, 48};

} // namespace fuzz
