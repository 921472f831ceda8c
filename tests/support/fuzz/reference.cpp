// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "names/signal.h"
#include "variables/reference.h"

namespace fuzz {

namespace {

/// The first byte chooses a controller; then what a person typed for a variable, a range of them, or a signal.
void take(QByteArrayView data)
{
    Source source {data};
    const auto &dialect = protocol::dialect(source.choose(protocol::allModels));
    const QString typed = source.text();
    if (const auto found = variables::referenceFromText(typed, dialect)) {
        require(found->number < countOf(found->kind, dialect), "a variable that is not there");
        require(variables::referenceFromText(toString(*found), dialect) == *found, "a variable changed on the way");
    }
    if (const auto range = variables::rangeFromText(typed, dialect))
        require(range->first >= 0 && range->first <= range->last && range->last < countOf(range->kind, dialect),
            "a range that is not there");
    if (const auto signal = names::signalFromText(typed, dialect)) {
        require(signal->bit >= 0 && signal->bit < names::signalsPerGroup, "a signal that is not there");
        require(names::signalFromText(toString(*signal), dialect) == *signal, "a signal changed on the way");
    }
}

Seeds seeds()
{
    Seeds seeds;
    for (const char *typed : {"B000", "bp 12", "D000..D099", "D0..99", "D9..0", "#00010", "27010", "IN#(1)", "OUT#12",
             "OT#(", "M5", "B99999999999", "P-1"})
        seeds << QByteArray {1, '\3'} + typed;
    return seeds;
}

} // namespace

extern const Target reference;
const Target reference {"reference", take, seeds, 32};

} // namespace fuzz
