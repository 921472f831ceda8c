// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/compare.h"

#include "inform/jobdiff.h"
#include "inform/linediff.h"
#include <algorithm>

using values::FileName;

namespace files {

using inform::diffLines;
using inform::Hunk;

namespace {

Change changeOfBytes(const FileName &name, const FileSet &older, const FileSet &newer, const NoiseFilter &noise)
{
    const auto before = older.content(name);
    const auto after = newer.content(name);
    if (!before || !after)
        return Change::Unread;
    return noise.cleanLines(*before) == noise.cleanLines(*after) ? Change::OnlyNoise : Change::Changed;
}

bool isUnknown(const FileName &name, const FileSet &set)
{
    return set.unread.contains(name) || set.unlisted.contains(name.extension().toByteArray());
}

Change changeOf(const FileName &name, const FileSet &older, const FileSet &newer, const NoiseFilter &noise)
{
    const auto before = older.hashes.find(name);
    const auto after = newer.hashes.find(name);
    const bool wasThere = before != older.hashes.end();
    const bool isThere = after != newer.hashes.end();
    if ((!wasThere && isUnknown(name, older)) || (!isThere && isUnknown(name, newer)))
        return Change::Unread;
    if (!wasThere || !isThere)
        return wasThere ? Change::Gone : Change::New;
    return before->second == after->second ? Change::Same : changeOfBytes(name, older, newer, noise);
}

QByteArray lineAt(const std::vector<inform::TextLine> &lines, int index)
{
    return index < 0 ? QByteArray {} : lines[std::size_t(index)].text.toByteArray();
}

} // namespace

QList<FileChange> compare(const FileSet &older, const FileSet &newer, const NoiseFilter &noise)
{
    std::set<FileName> names = older.unread;
    names.insert(newer.unread.begin(), newer.unread.end());
    for (const FileSet *set : {&older, &newer}) {
        for (const auto &[name, hash] : set->hashes)
            names.insert(name);
    }
    QList<FileChange> changes;
    for (const FileName &name : names)
        changes << FileChange {name, changeOf(name, older, newer, noise)};
    return changes;
}

int differences(const QList<FileChange> &changes)
{
    return int(std::ranges::count_if(changes,
        [](const FileChange &change) { return change.change != Change::Same && change.change != Change::OnlyNoise; }));
}

QList<ComparedLine> compareText(const QByteArray &older, const QByteArray &newer, const NoiseFilter &noise)
{
    const auto oldLines = inform::splitLines(older);
    const auto newLines = inform::splitLines(newer);
    QList<ComparedLine> result;
    int oldAt = 0;
    int newAt = 0;
    const auto add = [&](int oldLine, int newLine, bool isSame) {
        result << ComparedLine {oldLine, newLine, lineAt(oldLines, oldLine), lineAt(newLines, newLine), isSame};
    };
    const auto addSameUntil = [&](int oldEnd) {
        while (oldAt < oldEnd)
            add(oldAt++, newAt++, true);
    };
    for (const Hunk &block : diffLines(noise.cleanLines(older), noise.cleanLines(newer))) {
        addSameUntil(block.oldFrom);
        for (int index = 0; index < std::max(block.oldCount, block.newCount); ++index)
            add(index < block.oldCount ? oldAt++ : -1, index < block.newCount ? newAt++ : -1, false);
    }
    addSameUntil(int(oldLines.size()));
    return result;
}

QStringList jobEdits(
    const QByteArray &older, const QByteArray &newer, const NoiseFilter &noise, const protocol::TextCodec &codec)
{
    const inform::Job before = inform::parse(older);
    const inform::Job after = inform::parse(newer);
    QStringList texts;
    if (!before.isJob || !after.isJob)
        return texts;
    const auto clean = [&noise](const QByteArray &text) { return noise.clean(text); };
    const auto decode = [&codec](QByteArrayView bytes) { return codec.decode(bytes); };
    for (const inform::JobEdit &edit : inform::diffJobs(before, after, clean))
        texts << inform::explain(edit, decode);
    return texts;
}

} // namespace files
