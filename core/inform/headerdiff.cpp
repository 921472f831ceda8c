// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/jobdiffparts.h"

#include <map>

namespace inform {

namespace {

using Edits = QList<JobEdit>;

void add(Edits &edits, EditKind kind, const QByteArray &subject, const QByteArray &older, const QByteArray &newer)
{
    if (older != newer)
        edits << JobEdit {kind, -1, {}, {}, subject, older, newer};
}

/// RW and RO are two ends of one thing: RO alone is named.
void addAttributes(Edits &edits, const Job &older, const Job &newer)
{
    for (const QByteArray &each : newer.attributes) {
        if (each != "RW" && !older.attributes.contains(each))
            edits << JobEdit {EditKind::AttributeAdded, -1, {}, {}, each};
    }
    for (const QByteArray &each : older.attributes) {
        if (each != "RW" && !newer.attributes.contains(each))
            edits << JobEdit {EditKind::AttributeRemoved, -1, {}, {}, each};
    }
}

void addGroups(Edits &edits, const Job &older, const Job &newer)
{
    for (int group = 0; group < std::max(older.groups.size(), newer.groups.size()); ++group)
        add(edits, EditKind::GroupChanged, QByteArray::number(group + 1), older.groups.value(group).join(','),
            newer.groups.value(group).join(','));
}

void addLocals(Edits &edits, const Job &older, const Job &newer)
{
    for (std::size_t kind = 0; kind < localKinds.size(); ++kind)
        add(edits, EditKind::LocalsChanged, localKinds[kind], QByteArray::number(older.locals[kind]),
            QByteArray::number(newer.locals[kind]));
}

void addAliases(Edits &edits, const Job &older, const Job &newer)
{
    std::map<QByteArray, std::pair<QByteArray, QByteArray>> names; // by variable
    for (const Alias &alias : older.aliasList)
        names[alias.variable].first = alias.name;
    for (const Alias &alias : newer.aliasList)
        names[alias.variable].second = alias.name;
    for (const auto &[variable, versions] : names)
        add(edits, EditKind::AliasChanged, variable, versions.first, versions.second);
}

QByteArray textOf(const Argument &argument) { return (argument.type + ' ' + argument.comment).trimmed(); }

void addArguments(Edits &edits, const Job &older, const Job &newer)
{
    for (int index = 0; index < std::max(older.arguments.size(), newer.arguments.size()); ++index)
        add(edits, EditKind::ArgumentChanged, QByteArray::number(index + 1), textOf(older.arguments.value(index)),
            textOf(newer.arguments.value(index)));
}

} // namespace

QList<JobEdit> diffHeaders(const Job &older, const Job &newer, const Clean &clean)
{
    Edits edits;
    add(edits, EditKind::NameChanged, {}, older.name, newer.name);
    add(edits, EditKind::FolderChanged, {}, older.folder, newer.folder);
    if (!clean || clean(older.comment) != clean(newer.comment))
        add(edits, EditKind::CommentChanged, {}, older.comment, newer.comment);
    addAttributes(edits, older, newer);
    add(edits, EditKind::FrameChanged, {}, older.frame, newer.frame);
    addGroups(edits, older, newer);
    addLocals(edits, older, newer);
    addAliases(edits, older, newer);
    addArguments(edits, older, newer);
    return edits;
}

} // namespace inform
