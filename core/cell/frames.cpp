// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cell/comparisons.h"
#include "cellfiles/view.h"
#include "cellfiles/views.h"

/// Tools, user frames and areas in words.
using namespace cellfiles;

namespace cell {

namespace {

constexpr std::array<const char *, 6> axisNames {"X", "Y", "Z", "Rx", "Ry", "Rz"};

QString named(const QString &thing, int number, const QString &name)
{
    return name.isEmpty() ? thing.arg(number) : QStringLiteral("%1 “%2”").arg(thing.arg(number), name);
}

/// "Z 163.250 → 165.000", one an axis that differs.
QStringList axisChanges(const Frame &older, const Frame &newer, std::size_t first, std::size_t last)
{
    QStringList changes;
    for (std::size_t axis = first; axis < last; ++axis) {
        const int decimals = axis < 3 ? 3 : 4;
        if (older[axis] != newer[axis])
            changes << QLatin1StringView(axisNames[axis]) + QStringLiteral(" ")
                    + change(fixedText(older[axis], decimals), fixedText(newer[axis], decimals));
    }
    return changes;
}

/// "moved 1.75 mm (Z 163.250 → 165.000)", "turned 0.12 deg (Rz …)".
QStringList frameChanges(const Frame &older, const Frame &newer)
{
    const motion::Pose before = poseOf(older);
    const motion::Pose after = poseOf(newer);
    QStringList parts;
    if (const auto moved = axisChanges(older, newer, 0, 3); !moved.isEmpty())
        parts << Sentences::tr("moved %1 mm (%2)")
                     .arg(motion::distance(before, after), 0, 'g', 6)
                     .arg(moved.join(QStringLiteral(", ")));
    if (const auto turned = axisChanges(older, newer, 3, 6); !turned.isEmpty())
        parts << Sentences::tr("turned %1 deg (%2)")
                     .arg(motion::rotationDistance(before, after), 0, 'g', 4)
                     .arg(turned.join(QStringLiteral(", ")));
    return parts;
}

QString usedBy(int jobs) { return jobs > 0 ? u' ' + Sentences::tr("Used by %n job(s).", nullptr, jobs) : QString {}; }

void compareCentre(const Vector3 &older, const Vector3 &newer, const QString &what, QStringList &parts)
{
    if (older == newer)
        return;
    const auto text = [](const Vector3 &value) {
        return QStringLiteral("%1, %2, %3").arg(fixedText(value[0], 3), fixedText(value[1], 3), fixedText(value[2], 3));
    };
    parts << what.arg(change(text(older), text(newer)));
}

QStringList toolChanges(const Tool &older, const Tool &newer)
{
    if (!older.isWhole || !newer.isWhole)
        return {Sentences::tr("could not be read in one of the files")};
    QStringList parts;
    if (older.name != newer.name)
        parts << Sentences::tr("name %1").arg(change(older.name, newer.name));
    for (const QString &part : frameChanges(older.point, newer.point))
        parts << Sentences::tr("point %1").arg(part);
    if (older.weight != newer.weight)
        parts << Sentences::tr("weight %1 kg").arg(change(fixedText(older.weight, 3), fixedText(newer.weight, 3)));
    compareCentre(older.centreOfGravity, newer.centreOfGravity, Sentences::tr("centre of gravity %1 mm"), parts);
    compareCentre(older.inertia, newer.inertia, Sentences::tr("inertia %1 kgm²"), parts);
    if (older.entryKind != newer.entryKind)
        parts << Sentences::tr("kind of entry %1")
                     .arg(change(QString::number(older.entryKind), QString::number(newer.entryKind)));
    return parts;
}

template <typename Item> QMap<int, Item> byNumber(const QList<Item> &items)
{
    QMap<int, Item> map;
    for (const Item &item : items)
        map.insert(item.number, item);
    return map;
}

/// Says what became of each numbered item; those that one file alone has are new or gone.
template <typename Item, typename Title, typename Changes>
Statements compareItems(const Parsed<QList<Item>> &older, const Parsed<QList<Item>> &newer, Title title,
    Changes changes, const QHash<int, int> &jobs = {})
{
    Statements statements;
    const auto before = byNumber(older.value);
    const auto after = byNumber(newer.value);
    for (const Item &item : after) {
        if (!before.contains(item.number)) {
            statements << Statement {Sentences::tr("%1 is new.").arg(title(item)), true};
            continue;
        }
        const QStringList parts = changes(before[item.number], item);
        if (!parts.isEmpty())
            statements << Statement {QStringLiteral("%1: %2.").arg(title(item), parts.join(QStringLiteral("; ")))
                    + usedBy(jobs.value(item.number)),
                true};
    }
    for (const Item &item : before) {
        if (!after.contains(item.number) && newer.warnings.isEmpty()) // else it may only be unreadable
            statements << Statement {Sentences::tr("%1 is gone.").arg(title(item)), true};
    }
    return statements;
}

} // namespace

Statements compareTools(const Context &context)
{
    const auto older = toolsFrom(context.versions.older, context.codec);
    const auto newer = toolsFrom(context.versions.newer, context.codec);
    const auto title = [](const Tool &tool) { return named(Sentences::tr("Tool %1"), tool.number, tool.name); };
    return compareItems(older, newer, title, toolChanges, context.knowledge.toolJobs);
}

Statements compareUserFrames(const Context &context)
{
    const auto older = userFramesFrom(context.versions.older, context.codec);
    const auto newer = userFramesFrom(context.versions.newer, context.codec);
    const auto title = [](const UserFrame &frame) {
        return named(Sentences::tr("User frame %1"), frame.number, frame.name);
    };
    const auto changes = [](const UserFrame &before, const UserFrame &after) {
        QStringList parts;
        if (before.name != after.name)
            parts << Sentences::tr("name %1").arg(change(before.name, after.name));
        if (before.frame && after.frame)
            parts += frameChanges(*before.frame, *after.frame);
        if (before.frame.has_value() != after.frame.has_value())
            parts << Sentences::tr("where it lies could not be read in one of the files");
        if (before.tool != after.tool)
            parts << Sentences::tr("taught with tool %1")
                         .arg(change(QString::number(before.tool), QString::number(after.tool)));
        if (before.taught != after.taught && parts.isEmpty())
            parts << Sentences::tr("taught at other points");
        return parts;
    };
    return compareItems(older, newer, title, changes, context.knowledge.frameJobs);
}

Statements compareCubes(const Context &context)
{
    const auto older = cubesFrom(context.versions.older, context.codec);
    const auto newer = cubesFrom(context.versions.newer, context.codec);
    const auto title = [](const Cube &cube) { return named(Sentences::tr("Area %1"), cube.number, cube.name); };
    const auto changes = [](const Cube &before, const Cube &after) {
        QStringList parts;
        if (before.name != after.name)
            parts << Sentences::tr("name %1").arg(change(before.name, after.name));
        if (before.isSet() != after.isSet())
            parts << (after.isSet() ? Sentences::tr("set") : Sentences::tr("no longer set"));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const QString name = QString::fromLatin1(axisNames[axis]);
            if (before.upper[axis] != after.upper[axis])
                parts << Sentences::tr("upper %1 %2 mm")
                             .arg(name, change(fixedText(before.upper[axis], 3), fixedText(after.upper[axis], 3)));
            if (before.lower[axis] != after.lower[axis])
                parts << Sentences::tr("lower %1 %2 mm")
                             .arg(name, change(fixedText(before.lower[axis], 3), fixedText(after.lower[axis], 3)));
        }
        if (before.coordinatesField != after.coordinatesField || before.userFrame != after.userFrame
            || before.group != after.group)
            parts << Sentences::tr("other coordinates or another group");
        return parts;
    };
    return compareItems(older, newer, title, changes);
}

Statements compareShock(const Context &context)
{
    const auto rows = [&](const QByteArray &file) { return shockView(file, context.codec).tables.first().rows; };
    const auto older = rows(context.versions.older);
    const auto newer = rows(context.versions.newer);
    Statements statements;
    for (qsizetype index = 0; index < std::min(older.size(), newer.size()); ++index) {
        const QStringList &before = older[index].cells;
        const QStringList &after = newer[index].cells;
        const QString where = Sentences::tr("Collision detection, set %1, group %2").arg(after[0], after[1]);
        if (before[2] != after[2])
            statements << Statement {
                QStringLiteral("%1: %2.").arg(
                    where, after[2] == u"0" ? Sentences::tr("switched off") : Sentences::tr("switched on")),
                true};
        if (before[3] != after[3])
            statements << Statement {
                QStringLiteral("%1: %2.").arg(where, Sentences::tr("level %1").arg(change(before[3], after[3]))), true};
    }
    return statements;
}

} // namespace cell
