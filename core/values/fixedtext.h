// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QByteArray>
#include <QByteArrayView>
#include <algorithm>
#include <array>

namespace values {

/// Text of a fixed wire size: padded with NUL, without a terminator when full (reference §8). The bytes are kept as
/// they came; protocol::TextCodec turns them into a QString and back. Never allocates.
template <qsizetype Size> class FixedText
{
public:
    static constexpr qsizetype capacity = Size;

    constexpr FixedText() = default;

    /// Takes at most `capacity` bytes and drops the rest; to cut between characters use protocol::TextCodec::fit().
    constexpr explicit FixedText(QByteArrayView bytes)
    {
        std::copy_n(bytes.begin(), std::min(bytes.size(), Size), m_bytes.begin());
    }

    /// The text: everything before the first NUL.
    [[nodiscard]] QByteArrayView bytes() const
    {
        return {m_bytes.data(), std::find(m_bytes.begin(), m_bytes.end(), '\0') - m_bytes.begin()};
    }
    /// All bytes of the field, padding included.
    [[nodiscard]] QByteArrayView raw() const { return {m_bytes.data(), Size}; }
    [[nodiscard]] char *data() { return m_bytes.data(); }
    [[nodiscard]] const char *data() const { return m_bytes.data(); }
    [[nodiscard]] bool isEmpty() const { return m_bytes.front() == '\0'; }

    friend bool operator==(const FixedText &a, const FixedText &b) { return a.bytes() == b.bytes(); }

private:
    std::array<char, Size> m_bytes {};
};

} // namespace values
