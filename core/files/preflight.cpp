// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/preflight.h"

#include "files/inform.h"
#include <QCoreApplication>
#include <algorithm>
#include <array>

using values::FileName;

namespace files {

namespace {

struct PreflightTexts {
    Q_DECLARE_TR_FUNCTIONS(files::Preflight)
};

using Findings = QList<Finding>;
constexpr qsizetype maxComment = 32;

bool isOneOf(QByteArrayView word, std::initializer_list<QByteArrayView> words)
{
    return std::ranges::find(words, word) != words.end();
}

bool isControl(char byte) { return quint8(byte) < 0x20 && byte != '\t'; }
bool isBeyondAscii(char byte) { return quint8(byte) >= 0x7F; }

/// The first of each kind is enough: the others have the same remedy.
void addFirst(Findings &findings, Concern concern, const QList<Line> &lines, auto isFaulty)
{
    const auto found = std::ranges::find_if(lines, isFaulty);
    if (found != lines.end())
        findings << Finding {concern, int(found - lines.begin()) + 1};
}

Findings lookAtText(const QList<Line> &lines)
{
    Findings findings;
    addFirst(findings, Concern::ControlCharacter, lines,
        [](const Line &line) { return std::ranges::any_of(line.text, isControl); });
    addFirst(findings, Concern::LineEndings, lines, [](const Line &line) { return line.ending == "\n"; });
    if (lines.last().ending.isEmpty())
        findings << Finding {Concern::NoFinalNewline, int(lines.size())};
    return findings;
}

Findings lookAtName(const FileName &name, const Job &job)
{
    if (!isJobName(job.name))
        return {{Concern::BadJobName, 0, QString::fromLatin1(job.name)}};
    if (job.name != name.base())
        return {{Concern::NameDiffers, 0, QString::fromLatin1(job.name)}};
    return {};
}

Findings lookAtInstructions(const Job &job)
{
    Findings findings;
    const int last = int(job.instructions.size()) - 1;
    if (last < 0 || job.instruction(0) != "NOP")
        findings << Finding {Concern::NoNop};
    if (last < 0 || job.instruction(last) != "END")
        findings << Finding {Concern::NoEnd};
    return findings;
}

bool mayBeText(LineKind kind) { return kind == LineKind::Comment || kind == LineKind::Header; }

Findings lookAtJob(const FileName &name, const Job &job)
{
    if (!job.isJob)
        return {{Concern::NotAJob}};
    Findings findings = lookAtName(name, job) + lookAtInstructions(job);
    if (job.announcedPositions && *job.announcedPositions != job.positions.size())
        findings << Finding {Concern::WrongPositionCount, 0, QString::number(job.positions.size())};
    if (job.comment.size() > maxComment)
        findings << Finding {Concern::LongComment};
    addFirst(findings, Concern::OtherCharacters, job.lines,
        [](const Line &line) { return !mayBeText(line.kind) && std::ranges::any_of(line.text, isBeyondAscii); });
    return findings;
}

} // namespace

bool isLoadable(const FileName &name) { return isOneOf(name.extension(), {"JBI", "JBR", "CND", "DAT", "PRM", "LST"}); }

bool isJobFile(const FileName &name) { return name.extension() == "JBI"; }

QList<Finding> preflight(const FileName &name, const QByteArray &content, const QByteArrayList &jobsInUse)
{
    if (content.isEmpty())
        return {{Concern::Empty}};
    Findings findings;
    if (!isLoadable(name))
        findings << Finding {Concern::NotLoadable, 0, QString::fromLatin1(name.extension())};
    const Job job = parseJob(content);
    if (isJobFile(name)) {
        findings << lookAtJob(name, job);
        if (jobsInUse.contains(name.base()) || jobsInUse.contains(job.name))
            findings << Finding {Concern::Running};
    }
    if (isOneOf(name.base(), {"IONAME", "VARNAME"}))
        findings << Finding {Concern::ReplacesNames};
    findings << lookAtText(job.lines);
    return findings;
}

bool mayBeSent(const QList<Finding> &findings) { return std::ranges::none_of(findings, &Finding::stops); }

QString explain(const Finding &finding)
{
    switch (finding.concern) {
    case Concern::Empty: return PreflightTexts::tr("The file is empty; HSES cannot carry it.");
    case Concern::NotLoadable: return PreflightTexts::tr("Controllers take no files of type “%1”.").arg(finding.detail);
    case Concern::BadJobName: return PreflightTexts::tr("“%1” is no name for a job.").arg(finding.detail);
    case Concern::NameDiffers:
        return PreflightTexts::tr("The header names the job “%1”: that job would be written.").arg(finding.detail);
    case Concern::NotAJob: return PreflightTexts::tr("This is no job: it does not have the line /JOB.");
    case Concern::NoNop: return PreflightTexts::tr("The first instruction is not NOP.");
    case Concern::NoEnd: return PreflightTexts::tr("The last instruction is not END.");
    case Concern::WrongPositionCount:
        return PreflightTexts::tr("///NPOS does not count the positions; there are %1.").arg(finding.detail);
    case Concern::Running: return PreflightTexts::tr("The job is being executed.");
    case Concern::ControlCharacter:
        return PreflightTexts::tr("There is a control character in line %1.").arg(finding.line);
    case Concern::LineEndings:
        return PreflightTexts::tr("Lines do not end in CR LF, from line %1 on.").arg(finding.line);
    case Concern::NoFinalNewline: return PreflightTexts::tr("The last line does not end.");
    case Concern::LongComment: return PreflightTexts::tr("The comment is longer than 32 bytes.");
    case Concern::OtherCharacters:
        return PreflightTexts::tr("Line %1 has characters beyond ASCII outside of a comment.").arg(finding.line);
    case Concern::ReplacesNames:
        return PreflightTexts::tr("All names in the controller become those in this file. Back them up first.");
    }
    return {};
}

} // namespace files
