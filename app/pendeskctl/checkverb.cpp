// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "disk/durable.h"
#include "files/localname.h"
#include "files/preflight.h"
#include "options.h"
#include "verbs.h"
#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>
#include <algorithm>

namespace pendeskctl {

namespace {

/// The jobs that a word of the call means: one file, or all jobs of a folder.
QStringList jobsAt(const QString &path)
{
    if (!QFileInfo {path}.isDir())
        return {path};
    QStringList paths;
    const QDir folder {path};
    for (const QString &name :
        folder.entryList({QStringLiteral("*.JBI"), QStringLiteral("*.JBR")}, QDir::Files, QDir::Name))
        paths << folder.filePath(name);
    return paths;
}

QJsonObject asJson(const QString &path, const inform::Finding &finding, const protocol::TextCodec &codec)
{
    const auto decode = [&codec](QByteArrayView bytes) { return codec.decode(bytes); };
    QJsonObject json {{QStringLiteral("file"), path},
        {QStringLiteral("severity"), finding.isError() ? QStringLiteral("error") : QStringLiteral("warning")},
        {QStringLiteral("what"), inform::explain(finding, decode)}, {QStringLiteral("why"), inform::reason(finding)}};
    if (finding.fileLine > 0)
        json.insert(QStringLiteral("fileLine"), finding.fileLine);
    if (finding.jobLine >= 0)
        json.insert(QStringLiteral("jobLine"), finding.jobLine);
    return json;
}

/// "WELD.JBI:17: error: Line 3 …", as compilers do, so that editors can jump there.
QString asText(const QString &path, const inform::Finding &finding, const protocol::TextCodec &codec)
{
    const QString place = finding.fileLine > 0 ? QStringLiteral("%1:%2").arg(path).arg(finding.fileLine) : path;
    const QString severity = finding.isError() ? QStringLiteral("error") : QStringLiteral("warning");
    return place + QStringLiteral(": ") + severity + QStringLiteral(": ") + files::explain(finding, codec);
}

/// What is found in one file; an error says why it cannot be read.
values::Result<QList<inform::Finding>> findingsIn(const QString &path, const protocol::TextCodec &codec)
{
    const auto content = disk::readFile(path);
    if (!content)
        return tl::unexpected(content.error());
    if (const auto name = files::fromLocalName(QFileInfo {path}.fileName()))
        return files::preflight(*name, *content);
    const QString base = QFileInfo {path}.completeBaseName();
    const inform::Finding badName {inform::Fault::BadName, 0, -1, codec.encode(base).value_or(base.toUtf8())};
    return QList {badName} << inform::check(inform::parse(*content));
}

} // namespace

int runCheck(const QStringList &arguments)
{
    Call call;
    QCommandLineParser parser;
    const QCommandLineOption encoding {
        QStringLiteral("encoding"), tr("The encoding of texts, such as Shift_JIS."), QStringLiteral("NAME")};
    const VerbHelp help {tr("Looks at jobs as before they are sent, and prints what is wrong or odd; exit code 1 if a "
                            "controller would refuse one."),
        QStringLiteral("FILE…|FOLDER"), {encoding}, false, 1, anyNumber};
    if (const auto end = read(call, parser, help, arguments))
        return *end;
    if (call.words.isEmpty())
        return mistake(tr("Say the files or a folder."));
    const auto known = protocol::findEncoding(parser.value(encoding));
    if (parser.isSet(encoding) && !known)
        return mistake(tr("“%1” is no encoding.").arg(parser.value(encoding)));
    const protocol::TextCodec codec {known.value_or(protocol::Encoding::Latin1)};
    int exitCode = Done;
    QJsonArray json;
    for (const QString &word : call.words) {
        for (const QString &path : jobsAt(word)) {
            const auto findings = findingsIn(path, codec);
            if (!findings) {
                complain(findings.error().detail);
                exitCode = LocalFile;
                continue;
            }
            for (const inform::Finding &finding : *findings) {
                call.isJson ? json.append(asJson(path, finding, codec)) : print(asText(path, finding, codec));
                exitCode = finding.isError() && exitCode == Done ? int(Differences) : exitCode;
            }
        }
    }
    if (call.isJson)
        print(QJsonValue {json});
    return exitCode;
}

} // namespace pendeskctl
