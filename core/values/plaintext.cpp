// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "values/plaintext.h"

namespace values {

namespace {

QChar plain(QChar character)
{
    constexpr char16_t firstFullWidth = 0xFF01; // ！ to ～ stand in the order of ASCII
    constexpr char16_t lastFullWidth = 0xFF5E;
    const char16_t code = character.unicode();
    if (code >= firstFullWidth && code <= lastFullWidth)
        return QChar(char16_t(code - firstFullWidth + u'!'));
    if (character.isDigit())
        return QChar(char16_t(u'0' + character.digitValue()));
    if (code == 0x2212 || code == 0x2010 || code == 0x2011 || code == 0x2013) // minus, hyphens, en dash
        return u'-';
    return code == 0x066B ? QChar(u'.') : character; // the Arabic decimal point
}

} // namespace

QString plainText(QStringView typed)
{
    QString result = typed.trimmed().toString();
    for (QChar &character : result)
        character = plain(character);
    return result;
}

} // namespace values
