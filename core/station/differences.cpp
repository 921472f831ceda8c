// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "station/differences.h"

#include "files/compare.h"
#include "files/preflight.h"

using cellfiles::FileClass;
using files::Change;
using files::FileSet;
using values::FileName;

namespace station {

namespace {

std::optional<QByteArray> contentOf(const FileSet &set, const QByteArray &bytes)
{
    const auto name = FileName::create(bytes);
    if (!name || !set.hashes.contains(*name))
        return std::nullopt;
    const auto content = set.content(*name);
    return content ? std::optional {*content} : std::nullopt;
}

QByteArrayList namesOf(const FileSet &set)
{
    QByteArrayList names;
    for (const auto &[name, hash] : set.hashes)
        names << name.bytes();
    return names;
}

/// What the newer set does not say of names, parameters and jobs, the older one does.
cell::Knowledge joinedKnowledge(const FileSet &older, const FileSet &newer, const protocol::TextCodec &codec)
{
    QByteArrayList names = namesOf(newer);
    for (const QByteArray &name : namesOf(older)) {
        if (!newer.hashes.contains(*FileName::create(name)))
            names << name;
    }
    const auto read = [&](const QByteArray &name) {
        auto content = contentOf(newer, name);
        return content ? content : contentOf(older, name);
    };
    return cell::knowledgeOf(names, read, codec);
}

struct Sets {
    const FileSet &older;
    const FileSet &newer;
    const files::NoiseFilter &noise;
    const protocol::TextCodec &codec;
};

cell::Statements jobStatements(const cell::Versions &versions, const Sets &sets)
{
    cell::Statements statements;
    for (const QString &text : files::jobEdits(versions.older, versions.newer, sets.noise, sets.codec))
        statements << cell::Statement {text};
    return statements;
}

/// Reads both versions of a changed file and puts the difference into words. What the words call noise is noise.
void explainChange(FileDifference &difference, const Sets &sets, const cell::Knowledge &knowledge)
{
    const auto older = sets.older.content(difference.name);
    const auto newer = sets.newer.content(difference.name);
    if (!older || !newer) {
        difference.change = Change::Unread;
        return;
    }
    const cell::Versions versions {*older, *newer};
    if (files::isJobFile(difference.name)) {
        difference.statements = jobStatements(versions, sets);
        return;
    }
    difference.statements = cell::statementsOf(difference.name.bytes(), versions, knowledge, sets.codec);
    if (!cell::isDifference(difference.statements))
        difference.change = Change::OnlyNoise;
}

bool isNoiseClass(FileClass fileClass) { return fileClass == FileClass::Log || fileClass == FileClass::Counter; }

/// ALL.PRM repeats the other parameter files: what they said already is not said again.
void dropRepeated(QList<FileDifference> &differences, bool hasSingle)
{
    const auto all = std::ranges::find(
        differences, QByteArray {"ALL.PRM"}, [](const FileDifference &difference) { return difference.name.bytes(); });
    if (all == differences.end())
        return;
    if (all->change == Change::New || all->change == Change::Gone)
        all->change = hasSingle ? Change::OnlyNoise : all->change;
    if (all->change != Change::Changed)
        return;
    QSet<QString> said;
    for (const FileDifference &difference : differences) {
        for (const cell::Statement &statement :
            difference.name == all->name ? cell::Statements {} : difference.statements)
            said.insert(statement.text);
    }
    all->statements.removeIf([&](const cell::Statement &statement) { return said.contains(statement.text); });
    if (all->statements.isEmpty())
        all->change = Change::OnlyNoise;
}

} // namespace

bool FileDifference::isSafety() const { return std::ranges::any_of(statements, &cell::Statement::isSafety); }

QList<FileDifference> differencesOf(
    const FileSet &older, const FileSet &newer, const files::NoiseFilter &noise, const protocol::TextCodec &codec)
{
    const Sets sets {older, newer, noise, codec};
    const cell::Knowledge knowledge = joinedKnowledge(older, newer, codec);
    QList<FileDifference> differences;
    for (const files::FileChange &change : compare(older, newer, noise)) {
        if (change.change == Change::Same)
            continue;
        FileDifference difference {change.name, change.change, cellfiles::fileTypeOf(change.name.bytes()).fileClass};
        // A time of day may be noise in a log and is data in a variable: the words know.
        const bool isNoise = change.change == Change::OnlyNoise;
        if (isNoise && cell::hasWords(change.name.bytes()))
            difference.change = Change::Changed;
        if (difference.change == Change::Changed)
            explainChange(difference, sets, knowledge);
        else if (difference.change != Change::Unread && isNoiseClass(difference.fileClass))
            difference.change = Change::OnlyNoise;
        differences << difference;
    }
    const auto single = FileName::create("RC.PRM");
    dropRepeated(differences, older.hashes.contains(*single) && newer.hashes.contains(*single));
    std::ranges::stable_sort(differences, std::ranges::greater {}, &FileDifference::isSafety);
    return differences;
}

int foldedCount(const QList<FileDifference> &differences, FileClass fileClass)
{
    return int(std::ranges::count_if(differences, [fileClass](const FileDifference &difference) {
        return !difference.counts() && difference.fileClass == fileClass;
    }));
}

cell::Knowledge knowledgeOf(const FileSet &set, const protocol::TextCodec &codec)
{
    return cell::knowledgeOf(
        namesOf(set), [&set](const QByteArray &name) { return contentOf(set, name); }, codec);
}

} // namespace station
