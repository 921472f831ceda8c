// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "inform/jobdiff.h"

/// The parts of diffJobs().
namespace inform {

[[nodiscard]] QList<JobEdit> diffHeaders(const Job &older, const Job &newer, const Clean &clean);

/// What differs in two lines that are the same line, by the controller's numbers; their points left out.
[[nodiscard]] QList<JobEdit> diffStatements(
    const Job &older, int oldLine, const Job &newer, int newLine, const Clean &clean);

} // namespace inform
