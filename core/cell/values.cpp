// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cell/comparisons.h"
#include "cellfiles/variablefile.h"
#include <cmath>

/// Variables and names in words.
using namespace cellfiles;
using variables::Kind;
using variables::Reference;

namespace cell {

namespace {

QString valueText(qint64 value) { return QString::number(value); }

/// How far a position went, if both are of the same kind.
QStringList positionChanges(const FilePosition &older, const FilePosition &newer)
{
    QStringList parts;
    if (older.frame != newer.frame)
        return {Sentences::tr("coordinates %1").arg(change(toString(older.frame), toString(newer.frame)))};
    constexpr std::array<const char *, 8> cartesian {"X", "Y", "Z", "Rx", "Ry", "Rz", "7", "8"};
    QStringList axes;
    double square = 0;
    for (std::size_t axis = 0; axis < older.axes.size(); ++axis) {
        if (older.axes[axis] == newer.axes[axis])
            continue;
        const int decimals = older.isPulse() ? 0 : axis < 3 ? 3 : 4;
        const QString name = older.isPulse() ? axisName(int(axis)) : QString::fromLatin1(cartesian[axis]);
        axes << name + u' ' + change(fixedText(older.axes[axis], decimals), fixedText(newer.axes[axis], decimals));
        if (!older.isPulse() && axis < 3)
            square += std::pow(double(newer.axes[axis] - older.axes[axis]) / 1000, 2);
    }
    if (square > 0)
        parts
            << Sentences::tr("moved %1 mm (%2)").arg(std::sqrt(square), 0, 'g', 6).arg(axes.join(QStringLiteral(", ")));
    else if (!axes.isEmpty())
        parts << axes.join(QStringLiteral(", "));
    if (older.tool != newer.tool)
        parts << Sentences::tr("tool %1").arg(change(QString::number(older.tool), QString::number(newer.tool)));
    if (older.userFrame != newer.userFrame)
        parts << Sentences::tr("user frame %1")
                     .arg(change(QString::number(older.userFrame), QString::number(newer.userFrame)));
    if (older.form != newer.form)
        parts << Sentences::tr("form of the arm");
    return parts;
}

/// What a position became; empty if it did not change, or if nobody can know.
QString slotChange(const PositionSlot &older, const PositionSlot &newer)
{
    if (older == newer || older.slot == Slot::Unread || newer.slot == Slot::Unread)
        return {};
    if (newer.slot == Slot::Unused)
        return Sentences::tr("no longer set");
    if (older.slot == Slot::Unused)
        return Sentences::tr("now set (%1)").arg(toString(newer.position.frame));
    return positionChanges(older.position, newer.position).join(QStringLiteral("; "));
}

void add(Statements &statements, const QString &subject, const QString &what)
{
    if (!what.isEmpty())
        statements << Statement {QStringLiteral("%1: %2.").arg(subject, what)};
}

/// Calls `compareOne(number)` for what both have.
template <typename List, typename Compare> void compareLists(const List &older, const List &newer, Compare compareOne)
{
    for (qsizetype number = 0; number < std::min(older.size(), newer.size()); ++number) {
        if (!(older[number] == newer[number]))
            compareOne(int(number));
    }
}

void compareIntegers(
    const VariableFile &older, const VariableFile &newer, Kind kind, const Knowledge &knowledge, Statements &statements)
{
    const auto before = older.integers.value(kind);
    const auto after = newer.integers.value(kind);
    compareLists(before, after, [&](int number) {
        if (before[number] && after[number])
            add(statements, knowledge.text({kind, number}),
                change(valueText(*before[number]), valueText(*after[number])));
    });
}

void compareTexts(const QByteArrayList &before, const QByteArrayList &after, Kind kind, const Context &context,
    Statements &statements)
{
    compareLists(before, after, [&](int number) {
        const bool isUnknown = kind == Kind::R && (before[number].isEmpty() || after[number].isEmpty());
        if (!isUnknown)
            add(statements, context.knowledge.text({kind, number}),
                change(context.codec.decode(before[number]), context.codec.decode(after[number])));
    });
}

void compareShares(const VariableFile &older, const VariableFile &newer, Statements &statements)
{
    for (const Kind kind : sharedKinds) {
        const int before = older.shares.value(kind, -1);
        const int after = newer.shares.value(kind, -1);
        if (before >= 0 && after >= 0 && before != after)
            add(statements, Sentences::tr("Number of variables %1").arg(variables::letters(kind)),
                change(QString::number(before), QString::number(after)));
    }
}

/// Names by number: lost, new, or another.
template <typename Key, typename Text>
Statements compareNames(const QMap<Key, QString> &older, const QMap<Key, QString> &newer, Text text)
{
    Statements statements;
    QMap<Key, QString> all = older;
    all.insert(newer);
    for (auto entry = all.begin(); entry != all.end(); ++entry) {
        const QString before = older.value(entry.key());
        const QString after = newer.value(entry.key());
        if (before == after)
            continue;
        if (after.isEmpty())
            statements << Statement {Sentences::tr("%1 lost its name “%2”.").arg(text(entry.key()), before)};
        else if (before.isEmpty())
            statements << Statement {Sentences::tr("%1 is now named “%2”.").arg(text(entry.key()), after)};
        else
            statements << Statement {Sentences::tr("%1 “%2” is now named “%3”.").arg(text(entry.key()), before, after)};
    }
    return statements;
}

QMap<Reference, QString> sorted(const QHash<Reference, QString> &names)
{
    QMap<Reference, QString> map;
    for (auto name = names.begin(); name != names.end(); ++name)
        map.insert(name.key(), name.value());
    return map;
}

} // namespace

Statements compareVariables(const Context &context)
{
    const VariableFile older = variablesFrom(context.versions.older).value;
    const VariableFile newer = variablesFrom(context.versions.newer).value;
    Statements statements;
    compareShares(older, newer, statements);
    for (const Kind kind : {Kind::B, Kind::I, Kind::D})
        compareIntegers(older, newer, kind, context.knowledge, statements);
    compareTexts(older.reals, newer.reals, Kind::R, context, statements);
    compareTexts(older.strings, newer.strings, Kind::S, context, statements);
    for (const Kind kind : {Kind::P, Kind::BP, Kind::EX}) {
        const auto before = older.positions.value(kind);
        const auto after = newer.positions.value(kind);
        compareLists(before, after, [&](int number) {
            add(statements, context.knowledge.text({kind, number}), slotChange(before[number], after[number]));
        });
    }
    return statements;
}

Statements compareVariableNames(const Context &context)
{
    const auto names = [&](const QByteArray &file) {
        return sorted(variableNamesFrom(file, context.codec).value.byVariable());
    };
    return compareNames(names(context.versions.older), names(context.versions.newer),
        [](const Reference &variable) { return toString(variable); });
}

Statements compareSignalNames(const Context &context)
{
    const auto names = [&](const QByteArray &file) { return signalNamesFrom(file, context.codec).value.names; };
    return compareNames(names(context.versions.older), names(context.versions.newer), cellfiles::signalText);
}

} // namespace cell
