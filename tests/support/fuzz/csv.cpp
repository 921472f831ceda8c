// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "variables/sheet.h"

namespace fuzz {

namespace {

using namespace variables;

/// A table that is read is written so that it reads the same.
void comesBack(const Table &table)
{
    QString written;
    for (const Line &line : table.lines)
        written += csvLine(line.cells, table.separator);
    const auto again = readTable(written);
    require(again && again->lines.size() == table.lines.size(), "lines were lost");
    if (again->separator != table.separator)
        return; // the first line has none
    for (qsizetype index = 0; index < table.lines.size(); ++index)
        require(again->lines[index].cells == table.lines[index].cells, "cells changed on the way");
}

/// A file of variables: nothing of it is wanted while anything is wrong with it, and each value fits its variable.
void take(QByteArrayView data)
{
    const auto text = textOfFile(data);
    const auto table = text ? readTable(*text) : values::Result<Table> {tl::unexpected(text.error())};
    if (!table) {
        require(!table.error().detail.isEmpty(), "a refusal without a sentence");
        return;
    }
    comesBack(*table);
    const auto found = preview(*table, {}, protocol::dialect(protocol::Model::YRC1000),
        [](const Reference &) { return std::optional<Value> {}; });
    for (const Difference &difference : found.differences)
        require(kindOf(difference.value) == difference.variable.kind, "a value of another kind");
    for (const Problem &problem : found.problems)
        require(!problem.reason.isEmpty(), "a problem without a sentence");
}

Seeds seeds()
{
    return {"variable,value\r\nB000,12\r\nS001,\"a \"\"b\"\"\"\r\nR002,1.5\r\n",
        "\xEF\xBB\xBFvariable;value;type;tool;frame;form;extended form;axis 1;axis 2\r\nP001;;pulse;0;0;;;100;-5\r\n",
        "variable\tvalue\r\nI001\t-32769\r\nB000\t1\r\nB000\t2\r\n", "name,value\n\"open"};
}

} // namespace

extern const Target csv;
const Target csv {"csv", take, seeds, 400};

} // namespace fuzz
