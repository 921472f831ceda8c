// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QByteArray>
#include <QString>
#include <optional>

namespace protocol {

/// The bytes that a text writes in hex, white space aside; nullopt if it is something else or nothing.
[[nodiscard]] std::optional<QByteArray> bytesFromHex(const QString &text);

} // namespace protocol
