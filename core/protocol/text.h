// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/error.h"
#include <QByteArrayView>
#include <QString>
#include <QStringConverter>
#include <span>

namespace protocol {

/// The encodings that a pendant may use, by its language (reference §8). All of them hold ASCII as it is.
enum class Encoding { Latin1, Utf8, ShiftJis, Gbk, Big5, EucKr };

struct EncodingName {
    Encoding encoding;
    const char *key; ///< As in settings and on the command line, and as Qt and ICU know it.
};

/// All encodings, in the order of a menu.
[[nodiscard]] std::span<const EncodingName> encodings();
/// The key of an encoding.
[[nodiscard]] const char *encodingKey(Encoding encoding);
/// The encoding with this key, any case; nullopt if there is none.
[[nodiscard]] std::optional<Encoding> findEncoding(QStringView key);

/// Turns a controller's bytes into text and back. Bytes that the encoding does not know are shown as ⟨8A⟩, and become
/// that byte again on the way back: no byte is ever dropped.
class TextCodec
{
public:
    explicit TextCodec(Encoding encoding = Encoding::Latin1) : m_encoding {encoding} { }

    [[nodiscard]] Encoding encoding() const { return m_encoding; }
    [[nodiscard]] QString decode(QByteArrayView bytes) const;
    /// BadInput names the first character that the encoding does not hold.
    [[nodiscard]] values::Result<QByteArray> encode(QStringView text) const;
    /// The longest start of `bytes` that is at most `size` bytes and does not cut a character.
    [[nodiscard]] QByteArrayView fit(QByteArrayView bytes, qsizetype size) const;
    /// How many bytes `text` takes; an error as encode().
    [[nodiscard]] values::Result<qsizetype> byteCount(QStringView text) const;

private:
    Encoding m_encoding;
};

} // namespace protocol
