// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "trend/incident.h"

#include "trend/moment.h"
#include <QJsonArray>
#include <algorithm>

namespace trend {

using values::ErrorKind;
using values::failure;
using values::Result;

namespace {

constexpr int version = 1;

QString s(const char *key) { return QString::fromLatin1(key); }

constexpr const char *unitKeys[] {"", "bit", "pulse", "mm", "deg", "percent", "celsius", "hour"};
static_assert(std::size(unitKeys) == std::size_t(Unit::Hour) + 1);

std::optional<Unit> unitFromKey(const QString &key)
{
    const auto found = std::ranges::find_if(unitKeys, [&](const char *known) { return key == QLatin1String(known); });
    return found == std::end(unitKeys) ? std::nullopt : std::optional(Unit(found - std::begin(unitKeys)));
}

QJsonObject toJson(const Note &note) { return {{s("at"), toIso(note.at)}, {s("text"), note.text}}; }

QJsonObject toJson(const Track &track, Moment zero)
{
    QJsonArray samples;
    for (const Sample &sample : track.series.samples())
        samples << QJsonArray {qint64((sample.at - zero).count()),
            sample.isGap() ? QJsonValue(QJsonValue::Null) : QJsonValue(sample.value)};
    return {{s("signal"), key(track.signal)}, {s("label"), track.label},
        {s("unit"), s(unitKeys[std::size_t(track.unit)])}, {s("samples"), samples}};
}

Result<Moment> momentFrom(const QJsonObject &json, const char *key)
{
    const auto moment = fromIso(json[s(key)].toString());
    if (!moment)
        return values::badInput(QStringLiteral("\"%1\" is no UTC time").arg(s(key)));
    return *moment;
}

Result<Sample> sampleFrom(const QJsonValue &json, Moment zero)
{
    const QJsonArray pair = json.toArray();
    if (pair.size() != 2 || !pair[0].isDouble() || !(pair[1].isDouble() || pair[1].isNull()))
        return values::badInput(QStringLiteral("a sample is not [milliseconds, value]"));
    const Moment at = zero + std::chrono::milliseconds {pair[0].toInteger()};
    return pair[1].isNull() ? Sample::gap(at) : Sample {at, pair[1].toDouble()};
}

Result<Track> trackFrom(const QJsonObject &json, const Signal &signal, Moment zero)
{
    const QJsonArray samples = json[s("samples")].toArray();
    const auto unit = unitFromKey(json[s("unit")].toString());
    if (!unit)
        return values::badInput(QStringLiteral("%1 has no known unit").arg(key(signal)));
    Track track {
        signal, json[s("label")].toString(), *unit, Series {std::size_t(std::max<qsizetype>(samples.size(), 2))}};
    for (const QJsonValue value : samples) {
        const auto sample = sampleFrom(value, zero);
        if (!sample)
            return tl::unexpected(sample.error());
        if (!track.series.isEmpty() && sample->at <= track.series.back().at)
            return values::badInput(QStringLiteral("%1 is not in the order of time").arg(key(signal)));
        track.series.append(sample->at, sample->value);
    }
    return track;
}

Result<void> readTracks(const QJsonArray &tracks, Incident &incident)
{
    for (const QJsonValue value : tracks) {
        const QJsonObject json = value.toObject();
        const auto signal = fromKey(json[s("signal")].toString());
        if (!signal)
            continue;
        auto track = trackFrom(json, *signal, incident.at);
        if (!track)
            return tl::unexpected(track.error());
        incident.tracks.push_back(std::move(*track));
    }
    return {};
}

Result<void> readNotes(const QJsonArray &notes, Incident &incident)
{
    for (const QJsonValue value : notes) {
        const auto at = momentFrom(value.toObject(), "at");
        if (!at)
            return tl::unexpected(at.error());
        incident.notes << Note {*at, value.toObject()[s("text")].toString()};
    }
    return {};
}

} // namespace

QJsonObject toJson(const Incident &incident)
{
    QJsonArray notes;
    for (const Note &note : incident.notes)
        notes << toJson(note);
    QJsonArray tracks;
    for (const Track &track : incident.tracks)
        tracks << toJson(track, incident.at);
    return {{s("version"), version}, {s("controller"), incident.controller}, {s("title"), incident.title},
        {s("at"), toIso(incident.at)}, {s("from"), toIso(incident.range.from)}, {s("to"), toIso(incident.range.to)},
        {s("notes"), notes}, {s("tracks"), tracks}};
}

Result<Incident> incidentFromJson(const QJsonObject &json)
{
    if (json[s("version")].toInt() != version)
        return values::badInput(QStringLiteral("not an incident of version %1").arg(version));
    const auto at = momentFrom(json, "at");
    const auto from = momentFrom(json, "from");
    const auto to = momentFrom(json, "to");
    for (const auto &moment : {at, from, to}) {
        if (!moment)
            return tl::unexpected(moment.error());
    }
    Incident incident {json[s("controller")].toString(), json[s("title")].toString(), *at, {*from, *to}, {}, {}};
    if (!incident.range.contains(*at))
        return values::badInput(QStringLiteral("the alarm lies outside the recording"));
    if (const auto read = readNotes(json[s("notes")].toArray(), incident); !read)
        return tl::unexpected(read.error());
    if (const auto read = readTracks(json[s("tracks")].toArray(), incident); !read)
        return tl::unexpected(read.error());
    return incident;
}

} // namespace trend
