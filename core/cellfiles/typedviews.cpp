// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cellfiles/arm.h"
#include "cellfiles/homepositions.h"
#include "cellfiles/sentences.h"
#include "cellfiles/signalnames.h"
#include "cellfiles/variablefile.h"
#include "cellfiles/views.h"

namespace cellfiles {

namespace {

constexpr std::array<const char *, 6> frameColumns {"X mm", "Y mm", "Z mm", "Rx deg", "Ry deg", "Rz deg"};

QList<Column> numbers(std::span<const char *const> titles)
{
    QList<Column> columns;
    for (const char *column : titles)
        columns << Column {column, true};
    return columns;
}

QStringList texts(const Frame &frame)
{
    QStringList cells;
    for (std::size_t axis = 0; axis < frame.size(); ++axis)
        cells << fixedText(frame[axis], axis < 3 ? 3 : 4);
    return cells;
}

QStringList texts(const Vector3 &values)
{
    return {fixedText(values[0], 3), fixedText(values[1], 3), fixedText(values[2], 3)};
}

QString entryKindText(int kind)
{
    switch (kind) {
    case 0:
    case 1: return Sentences::tr("not entered");
    case 2: return Sentences::tr("by hand");
    case 3: return Sentences::tr("measured load");
    default: return QString::number(kind);
    }
}

QString coordinatesText(const Cube &cube)
{
    switch (cube.coordinates()) {
    case CubeCoordinates::Base: return Sentences::tr("base coordinates");
    case CubeCoordinates::Robot: return Sentences::tr("robot coordinates");
    case CubeCoordinates::User: return Sentences::tr("user frame %1").arg(cube.userFrame);
    case CubeCoordinates::Other: break;
    }
    return QString::number(cube.coordinatesField);
}

QStringList pulsesOf(const HomeGroup &home)
{
    QStringList cells;
    for (const HomeAxis &axis : home.axes)
        cells << (axis.isValid ? QString::number(axis.pulses) : QStringLiteral("—"));
    return cells;
}

Table homeTable(const char *name, const HomePositions &homes)
{
    Table table {name,
        {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "group")}, {"S", true}, {"L", true}, {"U", true}, {"R", true},
            {"B", true}, {"T", true}, {"E", true}, {"8", true}}};
    for (const HomeGroup &home : homes.groups)
        table.add(0, QStringList {home.group.name} + pulsesOf(home));
    return table;
}

QStringList slotCells(const PositionSlot &slot)
{
    if (slot.slot != Slot::Used)
        return {slot.slot == Slot::Unused ? Sentences::tr("unused") : QStringLiteral("—")};
    const FilePosition &position = slot.position;
    QStringList cells {toString(position.frame), QString::number(position.tool),
        position.frame == PositionFrame::User ? QString::number(position.userFrame) : QString {},
        QString::number(position.form, 2).rightJustified(6, u'0')};
    for (std::size_t axis = 0; axis < position.axes.size(); ++axis)
        cells << fixedText(position.axes[axis], position.isPulse() ? 0 : axis < 3 ? 3 : 4);
    return cells;
}

QString valueText(const VariableFile &file, variables::Kind kind, int number, const Codec &codec)
{
    using variables::Kind;
    if (kind == Kind::S)
        return codec.decode(file.strings[number]);
    if (kind == Kind::R)
        return file.reals[number].isEmpty() ? QStringLiteral("—") : QString::fromLatin1(file.reals[number]);
    const auto value = file.integers[kind][number];
    return value ? QString::number(*value) : QStringLiteral("—");
}

qsizetype countOf(const VariableFile &file, variables::Kind kind)
{
    using variables::Kind;
    return kind == Kind::S ? file.strings.size() : kind == Kind::R ? file.reals.size() : file.integers[kind].size();
}

} // namespace

