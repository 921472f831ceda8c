// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "cell/comparison.h"
#include "cellfiles/filetypes.h"
#include <QDirIterator>
#include <QFile>

namespace fuzz {

namespace {

/// Three bytes choose a type of controller file, an encoding, and whether the file that follows is read or compared with
/// its first half.
void take(QByteArrayView data)
{
    Source source {data};
    const cellfiles::FileType &type = source.choose(cellfiles::fileTypes());
    const protocol::TextCodec codec {source.choose(protocol::encodings()).encoding};
    const bool isCompared = source.byte() % 2 != 0;
    const QByteArray name = QByteArray {type.pattern}.replace('*', "X");
    const QByteArray file = source.rest().toByteArray();
    if (isCompared) {
        const auto found = cell::statementsOf(name, {file.first(file.size() / 2), file}, {}, codec);
        return require(found.size() <= cell::mostStatements, "a comparison without a bound");
    }
    const qsizetype lines = file.count('\n') + 1;
    for (const cellfiles::Table &table : cellfiles::viewOf(name, file, codec).tables) {
        for (const cellfiles::Row &row : table.rows) {
            require(row.line >= 0 && row.line <= lines, "a row from a line that is not there");
            require(row.cells.size() <= table.columns.size(), "more cells than columns");
        }
    }
}

/// The small ones among the files of real forms, each with the bytes that choose its type.
Seeds seeds()
{
    constexpr qint64 small = 900;
    Seeds seeds;
    QDirIterator files {QStringLiteral(PENDESK_TEST_DATA "/cell"), QDir::Files, QDirIterator::Subdirectories};
    while (files.hasNext()) {
        QFile file {files.next()};
        if (file.size() > small || !file.open(QIODevice::ReadOnly))
            continue;
        const auto &type = cellfiles::fileTypeOf(files.fileName().toLatin1());
        const auto row = char(&type - cellfiles::fileTypes().data());
        const QByteArray content = file.readAll();
        seeds << QByteArray {1, row} + '\0' + '\0' + content << QByteArray {1, row} + '\2' + '\1' + content;
    }
    return seeds;
}

} // namespace

extern const Target cellFile;
const Target cellFile {"cellFile", take, seeds, 900, 5'000};

} // namespace fuzz
