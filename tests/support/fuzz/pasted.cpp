// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "variables/sheet.h"

namespace fuzz {

namespace {

using namespace variables;

/// The first byte chooses where a block of a spreadsheet is pasted.
void take(QByteArrayView data)
{
    Source source {data};
    const Reference first {source.choose(allKinds), 5};
    const auto found = previewBlock(source.text(), first, {}, protocol::dialect(protocol::Model::DX200),
        [](const Reference &) { return std::optional<Value> {}; });
    for (const Difference &difference : found.differences)
        require(kindOf(difference.value) == difference.variable.kind, "a value of another kind");
    for (const Problem &problem : found.problems)
        require(!problem.reason.isEmpty(), "a problem without a sentence");
}

Seeds seeds()
{
    return {
        QByteArray {"\0", 1} + "1\n2\n3\n", QByteArray {"\0", 1} + "B001\t5\nB002\t6", "\5variable\taxis 1\nP001\t5"};
}

} // namespace

extern const Target pasted;
const Target pasted {"pasted", take, seeds, 200};

} // namespace fuzz