View toolView(QByteArrayView file, const Codec &codec)
{
    const auto parsed = toolsFrom(file, codec);
    Table table {QT_TRANSLATE_NOOP("cellfiles::Sentences", "tools"),
        QList<Column> {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "number"), true},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "name")}}
            + numbers(frameColumns)
            + numbers(std::array {"Xg mm", "Yg mm", "Zg mm", QT_TRANSLATE_NOOP("cellfiles::Sentences", "weight kg"),
                "Ix kgm²", "Iy kgm²", "Iz kgm²"})
            + QList<Column> {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "entered")}}};
    for (const Tool &tool : parsed.value)
        table.add(tool.line,
            QStringList {QString::number(tool.number), tool.name} + texts(tool.point) + texts(tool.centreOfGravity)
                + QStringList {fixedText(tool.weight, 3)} + texts(tool.inertia)
                + QStringList {entryKindText(tool.entryKind)});
    return {{table}, parsed.warnings};
}

View userFrameView(QByteArrayView file, const Codec &codec)
{
    const auto parsed = userFramesFrom(file, codec);
    Table table {QT_TRANSLATE_NOOP("cellfiles::Sentences", "user frames"),
        QList<Column> {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "number"), true},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "name")},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "tool"), true}}
            + numbers(frameColumns)};
    for (const UserFrame &frame : parsed.value)
        table.add(frame.line,
            QStringList {QString::number(frame.number), frame.name, QString::number(frame.tool)}
                + (frame.frame ? texts(*frame.frame) : QStringList(6, QStringLiteral("—"))));
    return {{table}, parsed.warnings};
}

View cubeView(QByteArrayView file, const Codec &codec)
{
    const auto parsed = cubesFrom(file, codec);
    Table table {QT_TRANSLATE_NOOP("cellfiles::Sentences", "interference areas"),
        QList<Column> {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "number"), true},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "name")},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "coordinates")}}
            + numbers(std::array {QT_TRANSLATE_NOOP("cellfiles::Sentences", "lower X mm"),
                QT_TRANSLATE_NOOP("cellfiles::Sentences", "upper X mm"),
                QT_TRANSLATE_NOOP("cellfiles::Sentences", "lower Y mm"),
                QT_TRANSLATE_NOOP("cellfiles::Sentences", "upper Y mm"),
                QT_TRANSLATE_NOOP("cellfiles::Sentences", "lower Z mm"),
                QT_TRANSLATE_NOOP("cellfiles::Sentences", "upper Z mm")})};
    for (const Cube &cube : parsed.value) {
        QStringList cells {
            QString::number(cube.number), cube.name, cube.isSet() ? coordinatesText(cube) : Sentences::tr("not set")};
        for (std::size_t axis = 0; axis < 3; ++axis)
            cells << fixedText(cube.lower[axis], 3) << fixedText(cube.upper[axis], 3);
        table.add(cube.line, cells);
    }
    return {{table}, parsed.warnings};
}

View variableView(QByteArrayView file, const Codec &codec)
{
    const auto parsed = variablesFrom(file);
    Table values {QT_TRANSLATE_NOOP("cellfiles::Sentences", "variables"),
        {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "variable")},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "value"), true}}};
    Table positions {QT_TRANSLATE_NOOP("cellfiles::Sentences", "positions"),
        {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "variable")},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "coordinates")},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "tool"), true},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "user frame"), true},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "form")}, {"1", true}, {"2", true}, {"3", true}, {"4", true},
            {"5", true}, {"6", true}, {"7", true}, {"8", true}}};
    for (const variables::Kind kind : sharedKinds) {
        const auto positionList = parsed.value.positions.value(kind);
        for (int number = 0; number < positionList.size(); ++number)
            positions.add(
                0, QStringList {toString(variables::Reference {kind, number})} + slotCells(positionList[number]));
        for (int number = 0; !variables::isPosition(kind) && number < countOf(parsed.value, kind); ++number)
            values.add(
                0, {toString(variables::Reference {kind, number}), valueText(parsed.value, kind, number, codec)});
    }
    return {{values, positions}, parsed.warnings};
}

