// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "values/form.h"

#include <QLatin1StringView>
#include <array>

namespace values {

namespace {

constexpr std::array plainForm {
    FormBit {QT_TRANSLATE_NOOP("values", "front"), QT_TRANSLATE_NOOP("values", "back")},
    FormBit {QT_TRANSLATE_NOOP("values", "upper arm"), QT_TRANSLATE_NOOP("values", "lower arm")},
    FormBit {QT_TRANSLATE_NOOP("values", "flip"), QT_TRANSLATE_NOOP("values", "no flip")},
    FormBit {QT_TRANSLATE_NOOP("values", "R < 180"), QT_TRANSLATE_NOOP("values", "R >= 180")},
    FormBit {QT_TRANSLATE_NOOP("values", "T < 180"), QT_TRANSLATE_NOOP("values", "T >= 180")},
    FormBit {QT_TRANSLATE_NOOP("values", "S < 180"), QT_TRANSLATE_NOOP("values", "S >= 180")},
    FormBit {QT_TRANSLATE_NOOP("values", "redundant front"), QT_TRANSLATE_NOOP("values", "redundant back")},
    FormBit {QT_TRANSLATE_NOOP("values", "previous step's form"), QT_TRANSLATE_NOOP("values", "this form")},
};

constexpr std::array extendedForm {
    FormBit {QT_TRANSLATE_NOOP("values", "L < 180"), QT_TRANSLATE_NOOP("values", "L >= 180")},
    FormBit {QT_TRANSLATE_NOOP("values", "U < 180"), QT_TRANSLATE_NOOP("values", "U >= 180")},
    FormBit {QT_TRANSLATE_NOOP("values", "B < 180"), QT_TRANSLATE_NOOP("values", "B >= 180")},
    FormBit {QT_TRANSLATE_NOOP("values", "E < 180"), QT_TRANSLATE_NOOP("values", "E >= 180")},
    FormBit {QT_TRANSLATE_NOOP("values", "W < 180"), QT_TRANSLATE_NOOP("values", "W >= 180")},
};

/// The value of one word: its bit if it is an "on" word, 0 if it is an "off" word.
Result<quint32> bitOf(const QString &word, std::span<const FormBit> table)
{
    for (std::size_t bit = 0; bit < table.size(); ++bit) {
        if (word == QLatin1StringView(table[bit].on))
            return 1U << bit;
        if (word == QLatin1StringView(table[bit].off))
            return 0U;
    }
    return badInput(QStringLiteral("\"%1\" is not a form").arg(word));
}

} // namespace

std::span<const FormBit> formBits() { return plainForm; }
std::span<const FormBit> extendedFormBits() { return extendedForm; }

QStringList formWords(quint32 form, std::span<const FormBit> table)
{
    QStringList words;
    for (std::size_t bit = 0; bit < table.size(); ++bit)
        words += QString::fromLatin1(form >> bit & 1 ? table[bit].on : table[bit].off);
    return words;
}

Result<quint32> formFromWords(const QStringList &words, std::span<const FormBit> table)
{
    quint32 form = 0;
    for (const QString &word : words) {
        auto bit = bitOf(word, table);
        if (!bit)
            return bit;
        form |= *bit;
    }
    return form;
}

} // namespace values
