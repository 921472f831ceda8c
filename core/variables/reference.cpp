// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "variables/reference.h"

#include "values/plaintext.h"
#include "variables/sentences.h"

using values::ErrorKind;
using values::failure;
using values::Result;

namespace variables {

namespace {

constexpr std::array<const char *, allKinds.size()> kindLetters {"B", "I", "D", "R", "S", "P", "BP", "EX", "M"};

tl::unexpected<values::Error> notAReference(QStringView text)
{
    return values::badInput(
        Sentences::tr("“%1” is not a variable. Write its letter and its number, such as B007.").arg(text.trimmed()));
}

/// The digits of `text` as a number; nullopt for anything else. Too many digits are a number that nothing has.
std::optional<int> numberFrom(QStringView digits)
{
    constexpr int more = 99'999;
    if (digits.isEmpty() || !std::ranges::all_of(digits, [](QChar c) { return c >= u'0' && c <= u'9'; }))
        return std::nullopt;
    bool fits = false;
    const int number = digits.toInt(&fits, 10);
    return fits ? std::min(number, more) : more;
}

/// Letters and number, whether or not the controller has it.
std::optional<Reference> split(const QString &plain)
{
    const auto isLetter = [](QChar c) { return c.isLetter(); };
    const auto end = std::ranges::find_if_not(plain, isLetter) - plain.begin();
    const auto kind = findKind(QStringView {plain}.first(end));
    const auto number = numberFrom(QStringView {plain}.sliced(end).trimmed());
    return kind && number ? std::optional {Reference {*kind, *number}} : std::nullopt;
}

Result<Reference> existing(const Reference &reference, const protocol::Dialect &dialect)
{
    const int last = countOf(reference.kind, dialect) - 1;
    if (reference.number <= last)
        return reference;
    return values::badInput(
        Sentences::tr("There is no %1: this controller has %2 to %3.")
            .arg(toString(reference), toString({reference.kind, 0}), toString({reference.kind, last})));
}

} // namespace

QString letters(Kind kind) { return QString::fromLatin1(kindLetters[std::size_t(kind)]); }

std::optional<Kind> findKind(QStringView letters)
{
    for (const Kind kind : allKinds) {
        if (letters.compare(QLatin1StringView(kindLetters[std::size_t(kind)]), Qt::CaseInsensitive) == 0)
            return kind;
    }
    return std::nullopt;
}

int countOf(Kind kind, const protocol::Dialect &dialect)
{
    if (kind == Kind::M)
        return protocol::registers.count();
    return isPosition(kind) ? dialect.positionVariables : dialect.variables;
}

int writableCountOf(Kind kind, const protocol::Dialect &dialect)
{
    return kind == Kind::M ? protocol::writableRegisters.count() : countOf(kind, dialect);
}

QString toString(const Reference &reference)
{
    return letters(reference.kind) + QString::number(reference.number).rightJustified(3, u'0');
}

Result<Reference> referenceFromText(QStringView text, const protocol::Dialect &dialect)
{
    const auto reference = split(values::plainText(text));
    if (!reference)
        return notAReference(text);
    return existing(*reference, dialect);
}

Result<Range> rangeFromText(QStringView text, const protocol::Dialect &dialect)
{
    const QString plain = values::plainText(text);
    const qsizetype dots = plain.indexOf(u"..");
    if (dots < 0)
        return referenceFromText(text, dialect).map([](const Reference &one) {
            return Range {one.kind, one.number, one.number};
        });
    const auto first = split(plain.first(dots).trimmed());
    const QString end = plain.sliced(dots + 2).trimmed();
    const auto number = numberFrom(end);
    const auto last = first && number ? std::optional {Reference {first->kind, *number}} : split(end);
    if (!first || !last)
        return notAReference(text);
    if (first->kind != last->kind || first->number > last->number)
        return values::badInput(
            Sentences::tr("“%1” is not a range: it must go from a lower to a higher number of one kind.")
                .arg(text.trimmed()));
    return existing(*last, dialect).map([&](const Reference &) {
        return Range {first->kind, first->number, last->number};
    });
}

} // namespace variables
