// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/checkparts.h"

#include <algorithm>
#include <array>

namespace inform {

namespace {

bool isControl(char byte) { return quint8(byte) < 0x20 && byte != '\t' && byte != '\r' && byte != '\n'; }

/// Every other byte is 0, which no pendant encoding has.
bool isWide(QByteArrayView text)
{
    return text.startsWith("\xFF\xFE") || text.startsWith("\xFE\xFF")
        || (text.size() > 3 && std::ranges::count(text.first(4), '\0') == 2);
}

void addFirst(QList<Finding> &findings, Fault fault, const Job &job, auto isFaulty)
{
    const auto found = std::ranges::find_if(job.lines, isFaulty);
    if (found != job.lines.end())
        findings << Finding {fault, int(found - job.lines.begin()) + 1};
}

/// The whole of the last line, or the end of it.
bool endsInControlZ(const Job &job) { return job.text.endsWith('\x1a'); }

constexpr std::array knownHeaders {"/JOB", "//NAME", "///FOLDERNAME", "//POS", "///NPOS", "///USER", "///TOOL",
    "///POSTYPE", "///LIMIT", "///PULSE", "///RECTAN", "///ANGLE", "///RCONF", "//ALIAS", "///GVARS", "///LVARS",
    "//ARGINFO", "///ARGTYPE", "///COMMENT", "//INST", "///DATE", "///COMM", "///ATTR", "////FRAME", "///FRAME"};

bool isKnownHeader(QByteArrayView key)
{
    return key.startsWith("///GROUP")
        || std::ranges::any_of(knownHeaders, [key](const char *known) { return key == known; });
}

QByteArrayView keyOf(const Line &line)
{
    const QByteArrayView text = withoutBlanks(line.text);
    const qsizetype space = text.indexOf(' ');
    return space < 0 ? text : text.first(space);
}

bool isStray(const Job &job, const Line &line)
{
    return line.kind == LineKind::Foreign && line.section != Section::Positions && job.jobs <= 1 && line.text != "\x1a";
}

} // namespace

bool isUnreadable(const QList<Finding> &findings)
{
    return std::ranges::any_of(findings, [](const Finding &finding) {
        return finding.fault == Fault::Utf16 || finding.fault == Fault::CarriageReturns
            || finding.fault == Fault::ByteOrderMark;
    });
}

QList<Finding> checkText(const Job &job)
{
    QList<Finding> findings;
    if (isWide(job.text))
        findings << Finding {Fault::Utf16};
    else if (job.text.startsWith("\xEF\xBB\xBF"))
        findings << Finding {Fault::ByteOrderMark, 1};
    else if (job.text.contains('\r') && !job.text.contains('\n'))
        findings << Finding {Fault::CarriageReturns, 1};
    if (isUnreadable(findings))
        return findings;
    addFirst(findings, job.isJob ? Fault::LineFeeds : Fault::LineFeedsInData, job,
        [](const Line &line) { return line.ending == "\n"; });
    if (endsInControlZ(job))
        findings << Finding {Fault::ControlZ, int(job.lines.size())};
    else if (!job.lines.empty() && job.lines.back().ending.isEmpty())
        findings << Finding {Fault::NoLastLineEnd, int(job.lines.size())};
    addFirst(findings, Fault::ControlCharacter, job, [&job](const Line &line) {
        const bool isLast = &line == &job.lines.back() && endsInControlZ(job);
        return std::ranges::any_of(isLast ? line.text.chopped(1) : line.text, isControl);
    });
    return findings;
}

void checkHeader(const Job &job, QList<Finding> &findings)
{
    constexpr qsizetype mostCommentBytes = 32;
    if (job.jobs > 1)
        findings << Finding {Fault::SeveralJobs};
    if (!isJobName(job.name)) {
        const auto line = std::ranges::find_if(job.lines, [](const Line &each) { return keyOf(each) == "//NAME"; });
        findings << Finding {
            Fault::BadName, line == job.lines.end() ? 0 : int(line - job.lines.begin()) + 1, -1, job.name};
    }
    addFirst(findings, Fault::StrayText, job, [&job](const Line &line) { return isStray(job, line); });
    for (std::size_t index = 0; index < job.lines.size(); ++index) {
        const Line &line = job.lines[index];
        if (line.kind == LineKind::Header && !isKnownHeader(keyOf(line)))
            findings << Finding {Fault::UnknownHeader, int(index) + 1, -1, keyOf(line).toByteArray()};
    }
    if (job.comment.size() > mostCommentBytes)
        findings << Finding {Fault::LongJobComment};
    const bool isRelative = job.attributes.contains("RJ");
    if (isRelative && job.frame.isEmpty())
        findings << Finding {Fault::RelativeWithoutFrame};
    if (!isRelative && !job.frame.isEmpty())
        findings << Finding {Fault::FrameWithoutRelative};
}

} // namespace inform
