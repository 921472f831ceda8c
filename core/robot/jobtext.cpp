// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/jobtext.h"

namespace robot {

namespace {

/// What follows `key` and a space, if `line` begins with it.
void takeField(QByteArray &field, const QByteArray &line, QByteArrayView key)
{
    if (field.isEmpty() && line.startsWith(key))
        field = line.mid(key.size()).trimmed();
}

QByteArray calledJob(const QByteArray &line)
{
    const qsizetype at = line.indexOf("JOB:");
    if (at < 0)
        return {};
    const qsizetype end = line.indexOf(' ', at);
    return line.mid(at, end < 0 ? -1 : end - at);
}

void addMark(JobText &job, const QByteArray &line, int number)
{
    if (line.startsWith('*'))
        job.marks << JobMark {JobMark::Kind::Label, number, line};
    else if (line.startsWith("CALL ") && !calledJob(line).isEmpty())
        job.marks << JobMark {JobMark::Kind::Call, number, calledJob(line)};
}

} // namespace

JobText parseJobText(const QByteArray &jbi)
{
    JobText job;
    bool isInside = false;
    for (const QByteArray &raw : jbi.split('\n')) {
        const QByteArray line = raw.endsWith('\r') ? raw.chopped(1) : raw;
        takeField(job.name, line, "//NAME ");
        takeField(job.comment, line, "///COMM ");
        takeField(job.date, line, "///DATE ");
        isInside = isInside || line.trimmed() == "NOP";
        if (!isInside)
            continue;
        addMark(job, line.trimmed(), int(job.lines.size()));
        job.lines << line;
        if (line.trimmed() == "END")
            break;
    }
    return job;
}

} // namespace robot
