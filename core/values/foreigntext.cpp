// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "values/foreigntext.h"

#include <QCoreApplication>
#include <algorithm>

namespace values {

namespace {

QString hex(char32_t code, int digits) { return QString::number(code, 16).toUpper().rightJustified(digits, u'0'); }

/// Controls, line and paragraph separators, direction marks, what has no width, and what is no character.
bool isHidden(char32_t code)
{
    switch (QChar::category(code)) {
    case QChar::Other_Control:
    case QChar::Other_Format:
    case QChar::Other_Surrogate:
    case QChar::Separator_Line:
    case QChar::Separator_Paragraph: return true;
    default: return false;
    }
}

QString shown(char32_t code)
{
    return code < 0x100 ? u'⟨' + hex(code, 2) + u'⟩' : QStringLiteral("⟨U+") + hex(code, 4) + u'⟩';
}

bool beginsFormula(QStringView text)
{
    const auto first = std::ranges::find_if(text, [](QChar c) { return c != u'\''; });
    return first != text.end() && QStringView(u"=+-@\t\r").contains(*first);
}

} // namespace

QString oneLine(QStringView text, qsizetype most)
{
    QString line;
    const QStringView kept = text.first(std::min(text.size(), most));
    for (qsizetype at = 0; at < kept.size(); ++at) {
        const bool isPair = at + 1 < kept.size() && kept[at].isHighSurrogate() && kept[at + 1].isLowSurrogate();
        const char32_t code = isPair ? QChar::surrogateToUcs4(kept[at], kept[at + 1]) : kept[at].unicode();
        line += isHidden(code) ? shown(code) : kept.sliced(at, isPair ? 2 : 1).toString();
        at += isPair ? 1 : 0;
    }
    if (text.size() > most)
        line += QCoreApplication::translate("values", "… (%n more characters)", "", int(text.size() - most));
    return line;
}

QString htmlLine(QStringView text, qsizetype most) { return oneLine(text, most).toHtmlEscaped(); }

QByteArray plainJson(const QByteArray &json)
{
    QString plain;
    for (const QChar character : QString::fromUtf8(json)) {
        // JSON escapes what is below 0x20 itself; its own line breaks are not inside a text.
        const bool isEscaped = character.unicode() >= 0x7F && !character.isSurrogate() && isHidden(character.unicode());
        plain += isEscaped ? QStringLiteral("\\u") + hex(character.unicode(), 4).toLower() : QString {character};
    }
    return plain.toUtf8();
}

QString csvText(const QString &text) { return beginsFormula(text) ? u'\'' + text : text; }

QString fromCsvText(const QString &cell)
{
    return cell.startsWith(u'\'') && beginsFormula(cell) ? cell.sliced(1) : cell;
}

} // namespace values
