// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/bagtext.h"

#include <QCryptographicHash>
#include <algorithm>
#include <array>

using values::Error;
using values::ErrorKind;

namespace files {

namespace {

constexpr std::array<std::pair<ErrorKind, const char *>, 9> errorWords {{
    {ErrorKind::Refused, "refused"},
    {ErrorKind::NoAnswer, "no-answer"},
    {ErrorKind::UnknownOutcome, "unknown-outcome"},
    {ErrorKind::Malformed, "malformed"},
    {ErrorKind::NotSent, "not-sent"},
    {ErrorKind::Network, "network"},
    {ErrorKind::BadInput, "unusable-name"},
    {ErrorKind::LocalFile, "local-file"},
    {ErrorKind::Cancelled, "cancelled"},
}};

QByteArray hex(int number, int digits)
{
    return "0x" + QByteArray::number(number, 16).rightJustified(digits, '0').toUpper();
}

QByteArray words(const std::optional<Error> &error)
{
    if (!error)
        return "ok";
    const auto word = std::ranges::find(errorWords, error->kind, [](const auto &row) { return row.first; });
    const QByteArray codes = ' ' + hex(error->status, 2) + ' ' + hex(error->addedStatus, 4);
    return word->second + (error->kind == ErrorKind::Refused ? codes : QByteArray {});
}

std::optional<Error> errorFrom(const QByteArrayList &words)
{
    const auto row =
        std::ranges::find_if(errorWords, [&](const auto &candidate) { return words.value(0) == candidate.second; });
    if (row == errorWords.end())
        return std::nullopt;
    const auto number = [&](int index) { return words.value(index).toUShort(nullptr, 16); };
    return Error {row->first, quint8(number(1)), number(2), {}};
}

/// A label's value on one line.
QByteArray oneLine(const QString &text) { return text.simplified().toUtf8(); }

FileResult resultFrom(const QByteArray &value)
{
    QByteArrayList words = value.split(' ');
    const QByteArray name = QByteArray::fromPercentEncoding(words.takeFirst());
    return {name, errorFrom(words)};
}

void takeLabel(BagInfo &info, const QByteArray &label, const QByteArray &value)
{
    const QString text = QString::fromUtf8(value);
    if (label == "Pendesk-Controller")
        info.controller = text;
    else if (label == "Pendesk-Host")
        info.host = text;
    else if (label == "Pendesk-Model")
        info.model = text;
    else if (label == "Pendesk-Software")
        info.software = text;
    else if (label == "Pendesk-Parameter-Version")
        info.parameterVersion = text;
    else if (label == "Pendesk-Taken")
        info.taken = QDateTime::fromString(text, Qt::ISODate);
    else if (label == "Pendesk-File")
        info.results << resultFrom(value);
}

bool isInside(const QByteArray &path)
{
    const auto parts = path.split('/');
    return !path.contains('\\') && !path.contains(':') && std::ranges::none_of(parts, [](const QByteArray &part) {
        return part.isEmpty() || part == "." || part == "..";
    });
}

/// "<64 digits>  <path>"
bool takeManifestLine(Manifest &manifest, const QByteArray &line)
{
    constexpr qsizetype digits = 64;
    const QByteArray path = line.mid(digits + 2).replace("%0A", "\n").replace("%0D", "\r").replace("%25", "%");
    return line.mid(digits, 2) == "  " && isInside(path) && manifest.insert({path, line.first(digits)}).second;
}

} // namespace

int BagInfo::failures() const
{
    return int(std::ranges::count_if(results, [](const FileResult &result) { return result.error.has_value(); }));
}

QByteArray toText(const BagInfo &info, qint64 bytes, int files)
{
    QByteArray text;
    const auto add = [&text](const char *label, const QByteArray &value) {
        if (!value.isEmpty())
            text += QByteArray(label) + ": " + value + '\n';
    };
    add("Bag-Software-Agent", "Pendesk " PENDESK_VERSION);
    add("Bagging-Date", info.taken.toUTC().toString(QStringLiteral("yyyy-MM-dd")).toLatin1());
    add("Payload-Oxum", QByteArray::number(bytes) + '.' + QByteArray::number(files));
    add("Pendesk-Taken", info.taken.toUTC().toString(Qt::ISODate).toLatin1());
    add("Pendesk-Controller", oneLine(info.controller));
    add("Pendesk-Host", oneLine(info.host));
    add("Pendesk-Model", oneLine(info.model));
    add("Pendesk-Software", oneLine(info.software));
    add("Pendesk-Parameter-Version", oneLine(info.parameterVersion));
    for (const FileResult &result : info.results)
        add("Pendesk-File", result.name.toPercentEncoding() + ' ' + words(result.error));
    return text;
}

BagInfo bagInfoFrom(const QByteArray &text)
{
    BagInfo info;
    for (const QByteArray &line : text.split('\n')) {
        const qsizetype colon = line.indexOf(": ");
        if (colon > 0)
            takeLabel(info, line.first(colon), line.sliced(colon + 2).trimmed());
    }
    return info;
}

QByteArray bagDeclaration() { return "BagIt-Version: 1.0\nTag-File-Character-Encoding: UTF-8\n"; }

QByteArray toText(const Manifest &manifest)
{
    QByteArray text;
    for (const auto &[path, hash] : manifest) {
        QByteArray written = path;
        written.replace('%', "%25").replace('\n', "%0A").replace('\r', "%0D");
        text += hash + "  " + written + '\n';
    }
    return text;
}

std::optional<Manifest> manifestFrom(const QByteArray &text)
{
    Manifest manifest;
    for (const QByteArray &line : text.split('\n')) {
        if (!line.isEmpty() && !(line.size() > 66 && takeManifestLine(manifest, line)))
            return std::nullopt;
    }
    if (toText(manifest) != text)
        return std::nullopt;
    return manifest;
}

QByteArray sha256(const QByteArray &content)
{
    return QCryptographicHash::hash(content, QCryptographicHash::Sha256).toHex();
}

} // namespace files