View variableNameView(QByteArrayView file, const Codec &codec)
{
    const auto parsed = variableNamesFrom(file, codec);
    Table table {QT_TRANSLATE_NOOP("cellfiles::Sentences", "names"),
        {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "variable")}, {QT_TRANSLATE_NOOP("cellfiles::Sentences", "name")}}};
    for (const VariableName &name : parsed.value.names)
        table.add(name.line, {toString(name.variable), name.name});
    return {{table}, parsed.warnings};
}

View signalNameView(QByteArrayView file, const Codec &codec)
{
    const auto parsed = signalNamesFrom(file, codec);
    Table table {QT_TRANSLATE_NOOP("cellfiles::Sentences", "names"),
        {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "signal")}, {QT_TRANSLATE_NOOP("cellfiles::Sentences", "number")},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "name")}}};
    for (auto name = parsed.value.names.begin(); name != parsed.value.names.end(); ++name)
        table.add(parsed.value.lines.value(name.key()),
            {signalText(name.key()), QStringLiteral("#%1").arg(name.key(), 5, 10, QLatin1Char {'0'}), name.value()});
    return {{table}, parsed.warnings};
}

View registerNameView(QByteArrayView file, const Codec &codec)
{
    const auto parsed = registerNamesFrom(file, codec);
    Table table {QT_TRANSLATE_NOOP("cellfiles::Sentences", "names"),
        {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "register")}, {QT_TRANSLATE_NOOP("cellfiles::Sentences", "name")}}};
    for (auto name = parsed.value.names.begin(); name != parsed.value.names.end(); ++name)
        table.add(0, {toString(variables::Reference {variables::Kind::M, name.key()}), name.value()});
    return {{table}, parsed.warnings};
}

View timerNameView(QByteArrayView file, const Codec &codec)
{
    const auto parsed = timerNamesFrom(file, codec);
    Table table {QT_TRANSLATE_NOOP("cellfiles::Sentences", "names"),
        {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "timer")}, {QT_TRANSLATE_NOOP("cellfiles::Sentences", "name")}}};
    for (auto name = parsed.value.timers.begin(); name != parsed.value.timers.end(); ++name)
        table.add(0, {QStringLiteral("TM%1").arg(name.key(), 3, 10, QLatin1Char {'0'}), name.value()});
    for (auto name = parsed.value.flags.begin(); name != parsed.value.flags.end(); ++name)
        table.add(0, {QStringLiteral("TF%1").arg(name.key(), 3, 10, QLatin1Char {'0'}), name.value()});
    return {{table}, parsed.warnings};
}

View encoderOffsetView(QByteArrayView file, const Codec &)
{
    const auto parsed = encoderOffsetsFrom(file);
    return {{homeTable(QT_TRANSLATE_NOOP("cellfiles::Sentences", "home positions, pulses"), parsed.value)},
        parsed.warnings};
}

View homePositionView(QByteArrayView file, const Codec &)
{
    const auto parsed = homePositionsFrom(file);
    return {{homeTable(QT_TRANSLATE_NOOP("cellfiles::Sentences", "home positions, pulses"), parsed.value)},
        parsed.warnings};
}

View pseudoInputView(QByteArrayView file, const Codec &codec)
{
    const auto parsed = pseudoInputsFrom(file, codec);
    Table table {QT_TRANSLATE_NOOP("cellfiles::Sentences", "pseudo inputs"),
        {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "byte"), true},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "bits")}}};
    for (int byte = 0; byte < parsed.value.bytes.size(); ++byte)
        table.add(0, {QString::number(byte + 1), QString::number(parsed.value.bytes[byte], 2).rightJustified(8, u'0')});
    Table names {QT_TRANSLATE_NOOP("cellfiles::Sentences", "names"),
        {{QT_TRANSLATE_NOOP("cellfiles::Sentences", "number"), true},
            {QT_TRANSLATE_NOOP("cellfiles::Sentences", "name")}}};
    for (auto name = parsed.value.names.begin(); name != parsed.value.names.end(); ++name)
        names.add(0, {QString::number(name.key() + 1), name.value()});
    return {{table, names}, parsed.warnings};
}

} // namespace cellfiles
