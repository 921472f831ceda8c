// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "values/filename.h"

#include <algorithm>

namespace values {

namespace {

/// Where the extension's dot stands, or the end.
qsizetype dotIn(QByteArrayView bytes)
{
    const qsizetype dot = bytes.lastIndexOf('.');
    return dot < 0 ? bytes.size() : dot;
}

bool isForbidden(char byte) { return quint8(byte) < 0x20 || byte == 0x7F || byte == '/' || byte == '*' || byte == '?'; }

/// A backslash, but not the second byte of a Shift-JIS, GBK or Big5 character.
bool hasBackslash(QByteArrayView bytes)
{
    for (qsizetype at = bytes.indexOf('\\'); at >= 0; at = bytes.indexOf('\\', at + 1)) {
        if (at == 0 || quint8(bytes[at - 1]) < 0x80)
            return true;
    }
    return false;
}

} // namespace

Result<FileName> FileName::create(QByteArrayView bytes)
{
    const auto bad = [](const char *why) { return badInput(QString::fromLatin1(why)); };
    const qsizetype dot = dotIn(bytes);
    if (bytes.isEmpty() || dot == 0)
        return bad("a file name must not be empty or begin with a dot");
    if (dot > maxBaseSize)
        return bad("a file name has at most 32 bytes before the extension");
    if (bytes.size() - dot - 1 > maxExtensionSize)
        return bad("the extension of a file name has at most 8 bytes");
    if (bytes.startsWith('.') || std::ranges::any_of(bytes, isForbidden) || hasBackslash(bytes))
        return bad("a file name has no path, wild card or control character");
    return FileName {bytes.toByteArray()};
}

QByteArrayView FileName::base() const { return QByteArrayView {m_bytes}.first(dotIn(m_bytes)); }

QByteArrayView FileName::extension() const
{
    return QByteArrayView {m_bytes}.sliced(std::min(dotIn(m_bytes) + 1, m_bytes.size()));
}

} // namespace values
