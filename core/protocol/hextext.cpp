// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/hextext.h"

namespace protocol {

std::optional<QByteArray> bytesFromHex(const QString &text)
{
    const QByteArray digits = text.simplified().remove(u' ').toLatin1();
    const QByteArray bytes = QByteArray::fromHex(digits);
    if (digits.isEmpty() || bytes.toHex() != digits.toLower())
        return std::nullopt;
    return bytes;
}

} // namespace protocol
