// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/snapshot.h"

#include "protocol/fields.h"
#include "protocol/payloads.h"

using values::AxisNames;
using values::AxisUnit;

namespace robot {

namespace {

QString latin(QByteArrayView bytes) { return QString::fromLatin1(bytes); }

/// The named fields of a value, as `pendeskctl decode` names them.
template <typename Value> QJsonObject fieldsOf(const Value &value, const protocol::TextCodec &codec)
{
    const QByteArray payload = protocol::encode(value);
    protocol::FieldReader reader {payload, 0, codec};
    Value copy = value;
    protocol::Layout<Value>::describe(reader, copy);
    QJsonObject json;
    for (const protocol::Field &field : reader.fields())
        json[field.name] = field.value;
    return json;
}

QString axisText(qint32 word, AxisUnit unit)
{
    switch (unit) {
    case AxisUnit::Pulse: break;
    case AxisUnit::Micrometre: return QString::number(word / 1e3, 'f', 3) + QStringLiteral(" mm");
    case AxisUnit::TenThousandthDegree: return QString::number(word / 1e4, 'f', 4) + QStringLiteral("°");
    }
    return QString::number(word);
}

QString axesLine(const values::Position &position, const Reading<AxisNames> &names)
{
    return axisWords(position, names.value.value_or(AxisNames {})).join(QStringLiteral("  "));
}

QString jobLine(const values::ExecutingJob &job, const protocol::TextCodec &codec)
{
    return QStringLiteral("%1  line %2  step %3  override %4 %")
        .arg(job.name.isEmpty() ? QStringLiteral("none") : codec.decode(job.name.bytes()))
        .arg(job.line)
        .arg(job.step)
        .arg(job.speedOverride / 100.0, 0, 'f', 2);
}

QString systemLine(const values::SystemInformation &system)
{
    return QStringLiteral("%1  %2  parameters %3")
        .arg(latin(system.model.bytes()), latin(system.software.bytes()), latin(system.parameters.bytes()));
}

} // namespace

QStringList axisWords(const values::Position &position, const AxisNames &names)
{
    QStringList words;
    for (int axis = 0; axis < position.axes.count(); ++axis) {
        const QString name = latin(names.names[std::size_t(axis)].bytes());
        words += QStringLiteral("%1 %2").arg(name.isEmpty() ? QString::number(axis + 1) : name,
            axisText(position.axes[axis], values::axisUnit(position.type, axis)));
    }
    return words;
}

QStringList toLines(const RobotState &state, const protocol::TextCodec &codec)
{
    QStringList lines;
    const auto add = [&](const char *name, const QString &text) { lines += latin(name).leftJustified(10) + text; };
    if (const auto &status = state.status().value)
        add("status", status->bitNames().join(QStringLiteral(", ")).replace(u'_', u' '));
    if (const auto &job = state.job().value)
        add("job", jobLine(*job, codec));
    if (const auto &position = state.basePosition().value)
        add("base", axesLine(*position, state.baseAxisNames()));
    if (const auto &position = state.pulsePosition().value)
        add("pulses", axesLine(*position, state.pulseAxisNames()));
    if (const auto &system = state.systemInformation().value)
        add("system", systemLine(*system));
    return lines;
}

QJsonObject toJson(const RobotState &state, const protocol::TextCodec &codec)
{
    QJsonObject json;
    const auto insert = [&](const char *name, const auto &reading) {
        if (reading.value)
            json[latin(name)] = fieldsOf(*reading.value, codec);
    };
    insert("status", state.status());
    insert("job", state.job());
    insert("base_position", state.basePosition());
    insert("pulse_position", state.pulsePosition());
    insert("base_axes", state.baseAxisNames());
    insert("pulse_axes", state.pulseAxisNames());
    insert("system", state.systemInformation());
    return json;
}

} // namespace robot
