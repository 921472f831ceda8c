// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "bags.h"
#include "cellfiles/filetypes.h"
#include "verbs.h"
#include <QJsonObject>

namespace pendeskctl {

namespace {

int widthOf(const cellfiles::Table &table, qsizetype column)
{
    constexpr qsizetype widest = 40;
    qsizetype width = cellfiles::title(table.columns[column].title).size();
    for (const cellfiles::Row &row : table.rows)
        width = std::max(width, row.cells.value(column).size());
    return int(std::min(width, widest));
}

void printTable(const cellfiles::Table &table)
{
    print(QStringLiteral("  [%1]").arg(cellfiles::title(table.title)));
    QList<int> widths;
    for (qsizetype column = 0; column < table.columns.size(); ++column)
        widths << widthOf(table, column);
    const auto line = [&](const QStringList &cells) {
        QString text = QStringLiteral(" ");
        for (qsizetype column = 0; column < cells.size(); ++column)
            text += u' ' + cells[column].leftJustified(widths.value(column));
        while (text.endsWith(u' '))
            text.chop(1);
        print(text);
    };
    QStringList head;
    for (const cellfiles::Column &column : table.columns)
        head << cellfiles::title(column.title);
    line(head);
    for (const cellfiles::Row &row : table.rows)
        line(shownCells(table, row));
}

void printFile(const QString &name, qsizetype size, const cellfiles::View &view, const cellfiles::FileType &type)
{
    print(QStringLiteral("%1  %2").arg(name, cellfiles::title(type.title)));
    if (view.tables.isEmpty())
        print(QStringLiteral("  ") + tr("%1 bytes that are not a text.").arg(size));
    for (const cellfiles::Table &table : view.tables) {
        if (!table.rows.isEmpty())
            printTable(table);
    }
    for (const cellfiles::Warning &warning : view.warnings.list())
        print(QStringLiteral("  ! ")
            + (warning.line > 0 ? tr("line %1: %2").arg(warning.line).arg(warning.reason) : warning.reason));
    print(QString {});
}

/// Prints one set of files; LocalFile if one of them cannot be read any more.
ExitCode show(const files::FileSet &set, const protocol::TextCodec &codec, bool isJson, QJsonObject &json)
{
    for (const auto &[name, hash] : set.hashes) {
        const auto content = set.content(name);
        if (!content) {
            complain(content.error().detail);
            return LocalFile;
        }
        const cellfiles::View view = cellfiles::viewOf(name.bytes(), *content, codec);
        const QString text = codec.decode(name.bytes());
        if (isJson)
            json[text] = toJson(view);
        else
            printFile(text, content->size(), view, cellfiles::fileTypeOf(name.bytes()));
    }
    return Done;
}

} // namespace

int runShow(const QStringList &arguments)
{
    Call call;
    QCommandLineParser parser;
    const QCommandLineOption encoding {
        QStringLiteral("encoding"), tr("The encoding of the pendant."), QStringLiteral("NAME")};
    const VerbHelp help {
        tr("Tells what controller files say: names, tools, frames, variables, parameters, ladder, logs. "
           "Addresses, users and passwords are masked."),
        QStringLiteral("BAG|FOLDER|FILE…"), {encoding}, false, 1, anyNumber};
    if (const auto end = read(call, parser, help, arguments))
        return *end;
    if (call.words.isEmpty())
        return mistake(tr("Say a backup, a folder or files."));
    auto used = std::optional {call.profile.encoding};
    if (parser.isSet(encoding))
        used = protocol::findEncoding(parser.value(encoding));
    if (!used)
        return mistake(tr("There is no encoding “%1”.").arg(parser.value(encoding)));
    QJsonObject json;
    for (const QString &word : call.words) {
        const auto set = goodFiles(bagAt(word));
        if (!set)
            return set.error();
        QJsonObject files;
        if (const ExitCode code = show(*set, protocol::TextCodec {*used}, call.isJson, files); code != Done)
            return code;
        json[word] = files;
    }
    if (call.isJson)
        print(QJsonValue {json});
    return Done;
}

} // namespace pendeskctl
