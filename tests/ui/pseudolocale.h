// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QHash>
#include <QRegularExpression>
#include <QTranslator>

/// A language that is English with every letter accented and two fifths longer: "‹Öþêñ ţĥîš þåĝê·····›". A Latin letter
/// without an accent on the screen was not translated. Place holders, mnemonics and the tags of rich text are kept.
class PseudoLocale : public QTranslator
{
public:
    [[nodiscard]] bool isEmpty() const override { return false; }
    [[nodiscard]] QString translate(const char *context, const char *sourceText, const char *, int) const override
    {
        const bool isKeyName = qstrcmp(context, "QShortcut") == 0; // "Ctrl" is the same key in every language
        return isKeyName ? QString() : inPseudo(QString::fromUtf8(sourceText));
    }

    static QString inPseudo(const QString &english)
    {
        static const QRegularExpression kept(QStringLiteral("%L?[0-9]+|%n|</?[a-z]+>|&[a-z]+;"));
        QString result;
        qsizetype done = 0;
        for (const QRegularExpressionMatch &match : kept.globalMatch(english)) {
            result += accented(english.sliced(done, match.capturedStart() - done)) + match.captured();
            done = match.capturedEnd();
        }
        result += accented(english.sliced(done));
        return opening + result + padding(english) + closing;
    }
    [[nodiscard]] static bool isMarked(const QString &text) { return text.contains(opening); }

    static constexpr QChar opening = u'‹';
    static constexpr QChar closing = u'›';

private:
    /// With the two marks at least two fifths of the text, the dots being narrow; in words, so that lines can break.
    static QString padding(const QString &english)
    {
        QString dots;
        for (qsizetype left = std::max(english.size() * 7 / 10 - 2, qsizetype {1}); left > 0; left -= 8)
            dots += (dots.isEmpty() ? QString() : QStringLiteral(" ")) + QString(std::min(left, qsizetype {8}), u'·');
        return dots;
    }

    static QString accented(QString text)
    {
        static const QString plain = QStringLiteral("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ");
        static const QString accents = QStringLiteral("åƀçðéƒĝĥîĵķļḿñöþǫŕšţûṽŵẋýžÅƁÇÐÉƑĜĤÎĴĶĻḾÑÖÞǪŔŠŢÛṼŴẊÝŽ");
        for (QChar &letter : text) {
            if (const auto place = plain.indexOf(letter); place >= 0)
                letter = accents[place];
        }
        return text;
    }
};
