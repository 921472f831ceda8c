// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "variables/text.h"
#include <cmath>

namespace fuzz {

namespace {

using namespace variables;

template <typename Number> void comesBack(const values::Result<Number> &read, auto &&readAgain)
{
    if (!read) {
        require(!read.error().detail.isEmpty(), "a refusal without a sentence");
        return;
    }
    const auto again = readAgain(*read);
    require(again && *again == *read, "a number changed on the way");
}

/// The first byte chooses a kind of number; what a person typed follows.
void take(QByteArrayView data)
{
    Source source {data};
    const quint8 what = source.byte();
    const Base base = Base(source.byte() % 4);
    const QString typed = source.text();
    const QLocale c = QLocale::c();
    switch (what % 5) {
    case 0:
        return comesBack(wholeNumber(typed, -128, 255),
            [](qint64 number) { return wholeNumber(QString::number(number), -128, 255); });
    case 1: return comesBack(bits16(typed, base), [&](quint16 bits) { return bits16(toText(bits, base), base); });
    case 2: return comesBack(real(typed), [&](float number) { return real(toText(number, c)); });
    case 3: return comesBack(fixedPoint(typed, 3), [&](qint32 count) { return fixedPoint(toText(count, 3, c), 3); });
    default:
        for (const Kind kind : {Kind::B, Kind::I, Kind::D, Kind::R, Kind::M}) {
            if (const auto value = fromText(kind, typed, {}))
                require(
                    kindOf(*value) == kind && fromText(kind, toText(*value, {}), {}).has_value(), "a value is lost");
        }
    }
}

Seeds seeds()
{
    Seeds seeds;
    for (const char what : {'\0', '\1', '\2', '\3', '\4'}) {
        for (const char *typed :
            {"12", "-5", "0xFFFF", "0b101", "1.5", "1,5", "1e38", "-0", "99999999999", "٣", "１２", ""})
            seeds << QByteArray {1, what} + '\2' + typed;
    }
    return seeds;
}

} // namespace

extern const Target number;
const Target number {"number", take, seeds, 40};

} // namespace fuzz
