// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/error.h"
#include <QString>
#include <span>

namespace protocol {

/// One added-status code in words (reference §9). The texts are translated when asked for.
struct StatusCode {
    quint16 code;
    const char *meaning;
    const char *remedy; ///< What usually helps; empty where nobody knows.
};

/// All codes, by number.
[[nodiscard]] std::span<const StatusCode> statusCodes();
/// The row of a code; nullptr for a code that the reference does not list.
[[nodiscard]] const StatusCode *findStatusCode(quint16 code);

/// The code that says why a reply is a refusal, the bare statuses 0x08, 0x09 and 0x28 taken for their equals 0xA000,
/// 0xA002 and 0xA001 (reference §1.6).
/// A position variable that was never set (reference §4.4): no fault, and no refusal of the reader.
[[nodiscard]] bool isNotTaught(const values::Error &error);
[[nodiscard]] quint16 effectiveCode(const values::Error &refusal);

/// 0x2090 0xD8F1 0xD8FA 0xE444 0xFFF6: the same request may do in a moment.
[[nodiscard]] bool isBusy(const values::Error &error);

/// Any error in one translated sentence: "0x2070 servo power is off — switch servo on".
[[nodiscard]] QString explain(const values::Error &error);

} // namespace protocol
