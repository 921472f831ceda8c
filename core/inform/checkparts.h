// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "inform/check.h"

/// The parts of check(). Each appends what it finds.
namespace inform {

void checkHeader(const Job &job, QList<Finding> &findings);
void checkPoints(const Job &job, QList<Finding> &findings);
void checkLines(const Job &job, QList<Finding> &findings);
void checkStructures(const Job &job, QList<Finding> &findings);

/// Whether the text cannot be read as lines of bytes at all: one finding says so and nothing else is looked at.
[[nodiscard]] bool isUnreadable(const QList<Finding> &findings);

/// What is wrong with one line, by the controller's number.
[[nodiscard]] inline Finding atLine(Fault fault, const Job &job, int number, const QByteArray &detail = {})
{
    return {fault, job.instructions[std::size_t(number)] + 1, number, detail};
}

} // namespace inform
