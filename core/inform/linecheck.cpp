// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/checkparts.h"
#include "inform/references.h"

#include <QSet>
#include <algorithm>

namespace inform {

namespace {

using Findings = QList<Finding>;

constexpr qsizetype mostTextBytes = 32; // reference §4
constexpr qsizetype mostLabelBytes = 8;
constexpr int lastLine = 9999;
constexpr qsizetype mostArguments = 8;

void checkEnds(const Job &job, Findings &findings)
{
    const int last = job.lineCount() - 1;
    const auto at = [&](Fault fault, int line) { return last < 0 ? Finding {fault} : atLine(fault, job, line); };
    if (last < 0 || job.instruction(0) != "NOP")
        findings << at(Fault::NoNop, 0);
    if (last < 0 || job.instruction(last) != "END")
        findings << at(Fault::NoEnd, last);
    if (last > lastLine)
        findings << atLine(Fault::TooManyLines, job, lastLine + 1);
    for (int number = 0; number < last; ++number) {
        if (job.instruction(number) == "END") {
            findings << atLine(Fault::EndInside, job, number);
            return;
        }
    }
}

void checkBlankLines(const Job &job, Findings &findings)
{
    const int last = job.instructions.empty() ? 0 : job.instructions.back();
    for (int index = job.instructions.empty() ? 0 : job.instructions.front(); index < last; ++index) {
        if (job.lines[std::size_t(index)].kind == LineKind::Blank) {
            findings << Finding {Fault::BlankLine, index + 1};
            return;
        }
    }
}

/// The labels of a job, and what is wrong with them.
QSet<QByteArray> checkLabels(const Job &job, Findings &findings)
{
    QSet<QByteArray> labels;
    for (const Mark &label : job.labels()) {
        if (labels.contains(label.name))
            findings << atLine(Fault::LabelTwice, job, label.line, label.name);
        if (label.name.size() > mostLabelBytes)
            findings << atLine(Fault::LongLabel, job, label.line, label.name);
        labels.insert(label.name);
    }
    return labels;
}

/// Looks at one line.
class LineCheck
{
public:
    LineCheck(const Job &job, int number, const QSet<QByteArray> &labels, Findings &findings)
        : m_job {job}, m_number {number}, m_labels {labels}, m_findings {findings}, m_line {statement(job, number)}
    {
    }
    void run();

private:
    void add(Fault fault, const QByteArray &detail = {}) { m_findings << atLine(fault, m_job, m_number, detail); }
    void checkWord(const Part &part);
    void checkUnknownText();
    void checkTexts();
    void checkJumps();
    void checkRanges(const Part &part);
    void checkArguments(const Part &part);
    void checkLocals();

    const Job &m_job;
    int m_number;
    const QSet<QByteArray> &m_labels;
    Findings &m_findings;
    Statement m_line;
};

void LineCheck::run()
{
    checkTexts();
    checkUnknownText();
    if (m_line.isCommentedOut)
        return;
    for (const Part &part : m_line.parts) {
        checkWord(part);
        checkRanges(part);
        checkArguments(part);
    }
    checkJumps();
    checkLocals();
}

void LineCheck::checkWord(const Part &part)
{
    if (part.word.isEmpty())
        add(Fault::NoInstruction);
    else if (!part.row)
        add(Fault::UnknownWord, part.word.toByteArray());
}

void LineCheck::checkUnknownText()
{
    const Line &line = m_job.at(m_number);
    for (const Token &token : m_job.tokensOf(line)) {
        const QByteArrayView text = token.in(line.text);
        const bool isOdd = std::ranges::any_of(text, [](char byte) { return quint8(byte) >= 0x7F; });
        if (token.kind == TokenKind::Unknown && isOdd)
            return add(Fault::UnknownCharacters);
    }
}

void LineCheck::checkTexts()
{
    bool isLong = m_line.comment.size() > mostTextBytes;
    for (const Part &part : m_line.parts) {
        const Term *text = part.word == "MSG" ? part.positional(0) : nullptr;
        isLong = isLong || (text && text->text.size() > mostTextBytes);
    }
    if (isLong)
        add(Fault::LongText);
}

void LineCheck::checkJumps()
{
    for (const LabelUse &use : labelUses(m_line)) {
        if (!use.label.isEmpty() && !m_labels.contains(use.label))
            add(Fault::NoLabel, use.label);
    }
}

void LineCheck::checkRanges(const Part &part)
{
    for (const Operand &operand : part.operands) {
        const Tag *tag = operand.term.kind == TermKind::Number ? findTag(operand.tag) : nullptr;
        const bool hasRange = tag && tag->least != tag->most;
        if (hasRange && (operand.term.value < tag->least || operand.term.value > tag->most))
            add(Fault::OutOfRange, operand.tag.toByteArray() + '=' + operand.term.written.toByteArray());
    }
}

void LineCheck::checkArguments(const Part &part)
{
    if (std::ranges::count(part.operands, QByteArrayView {"ARGF"}, &Operand::tag) > mostArguments)
        add(Fault::TooManyArguments);
}

void LineCheck::checkLocals()
{
    for (const Reference &each : references(m_job, m_number)) {
        if (!each.isLocal || each.isAny)
            continue;
        const auto name = variableName(each.name);
        for (std::size_t kind = 0; name && kind < localKinds.size(); ++kind) {
            if (localKinds[kind] == 'L' + name->type.toByteArray() && name->number >= m_job.locals[kind])
                return add(Fault::LocalBeyond, each.name);
        }
    }
}

} // namespace

void checkLines(const Job &job, QList<Finding> &findings)
{
    checkEnds(job, findings);
    checkBlankLines(job, findings);
    const QSet<QByteArray> labels = checkLabels(job, findings);
    for (int number = 0; number < job.lineCount(); ++number)
        LineCheck {job, number, labels, findings}.run();
}

void checkStructures(const Job &job, QList<Finding> &findings)
{
    constexpr std::size_t deepest = 10;
    struct Open {
        Structure structure;
        int line;
        QByteArray word;
    };
    std::vector<Open> open;
    for (int number = 0; number < job.lineCount(); ++number) {
        const QByteArrayView word = job.word(number);
        const Instruction *row = job.isCommentedOut(number) ? nullptr : findInstruction(word);
        if (!row || row->block == Block::None)
            continue;
        if (row->block == Block::Opens) {
            open.push_back({row->structure, number, word.toByteArray()});
            if (open.size() == deepest + 1)
                findings << atLine(Fault::TooDeep, job, number);
        } else if (open.empty() || open.back().structure != row->structure) {
            findings << atLine(Fault::NotOpened, job, number, word.toByteArray());
            return; // what follows would only repeat it
        } else if (row->block == Block::Closes) {
            open.pop_back();
        }
    }
    if (!open.empty())
        findings << atLine(Fault::NotClosed, job, open.back().line, open.back().word);
}

QList<Finding> check(const Job &job)
{
    QList<Finding> findings = checkText(job);
    if (isUnreadable(findings))
        return findings;
    if (!job.isJob)
        return findings << Finding {Fault::NotAJob};
    checkHeader(job, findings);
    checkPoints(job, findings);
    checkLines(job, findings);
    checkStructures(job, findings);
    std::ranges::stable_sort(findings, {}, &Finding::fileLine);
    return findings;
}

} // namespace inform
