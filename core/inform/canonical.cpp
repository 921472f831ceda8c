// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/canonical.h"

#include <algorithm>

namespace inform {

namespace {

bool isDecimal(QByteArrayView text)
{
    return !text.isEmpty() && std::ranges::count(text, '.') <= 1
        && std::ranges::all_of(text, [](char c) { return (c >= '0' && c <= '9') || c == '.'; }) && text != ".";
}

QByteArray canonicalList(QByteArrayView numbers, qsizetype least)
{
    QByteArrayList result;
    for (const QByteArrayView each : splitAt(numbers, ','))
        result << canonicalNumber(each);
    while (result.size() < least)
        result << "0";
    return result.join(',');
}

QByteArray cleaned(QByteArrayView text, const Clean &clean)
{
    return clean ? clean(text.toByteArray()) : text.toByteArray();
}

} // namespace

QByteArray canonicalNumber(QByteArrayView text)
{
    const bool isNegative = text.startsWith('-');
    QByteArrayView digits = isNegative || text.startsWith('+') ? text.sliced(1) : text;
    if (!isDecimal(digits))
        return text.toByteArray();
    while (digits.contains('.') && (digits.endsWith('0') || digits.endsWith('.'))) {
        const bool isPoint = digits.endsWith('.');
        digits.chop(1);
        if (isPoint)
            break;
    }
    while (digits.size() > 1 && digits[0] == '0' && digits[1] != '.')
        digits = digits.sliced(1);
    if (digits.isEmpty() || digits == "0")
        return "0";
    return (isNegative ? "-" : "") + QByteArray(digits.startsWith('.') ? "0" : "") + digits.toByteArray();
}

QByteArray canonical(const Token &token, QByteArrayView line)
{
    const QByteArrayView text = token.in(line);
    if (token.kind == TokenKind::Number)
        return canonicalNumber(text);
    const auto name = token.kind == TokenKind::Variable ? variableName(text) : std::nullopt;
    if (!name || name->number < 0)
        return text.toByteArray();
    return (name->isSystem         ? "$"
                   : name->isLocal ? "L"
                                   : "")
        + name->type.toByteArray() + QByteArray::number(name->number);
}

QByteArray pointKey(const Point &point)
{
    const QByteArray tool = point.isOfRobot() ? canonicalNumber(point.tool) : QByteArray {};
    const QByteArray form = point.form.isEmpty() ? QByteArray {} : canonicalList(point.form, 24);
    return QByteArrayList {point.type.toByteArray(), tool, canonicalNumber(point.user), form,
        point.isBeyondLimit ? "LIMIT" : "", canonicalList(point.values, 0)}
        .join('|');
}

QByteArray lineKey(const Job &job, int number, const Clean &clean)
{
    const Line &line = job.at(number);
    QByteArray key;
    for (const Token &token : job.tokensOf(line)) {
        const bool isText = token.kind == TokenKind::Comment || token.kind == TokenKind::TrailingComment
            || token.kind == TokenKind::String;
        const Point *point = token.kind == TokenKind::Point ? job.point(token.in(line.text)) : nullptr;
        key += char(token.kind);
        if (point)
            key += point->kind.toByteArray() + pointKey(*point);
        else
            key += isText ? cleaned(token.in(line.text), clean) : canonical(token, line.text);
    }
    return key;
}

} // namespace inform
