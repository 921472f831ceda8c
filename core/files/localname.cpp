// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/localname.h"

#include <QRegularExpression>

namespace files {

namespace {

bool isAsciiLetter(char16_t c) { return (c >= u'A' && c <= u'Z') || (c >= u'a' && c <= u'z'); }

bool isPlain(char16_t c)
{
    return isAsciiLetter(c) || (c >= u'0' && c <= u'9') || QStringView(u"-_+=@#$&!()[]{},").contains(QChar(c));
}

bool isDevice(const QString &name)
{
    static const QRegularExpression devices {
        QStringLiteral("^(CON|PRN|AUX|NUL|COM[0-9]|LPT[0-9])(\\..*)?$"), QRegularExpression::CaseInsensitiveOption};
    return devices.match(name).hasMatch();
}

QString escaped(quint8 byte) { return QStringLiteral("%") + QString::number(0x100 + byte, 16).sliced(1).toUpper(); }

QString escaped(QByteArrayView bytes)
{
    QString result;
    for (const char byte : bytes)
        result += escaped(quint8(byte));
    return result;
}

/// A dot may stand between two other characters only.
bool isInnerDot(QByteArrayView name, qsizetype at)
{
    return name[at] == '.' && at > 0 && at + 1 < name.size() && name[at - 1] != '.';
}

/// The same name with its letters escaped too, for a file system that does not tell cases apart.
QString withoutLetters(QByteArrayView name)
{
    QString result;
    for (qsizetype at = 0; at < name.size(); ++at) {
        const bool isKept = isInnerDot(name, at) || (isPlain(quint8(name[at])) && !isAsciiLetter(quint8(name[at])));
        result += isKept ? QString(QLatin1Char(name[at])) : escaped(quint8(name[at]));
    }
    return result;
}

QString withoutDevice(const QString &name)
{
    return isDevice(name) ? escaped(quint8(name[0].unicode())) + name.sliced(1) : name;
}

} // namespace

QString toLocalName(QByteArrayView name)
{
    QString result;
    for (qsizetype at = 0; at < name.size(); ++at) {
        const bool isKept = isInnerDot(name, at) || isPlain(quint8(name[at]));
        result += isKept ? QString(QLatin1Char(name[at])) : escaped(quint8(name[at]));
    }
    return withoutDevice(result);
}

std::optional<values::FileName> fromLocalName(const QString &local)
{
    const auto name = values::FileName::create(QByteArray::fromPercentEncoding(local.toLatin1()));
    if (!name || (toLocalName(name->bytes()) != local && withoutLetters(name->bytes()) != local))
        return std::nullopt;
    return *name;
}

QString toFolderName(const QString &name)
{
    QString result;
    const QString composed = name.normalized(QString::NormalizationForm_C).trimmed();
    for (qsizetype at = 0; at < composed.size(); ++at) {
        const QChar c = composed[at];
        const bool isInside = at > 0 && at + 1 < composed.size();
        const bool isKept = isPlain(c.unicode()) || (c.unicode() > 0x7F && c.isPrint() && !c.isSpace())
            || c.isSurrogate() || (isInside && (c == u' ' || c == u'.'));
        result += isKept ? QString(c) : escaped(QString(c).toUtf8());
    }
    return result.isEmpty() ? QStringLiteral("%00") : withoutDevice(result);
}

QString LocalNames::take(const values::FileName &name)
{
    QString local = toLocalName(name.bytes());
    if (m_taken.contains(local.toUpper()))
        local = withoutLetters(name.bytes());
    m_taken.insert(local.toUpper());
    return local;
}

} // namespace files
