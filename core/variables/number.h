// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/error.h"
#include <QLocale>

namespace variables {

/// How whole numbers of 16 bits are written: registers are bit patterns as often as numbers.
enum class Base { Decimal, Signed, Hex, Binary };

/// A whole number from `least` to `most`, typed in any script; "0x" and "0b" in front are understood. BadInput with a
/// whole, translated sentence for anything else.
[[nodiscard]] values::Result<qint64> wholeNumber(QStringView typed, qint64 least, qint64 most);
/// The same for 16 bits in the base of the display: a negative number is taken for its bit pattern, as Signed shows it.
[[nodiscard]] values::Result<quint16> bits16(QStringView typed, Base base);
/// "65535", "-1", "0xFFFF", "0b1111111111111111".
[[nodiscard]] QString toText(quint16 bits, Base base);

/// A single-precision real, rounded once. "." and "," are both the decimal point. What is no number, is infinite or too
/// small for a real is BadInput.
[[nodiscard]] values::Result<float> real(QStringView typed);
/// The shortest text that means this real, with the locale's decimal point.
[[nodiscard]] QString toText(float value, const QLocale &locale);

/// A number with at most `decimals` decimals as a count of its last place, exactly: "812,5" with 3 decimals is 812500.
/// BadInput for more decimals and for what does not go into 32 bits.
[[nodiscard]] values::Result<qint32> fixedPoint(QStringView typed, int decimals);
/// The reverse, with every decimal and the locale's decimal point.
[[nodiscard]] QString toText(qint32 value, int decimals, const QLocale &locale);

} // namespace variables
