// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "files/jobdiff.h"
#include "files/preflight.h"

namespace fuzz {

namespace {

/// Any bytes taken for a job come back as they were, and a comparison with itself finds nothing.
void take(QByteArrayView data)
{
    const QByteArray content = data.toByteArray();
    const files::Job job = files::parseJob(content);
    require(print(job) == content, "a job lost bytes");
    require(diffJobs(job, job, {}).isEmpty(), "a job differs from itself");
    require(std::ranges::all_of(job.instructions, [&](int line) { return line < job.lines.size(); }),
        "an instruction is nowhere");
    (void)job.labels();
    (void)job.calls();
    (void)files::preflight(*values::FileName::create("A.JBI"), content);
}

Seeds seeds() { return demoFiles(".JBI"); }

} // namespace

extern const Target job;
const Target job {"job", take, seeds};

} // namespace fuzz
