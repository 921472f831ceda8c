// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QtGlobal>
#include <array>

namespace values {

/// Encoder temperatures of a control group, a word an axis, in °C (reference §3.11; unit and sign are inferred there).
struct EncoderTemperatures {
    std::array<qint32, 8> celsius {}; ///< 0 for an axis that is not there.

    bool operator==(const EncoderTemperatures &) const = default;
};

/// Converter temperature of a servo board in °C (reference §3.11).
struct ConverterTemperature {
    std::array<qint32, 6> words {}; ///< Only the first is used.

    [[nodiscard]] qint32 celsius() const { return words.front(); }
    bool operator==(const ConverterTemperature &) const = default;
};

} // namespace values
