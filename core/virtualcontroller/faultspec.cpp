// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
// The text form of the fault table: Faults::parse().
#include "virtualcontroller/faults.h"

#include <QMap>
#include <QStringList>

namespace virtualcontroller {

namespace {

using values::Result;

tl::unexpected<values::Error> wrong(const QString &word, QLatin1StringView what)
{
    return values::badInput(QStringLiteral("\"%1\" is not %2.").arg(word, what));
}

std::optional<FaultKind> kindOf(const QString &word)
{
    static const QMap<QString, FaultKind> names {{QStringLiteral("lose"), FaultKind::Lose},
        {QStringLiteral("delay"), FaultKind::Delay}, {QStringLiteral("duplicate"), FaultKind::Duplicate},
        {QStringLiteral("reorder"), FaultKind::Reorder}, {QStringLiteral("corrupt"), FaultKind::Corrupt},
        {QStringLiteral("corrupt-anywhere"), FaultKind::CorruptAnywhere},
        {QStringLiteral("truncate"), FaultKind::Truncate}, {QStringLiteral("wrong-id"), FaultKind::WrongId},
        {QStringLiteral("refuse"), FaultKind::Refuse}, {QStringLiteral("silence"), FaultKind::Silence},
        {QStringLiteral("restart"), FaultKind::Restart}};
    const auto found = names.find(word);
    return found == names.end() ? std::nullopt : std::optional {*found};
}

bool takeCommand(FaultRule &rule, const QString &word)
{
    bool ok = true;
    if (word == QLatin1StringView("any"))
        rule.command.reset();
    else
        rule.command = word == QLatin1StringView("files") ? quint16 {0} : word.toUShort(&ok, 0);
    return ok;
}

bool takeDirection(FaultRule &rule, const QString &word)
{
    rule.direction = word == QLatin1StringView("request") ? Direction::Request : Direction::Reply;
    return rule.direction == Direction::Request || word == QLatin1StringView("reply");
}

/// "p=0.1" and the like.
bool takeDetail(FaultRule &rule, const QString &word)
{
    const QString key = word.section(QLatin1Char('='), 0, 0);
    const QString value = word.section(QLatin1Char('='), 1);
    bool ok = false;
    if (key == QLatin1StringView("p")) {
        rule.probability = value.toDouble(&ok);
        return ok && rule.probability >= 0 && rule.probability <= 1;
    }
    if (key == QLatin1StringView("after"))
        rule.after = int(value.toUShort(&ok));
    else if (key == QLatin1StringView("times"))
        rule.times = int(value.toUShort(&ok));
    else if (key == QLatin1StringView("ms"))
        rule.time = Time {value.toUInt(&ok)};
    else if (key == QLatin1StringView("code"))
        rule.code = value.toUShort(&ok, 0);
    return ok;
}

Result<FaultRule> parseRule(const QStringList &words)
{
    FaultRule rule;
    if (words.size() < 3)
        return wrong(words.join(QLatin1Char(' ')), QLatin1StringView("a rule of command, direction and fault"));
    if (!takeCommand(rule, words[0]))
        return wrong(words[0], QLatin1StringView("a command number, \"files\" or \"any\""));
    if (!takeDirection(rule, words[1]))
        return wrong(words[1], QLatin1StringView("a direction, \"request\" or \"reply\""));
    const auto kind = kindOf(words[2]);
    if (!kind)
        return wrong(words[2], QLatin1StringView("a fault"));
    rule.kind = *kind;
    if (rule.kind == FaultKind::Refuse && rule.direction == Direction::Reply)
        return wrong(words[1], QLatin1StringView("the direction in which to refuse: only requests are refused"));
    for (const QString &word : words.sliced(3)) {
        if (!takeDetail(rule, word))
            return wrong(word, QLatin1StringView("one of p=0..1, after=, times=, ms=, code= with a number"));
    }
    return rule;
}

} // namespace

Result<Faults> Faults::parse(QStringView text)
{
    std::vector<FaultRule> rules;
    quint32 seed = 1;
    for (const QString &part : text.toString().split(QLatin1Char(';'), Qt::SkipEmptyParts)) {
        const QStringList words = part.simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts);
        if (words.isEmpty())
            continue;
        if (words.first().startsWith(QLatin1StringView("seed="))) {
            bool ok = false;
            seed = words.first().sliced(5).toUInt(&ok);
            if (!ok || words.size() > 1)
                return wrong(part.trimmed(), QLatin1StringView("a seed"));
            continue;
        }
        const auto rule = parseRule(words);
        if (!rule)
            return tl::unexpected(rule.error());
        rules.push_back(*rule);
    }
    return Faults {std::move(rules), seed};
}

} // namespace virtualcontroller
