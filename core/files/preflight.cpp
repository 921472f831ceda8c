// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/preflight.h"

#include <algorithm>

using inform::Fault;
using inform::Finding;
using values::FileName;

namespace files {

namespace {

bool isOneOf(const QByteArray &word, std::initializer_list<const char *> words)
{
    return std::ranges::any_of(words, [&word](const char *each) { return word == each; });
}

QByteArray typeOf(const FileName &name) { return name.extension().toByteArray().toUpper(); }

QList<Finding> lookAtType(const FileName &name)
{
    if (!isLoadable(name))
        return {{Fault::NotLoadable, 0, -1, name.extension().toByteArray()}};
    if (name.extension() != typeOf(name))
        return {{Fault::LowerCaseType}};
    return {};
}

QList<Finding> lookAtJob(const FileName &name, const inform::Job &job, const QByteArrayList &jobsInUse)
{
    QList<Finding> findings;
    if (inform::isJobName(job.name) && job.name != name.base())
        findings << Finding {Fault::NameDiffers, 0, -1, job.name};
    if (jobsInUse.contains(name.base()) || jobsInUse.contains(job.name))
        findings << Finding {Fault::Running};
    return findings << inform::check(job);
}

} // namespace

bool isLoadable(const FileName &name) { return isOneOf(typeOf(name), {"JBI", "JBR", "CND", "DAT", "PRM", "LST"}); }

bool isJobFile(const FileName &name) { return isOneOf(typeOf(name), {"JBI", "JBR"}); }

QList<Finding> preflight(const FileName &name, const QByteArray &content, const QByteArrayList &jobsInUse)
{
    if (content.isEmpty())
        return {{Fault::Empty}};
    QList<Finding> findings = lookAtType(name);
    const inform::Job job = inform::parse(content);
    if (isJobFile(name))
        return findings << lookAtJob(name, job, jobsInUse);
    if (isOneOf(name.base().toByteArray(), {"IONAME", "VARNAME"}))
        findings << Finding {Fault::ReplacesNames};
    return findings << inform::checkText(job);
}

bool mayBeSent(const QList<Finding> &findings) { return std::ranges::none_of(findings, &Finding::isError); }

QString explain(const Finding &finding, const protocol::TextCodec &codec)
{
    const QString what = inform::explain(finding, [&codec](QByteArrayView bytes) { return codec.decode(bytes); });
    return what + u' ' + inform::reason(finding);
}

} // namespace files
