// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/noise.h"

#include "inform/lines.h"
#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <array>
#include <vector>

namespace files {

namespace {

constexpr std::array rules {
    NoiseRule {
        "job-dates", QT_TRANSLATE_NOOP("Noise", "Date of the last change of a job (///DATE)"), R"(^///DATE [^\r\n]*)"},
    NoiseRule {"times", QT_TRANSLATE_NOOP("Noise", "Dates and times of day, such as 2026/01/31 08:30"),
        R"(\d{4}/\d\d/\d\d( \d\d:\d\d(:\d\d)?)?)"},
    NoiseRule {"counters", QT_TRANSLATE_NOOP("Noise", "Operating time counters, such as 18:19'02"), R"(\d+:\d\d'\d\d)"},
    NoiseRule {"blanks", QT_TRANSLATE_NOOP("Noise", "Blanks at the end of a line"), R"([ \t]+(?=[\r\n]*\z))"},
    NoiseRule {"line-ends", QT_TRANSLATE_NOOP("Noise", "Line ends: CR LF or LF, and whether the last line has one"),
        R"([\r\n]+\z)"},
};

/// In the order of `rules`, compiled once.
const std::vector<QRegularExpression> &expressions()
{
    static const std::vector<QRegularExpression> compiled = [] {
        std::vector<QRegularExpression> result;
        result.reserve(std::size(rules));
        for (const NoiseRule &rule : rules)
            result.emplace_back(QString::fromLatin1(rule.pattern));
        return result;
    }();
    return compiled;
}

/// What a noisy part becomes: something no file has.
QString mark(const NoiseRule &rule)
{
    const bool isEnd = std::string_view {rule.key} == "blanks" || std::string_view {rule.key} == "line-ends";
    return isEnd ? QString {} : QStringLiteral("\x01");
}

} // namespace

std::span<const NoiseRule> noiseRules() { return rules; }

QString title(const NoiseRule &rule) { return QCoreApplication::translate("Noise", rule.title); }

NoiseFilter::NoiseFilter()
{
    for (const NoiseRule &rule : rules)
        m_keys.insert(QString::fromLatin1(rule.key));
}

QByteArray NoiseFilter::clean(const QByteArray &line) const
{
    if (m_keys.isEmpty())
        return line;
    QString text = QString::fromLatin1(line); // a character a byte, there and back
    for (std::size_t index = 0; index < rules.size(); ++index) {
        if (isOn(rules[index]))
            text.replace(expressions()[index], mark(rules[index]));
    }
    return text.toLatin1();
}

QByteArrayList NoiseFilter::cleanLines(const QByteArray &content) const
{
    QByteArrayList result;
    for (const inform::TextLine &line : inform::splitLines(content))
        result << clean(line.whole());
    return result;
}

} // namespace files
