// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "files/preflight.h"
#include "inform/jobdiff.h"
#include "inform/references.h"
#include <algorithm>

namespace fuzz {

namespace {

/// Tokens follow each other within their line.
void areInOrder(const inform::Job &job)
{
    for (const inform::Line &line : job.lines) {
        int end = 0;
        for (const inform::Token &token : job.tokensOf(line)) {
            require(token.at >= end && token.size > 0, "tokens overlap");
            end = token.at + token.size;
        }
        require(end <= line.text.size(), "a token leaves its line");
    }
}

/// What a job of these bytes means is found without end or crash.
void isUnderstood(const inform::Job &job)
{
    for (int number = 0; number < job.lineCount(); ++number) {
        (void)references(job, number);
        (void)labelUses(statement(job, number));
    }
    (void)job.labels();
    (void)job.calls();
}

/// Two versions of one job: a part of it stands once more at the end of the newer one.
void areCompared(const QByteArray &content)
{
    const QByteArray newer = content + content.mid(content.size() / 3, content.size() / 3);
    for (const inform::JobEdit &edit : diffJobs(inform::parse(content), inform::parse(newer))) {
        const QString text = explain(edit, [](QByteArrayView bytes) { return QString::fromLatin1(bytes); });
        require(!text.isEmpty(), "an edit has no words");
    }
}

/// Any bytes taken for a job come back as they were, and a comparison with itself finds nothing.
void take(QByteArrayView data)
{
    const QByteArray content = data.toByteArray();
    const inform::Job job = inform::parse(content);
    require(print(job) == content, "a job lost bytes");
    require(diffJobs(job, job).isEmpty(), "a job differs from itself");
    areInOrder(job);
    isUnderstood(job);
    areCompared(content);
    for (const inform::Finding &finding : files::preflight(*values::FileName::create("A.JBI"), content))
        require(!files::explain(finding, protocol::TextCodec {}).isEmpty(), "a finding has no words");
}

Seeds seeds() { return demoFiles(".JBI"); }

} // namespace

extern const Target job;
const Target job {"job", take, seeds, 1000, 5000};

} // namespace fuzz
