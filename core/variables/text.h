// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/text.h"
#include "variables/number.h"
#include "variables/value.h"

namespace variables {

/// How values are written: what the person sees and types, or what stands in a file.
struct Format {
    QLocale locale = QLocale::c();
    protocol::TextCodec codec {};
    int stringSize = 16; ///< Bytes of an S variable: 16 or 32.
    Base registerBase = Base::Decimal;
};

/// A value as one line of text. Positions are for reading: "base frame X 812.500 …".
[[nodiscard]] QString toText(const Value &value, const Format &format);

/// The value that a person typed or a file holds. BadInput with a whole, translated sentence if it is none, out of the
/// kind's range (B 0 to 255, I -32768 to 32767, …) or text that the controller's encoding or the variable cannot hold.
/// Positions have many parts and no such text: see axisFromText().
[[nodiscard]] values::Result<Value> fromText(Kind kind, QStringView typed, const Format &format);

/// "0 … 255" and the like: what a kind takes, in few words; empty for positions.
[[nodiscard]] QString rangeText(Kind kind, const Format &format);

/// Decimals of an axis word: 0 for pulses, 3 for millimetres, 4 for degrees (reference §5.1).
constexpr int decimalsOf(values::AxisUnit unit)
{
    return unit == values::AxisUnit::Pulse ? 0 : unit == values::AxisUnit::Micrometre ? 3 : 4;
}
/// "pulse", "mm", "°".
[[nodiscard]] QString unitText(values::AxisUnit unit);
/// One axis word, in pulses, mm or degrees.
[[nodiscard]] QString axisText(qint32 word, values::AxisUnit unit, const QLocale &locale);
[[nodiscard]] values::Result<qint32> axisFromText(QStringView typed, values::AxisUnit unit);
/// "X" or "S": what an axis is called where the controller's own names are not known (reference §5.1).
[[nodiscard]] QString axisName(Kind kind, values::PositionType type, int axis);

} // namespace variables
