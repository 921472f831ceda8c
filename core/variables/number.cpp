// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "variables/number.h"

#include "values/plaintext.h"
#include "variables/sentences.h"
#include <QRegularExpression>
#include <charconv>
#include <cmath>

using values::ErrorKind;
using values::failure;
using values::Result;

namespace variables {

namespace {

tl::unexpected<values::Error> noNumber(QStringView typed)
{
    return values::badInput(Sentences::tr("“%1” is not a number.").arg(typed.trimmed()));
}

tl::unexpected<values::Error> outOfRange(QStringView typed, qint64 least, qint64 most)
{
    return values::badInput(
        Sentences::tr("%1 is out of range: it must be from %2 to %3.").arg(typed.trimmed()).arg(least).arg(most));
}

/// Typed text with "." as decimal point and no sign "+"; empty if it is no decimal number. Two points or commas are no
/// number: which of them would group is anyone's guess.
QString decimal(QStringView typed)
{
    static const QRegularExpression form {QStringLiteral("^[+-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+-]?[0-9]+)?$")};
    QString plain = values::plainText(typed);
    plain.replace(u',', u'.');
    if (!form.match(plain).hasMatch())
        return {};
    return plain.startsWith(u'+') ? plain.sliced(1) : plain;
}

QString withPoint(QString text, const QLocale &locale)
{
    return text.replace(QStringLiteral("."), locale.decimalPoint());
}

} // namespace

Result<qint64> wholeNumber(QStringView typed, qint64 least, qint64 most)
{
    static const QRegularExpression form {
        QStringLiteral("^([+-]?)(?:0x([0-9a-f]+)|0b([01]+)|([0-9]+))$"), QRegularExpression::CaseInsensitiveOption};
    const auto match = form.match(values::plainText(typed));
    if (!match.hasMatch()) {
        if (!decimal(typed).isEmpty())
            return values::badInput(
                Sentences::tr("“%1” is not a whole number: write it without decimals and separators.")
                    .arg(typed.trimmed()));
        return noNumber(typed);
    }
    const int group = match.capturedLength(2) ? 2 : match.capturedLength(3) ? 3 : 4;
    constexpr int bases[] {16, 2, 10};
    bool fits = false;
    const qint64 magnitude = match.captured(group).toLongLong(&fits, bases[group - 2]);
    const qint64 number = match.captured(1) == u"-" ? -magnitude : magnitude;
    if (!fits || number < least || number > most)
        return outOfRange(typed, least, most);
    return number;
}

Result<quint16> bits16(QStringView typed, Base base)
{
    constexpr qint64 most = std::numeric_limits<quint16>::max();
    constexpr qint64 leastSigned = std::numeric_limits<qint16>::min();
    QString text = values::plainText(typed);
    const bool hasPrefix = text.startsWith(u"0x", Qt::CaseInsensitive) || text.startsWith(u"0b", Qt::CaseInsensitive);
    if (base == Base::Hex && !text.startsWith(u"0x", Qt::CaseInsensitive))
        text.prepend(u"0x");
    if (base == Base::Binary && !hasPrefix)
        text.prepend(u"0b");
    text.remove(u' ');
    const qint64 least = base == Base::Signed ? leastSigned : 0;
    const auto number = wholeNumber(text, least, base == Base::Signed && !hasPrefix ? -leastSigned - 1 : most);
    return number.map([](qint64 value) { return quint16(value); });
}

QString toText(quint16 bits, Base base)
{
    switch (base) {
    case Base::Decimal: return QString::number(bits);
    case Base::Signed: return QString::number(qint16(bits));
    case Base::Hex: return QStringLiteral("0x%1").arg(QString::number(bits, 16).toUpper(), 4, u'0');
    case Base::Binary: return QStringLiteral("0b%1").arg(bits, 16, 2, QChar(u'0'));
    }
    return {};
}

Result<float> real(QStringView typed)
{
    const QByteArray text = decimal(typed).toLatin1();
    if (text.isEmpty())
        return noNumber(typed);
    float value = 0;
    if (std::from_chars(text.begin(), text.end(), value).ec == std::errc {})
        return value;
    return values::badInput(
        Sentences::tr("%1 does not go into a real: that is 0, or from ±1.18e-38 to ±3.40e+38.").arg(typed.trimmed()));
}

QString toText(float value, const QLocale &locale)
{
    if (std::isnan(value))
        return Sentences::tr("not a number");
    std::array<char, 32> room {};
    const auto end = std::to_chars(room.data(), room.data() + room.size(), value).ptr;
    return withPoint(QString::fromLatin1(room.data(), end - room.data()), locale);
}

Result<qint32> fixedPoint(QStringView typed, int decimals)
{
    const QString text = decimal(typed);
    if (text.isEmpty() || text.contains(u'e', Qt::CaseInsensitive))
        return noNumber(typed);
    const qsizetype point = text.indexOf(u'.');
    QString whole = point < 0 ? text : text.first(point);
    QString fraction = point < 0 ? QString() : text.sliced(point + 1);
    while (fraction.endsWith(u'0'))
        fraction.chop(1);
    if (fraction.size() > decimals) {
        if (decimals == 0)
            return values::badInput(Sentences::tr("“%1” is not a whole number.").arg(typed.trimmed()));
        return values::badInput(
            Sentences::tr("“%1” is too fine: %n decimal(s) are kept.", nullptr, decimals).arg(typed.trimmed()));
    }
    whole += fraction.leftJustified(decimals, u'0');
    bool fits = false;
    const qint32 value = whole.toInt(&fits);
    if (fits)
        return value;
    const auto limit = [decimals](qint32 bound) { return toText(bound, decimals, QLocale::c()); };
    return values::badInput(Sentences::tr("%1 is out of range: it must be from %2 to %3.")
                                .arg(typed.trimmed(), limit(std::numeric_limits<qint32>::min()),
                                    limit(std::numeric_limits<qint32>::max())));
}

QString toText(qint32 value, int decimals, const QLocale &locale)
{
    QString digits = QString::number(std::abs(qint64(value)));
    if (decimals > 0) {
        digits = digits.rightJustified(decimals + 1, u'0');
        digits.insert(digits.size() - decimals, u'.');
    }
    return withPoint(value < 0 ? u'-' + digits : digits, locale);
}

} // namespace variables
