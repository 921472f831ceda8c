// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "names/signal.h"

#include "names/sentences.h"
#include "values/plaintext.h"
#include <QRegularExpression>

using protocol::Dialect;
using protocol::IoArea;
using values::ErrorKind;
using values::failure;
using values::Result;

namespace names {

namespace {

struct InformArea {
    const char *name; ///< The first of an area is the one that is printed.
    IoArea area;
};
constexpr std::array informAreas {
    InformArea {"IN", IoArea::UserInput},
    InformArea {"OT", IoArea::UserOutput},
    InformArea {"OUT", IoArea::UserOutput},
};

Result<Signal> fromLogicalNumber(const QString &digits, const Dialect &dialect)
{
    const int number = digits.toInt(); // too many digits are 0, which nothing has
    const Signal signal {number / 10, number % 10};
    if (!dialect.ioArea(quint32(signal.group)))
        return values::badInput(Sentences::tr("%1 has no signal #%2.").arg(QLatin1StringView(dialect.name), digits));
    if (signal.bit >= signalsPerGroup)
        return values::badInput(Sentences::tr("There is no #%1: the last digit of a signal is 0 to 7.").arg(digits));
    return signal;
}

Result<Signal> fromInformName(const InformArea &area, const QString &digits, const Dialect &dialect)
{
    if (const auto signal = signalOf(area.area, digits.toInt(), dialect))
        return *signal;
    const QString name = QString::fromLatin1(area.name);
    return values::badInput(Sentences::tr("There is no %1#(%2): this controller has %1#(1) to %1#(%3).")
                                .arg(name, digits)
                                .arg(dialect.ioRange(area.area).count() * signalsPerGroup));
}

} // namespace

QString toString(const Signal &signal) { return u'#' + QString::number(signal.number()).rightJustified(5, u'0'); }

QString informName(const Signal &signal, const Dialect &dialect)
{
    for (const auto &[name, area] : informAreas) {
        const auto groups = dialect.ioRange(area);
        if (groups.contains(quint32(signal.group)))
            return QStringLiteral("%1#(%2)")
                .arg(QLatin1StringView(name))
                .arg((signal.group - groups.first) * signalsPerGroup + signal.bit + 1);
    }
    return {};
}

std::optional<Signal> signalOf(IoArea area, int number, const Dialect &dialect)
{
    const auto groups = dialect.ioRange(area);
    if (number < 1 || number > groups.count() * signalsPerGroup)
        return std::nullopt;
    return Signal {groups.first + (number - 1) / signalsPerGroup, (number - 1) % signalsPerGroup};
}

Result<Signal> signalFromText(QStringView text, const Dialect &dialect)
{
    static const QRegularExpression logical {QStringLiteral("^#?\\s*0*([0-9]+)$")};
    static const QRegularExpression inform {QStringLiteral("^(IN|OUT|OT)\\s*#?\\s*(\\(\\s*)?0*([0-9]+)\\s*(?(2)\\)|)$"),
        QRegularExpression::CaseInsensitiveOption};
    const QString plain = values::plainText(text);
    if (const auto match = logical.match(plain); match.hasMatch())
        return fromLogicalNumber(match.captured(1), dialect);
    const auto match = inform.match(plain);
    for (const InformArea &area : informAreas) {
        if (match.captured(1).compare(QLatin1StringView(area.name), Qt::CaseInsensitive) == 0)
            return fromInformName(area, match.captured(3), dialect);
    }
    return values::badInput(Sentences::tr("“%1” is not a signal. Write #00010, IN#(1) or OT#(1).").arg(text.trimmed()));
}

} // namespace names
