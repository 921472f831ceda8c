// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "inform/job.h"
#include "virtualcontroller/program.h"
#include <algorithm>

namespace fuzz {

namespace {

/// What the virtual controller runs is a job: a name, NOP first, END last, and labels on lines of it.
void take(QByteArrayView data)
{
    using namespace virtualcontroller;
    const auto program = parseProgram(data.toByteArray());
    if (!program) {
        require(program.error() != 0, "a refusal without a reason");
        return;
    }
    const auto &lines = program->lines;
    const int count = int(lines.size());
    require(inform::isJobName(program->name), "a job without a name");
    require(count >= 2 && lines.front().word() == "NOP" && lines.back().word() == "END", "a job without NOP and END");
    require(std::ranges::all_of(program->labels, [&](const auto &label) { return lines[label.second].isLabel(); }),
        "a label is elsewhere");
    require(program->stepAt(count) == program->stepAt(count - 1) && program->stepAt(count) <= count, "too many steps");
}

Seeds seeds() { return demoFiles(".JBI"); }

} // namespace

extern const Target program;
const Target program {"program", take, seeds};

} // namespace fuzz
