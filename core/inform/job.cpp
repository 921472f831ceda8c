// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/job.h"

#include "inform/instructions.h"
#include <algorithm>
#include <cmath>

namespace inform {

namespace {

int kindIndex(QByteArrayView kind)
{
    return int(
        std::ranges::find_if(pointKinds, [kind](const char *each) { return kind == each; }) - pointKinds.begin());
}

bool hasPrefix(const Job &job, int number, QByteArrayView prefix)
{
    const Line &line = job.at(number);
    return std::ranges::any_of(job.tokensOf(line),
        [&](const Token &token) { return token.kind == TokenKind::Prefix && token.in(line.text) == prefix; });
}

bool isStep(const Job &job, int number)
{
    const Instruction *row = findInstruction(job.word(number));
    return row && row->isStep && !job.isCommentedOut(number);
}

} // namespace

std::optional<QList<double>> Point::numbers() const
{
    QList<double> result;
    for (const QByteArrayView part : splitAt(values, ',')) {
        bool isNumber = false;
        result << part.toDouble(&isNumber);
        if (!isNumber || !std::isfinite(result.last()))
            return std::nullopt;
    }
    return result;
}

std::span<const Token> Job::tokensOf(const Line &line) const
{
    return std::span {tokens}.subspan(std::size_t(line.firstToken), std::size_t(line.tokenCount));
}

QByteArrayView Job::word(int number) const
{
    const Line &line = at(number);
    const auto found = tokensOf(line);
    const auto token = std::ranges::find(found, TokenKind::Word, &Token::kind);
    return token == found.end() ? QByteArrayView {} : token->in(line.text);
}

bool Job::isCommentedOut(int number) const { return hasPrefix(*this, number, "COMM"); }

bool Job::isLocked(int number) const { return hasPrefix(*this, number, "EDTLCK"); }

QList<Mark> Job::labels() const
{
    QList<Mark> result;
    for (int number = 0; number < lineCount(); ++number) {
        if (at(number).kind == LineKind::Label && !isCommentedOut(number))
            result << Mark {tokensOf(at(number)).back().in(at(number).text).sliced(1).toByteArray(), number};
    }
    return result;
}

QList<Mark> Job::calls() const
{
    QList<Mark> result;
    for (int number = 0; number < lineCount(); ++number) {
        const Line &line = at(number);
        for (const Token &token : tokensOf(line)) {
            if (token.kind == TokenKind::Job && !isCommentedOut(number))
                result << Mark {token.in(line.text).sliced(4).toByteArray(), number};
        }
    }
    return result;
}

int Job::stepAt(int number) const
{
    int steps = 0;
    for (int each = 0; each <= number && each < lineCount(); ++each)
        steps += isStep(*this, each) ? 1 : 0;
    return steps;
}

const Point *Job::point(QByteArrayView entry) const
{
    const auto wanted = entryName(entry);
    const int index = wanted ? pointIndexes.value(pointId(*wanted), -1) : -1;
    return index < 0 ? nullptr : &points[std::size_t(index)];
}

quint64 pointId(const PointName &name) { return quint64(kindIndex(name.kind)) << 32 | quint64(name.number); }

PointCounts Job::counted() const
{
    PointCounts counts {};
    for (const Point &each : points)
        ++counts[std::size_t(kindIndex(each.kind))];
    return counts;
}

QByteArray print(const Job &job)
{
    QByteArray content;
    content.reserve(job.text.size());
    for (const Line &line : job.lines)
        content.append(line.text).append(line.ending);
    return content;
}

bool isJobName(QByteArrayView name)
{
    constexpr QByteArrayView forbidden = "\"'*,./:;<>?[\\]|=";
    if (name.isEmpty() || name.size() > 32)
        return false;
    for (qsizetype at = 0; at < name.size(); ++at) {
        if (quint8(name[at]) >= 0x81 && at + 1 < name.size() && quint8(name[at + 1]) >= 0x40)
            ++at; // a double-byte character
        else if (quint8(name[at]) <= ' ' || forbidden.contains(name[at]))
            return false;
    }
    return true;
}

} // namespace inform
