// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "trend/recorder.h"

#include "trend/moment.h"
#include <QCoreApplication>
#include <QLoggingCategory>
#include <algorithm>

namespace trend {

using namespace std::chrono_literals;
using robot::Kind;
using robot::Topic;

namespace {

Q_LOGGING_CATEGORY(trendLog, "pendesk.trend")

constexpr auto patience = 500ms; ///< At the end of the program.

/// What the flight recorder takes, and how many of each: the groups of eight signals beyond are not kept.
bool isFlightTopic(const Topic &topic)
{
    switch (topic.kind) {
    case Kind::Status:
    case Kind::Job:
    case Kind::Position:
    case Kind::Torque:
    case Kind::IoGroup: return true;
    default: return false;
    }
}

QString alarmText(const values::Alarm &alarm, const protocol::TextCodec &codec)
{
    return QCoreApplication::translate("trend", "Alarm %1 [%2] %3")
        .arg(alarm.code)
        .arg(alarm.data.toString(), codec.decode(alarm.name.bytes()))
        .trimmed();
}

} // namespace

Recorder::Recorder(robot::Controller &controller, const QString &folder, QObject *parent)
    : QObject {parent}, m_controller {controller}, m_archive {folder}
{
    for (const Signal &signal : m_archive.signalSet())
        m_tracks.push_back(std::make_unique<Track>(Track {signal, label(signal), Unit::Plain, Series {capacity}}));
    connect(&controller.state(), &robot::RobotState::changed, this, &Recorder::onChanged);
    connect(&m_timer, &QTimer::timeout, this, [this] { tick(now()); });
    m_timer.start(1s);
}

Recorder::~Recorder()
{
    keep(m_flight.finish(now()));
    if (!m_disk.waitForDone(patience))
        qCWarning(trendLog).noquote()
            << tr("An incident is lost: %1 could not be written in time.").arg(m_archive.folder());
}

bool Recorder::add(const Signal &signal)
{
    if (std::ranges::find(m_tracks, signal, [](const auto &track) { return track->signal; }) != m_tracks.end())
        return true;
    if (m_tracks.size() >= mostSignals)
        return false;
    const auto first = measured(state(), signal);
    const Unit unit = first ? first->quantity.unit : Unit::Plain;
    m_tracks.push_back(std::make_unique<Track>(Track {signal, label(state(), signal), unit, Series {capacity}}));
    if (first)
        m_tracks.back()->append(first->at, first->quantity);
    save();
    Q_EMIT tracksChanged();
    return true;
}

void Recorder::remove(const Signal &signal)
{
    const auto found = std::ranges::find(m_tracks, signal, [](const auto &track) { return track->signal; });
    if (found == m_tracks.end())
        return;
    const auto gone = std::move(*found); // who shows it lets go of it when told
    m_tracks.erase(found);
    save();
    Q_EMIT tracksChanged();
}

QList<Signal> Recorder::signalSet() const
{
    QList<Signal> result;
    for (const auto &track : m_tracks)
        result << track->signal;
    return result;
}

void Recorder::save()
{
    m_disk.run(
        this, [folder = m_archive.folder(), set = signalSet()] { return Archive {folder}.saveSignalSet(set); },
        [this](const values::Result<void> &saved) {
            if (!saved)
                Q_EMIT writingFailed(saved.error());
        });
}

void Recorder::onChanged(const robot::TopicRange &range)
{
    if (range.kind == Kind::AxisNames)
        return nameAxes();
    if (range.contains(robot::topics::basePosition))
        m_positionInterest.reset();
    recordPlotted(range);
    for (int number = range.first; number <= range.last; ++number) {
        if (const Topic topic {range.kind, quint16(number)}; isFlightTopic(topic))
            recordFlight(topic);
    }
    if (range.contains(robot::topics::masterJob))
        watchJob();
    if (range.contains(robot::topics::status) || range.kind == Kind::Alarm)
        watchAlarm();
}

void Recorder::recordPlotted(const robot::TopicRange &range)
{
    for (const auto &track : m_tracks) {
        if (!range.contains(track->signal.topic))
            continue;
        if (const auto number = measured(state(), track->signal))
            track->append(number->at, number->quantity);
        else
            track->series.breakOff(now());
    }
}

void Recorder::recordFlight(const Topic &topic)
{
    if (state().freshness(topic) != robot::Freshness::Live)
        return m_flight.breakOff(topic, now());
    for (int element = 0; element < elementCount(topic.kind); ++element) {
        const Signal signal {topic, quint16(element)};
        if (const auto number = isUsed(signal) ? measured(state(), signal) : std::nullopt)
            m_flight.take(signal, number->quantity, number->at);
    }
}

void Recorder::watchJob()
{
    const auto &reading = state().job();
    if (!reading.value || reading.value->name == m_job)
        return;
    m_job = reading.value->name;
    const QString name = protocol::TextCodec {m_controller.profile().encoding}.decode(m_job.bytes());
    m_flight.note(toMoment(reading.clock), QCoreApplication::translate("trend", "Job %1").arg(name));
}

/// The edge is in the status; which alarm it is may be read a little earlier or later.
void Recorder::watchAlarm()
{
    const auto &status = state().status();
    const bool isLive = status.value && state().freshness(robot::topics::status) == robot::Freshness::Live;
    if (isLive && status.value->hasAlarm() != std::exchange(m_hadAlarm, status.value->hasAlarm())
        && status.value->hasAlarm()) {
        m_flight.trigger(toMoment(status.clock), QCoreApplication::translate("trend", "Alarm"));
        m_isTitled = false;
    }
    const auto &reading = state().reading<Kind::Alarm>(1);
    if (!reading.value || reading.value->alarm == m_alarm)
        return;
    m_alarm = reading.value->alarm;
    if (m_alarm.isEmpty())
        return;
    m_alarmText = alarmText(m_alarm, protocol::TextCodec {m_controller.profile().encoding});
    m_flight.note(toMoment(reading.clock), m_alarmText);
}

void Recorder::nameAxes()
{
    for (const auto &track : m_tracks)
        track->label = label(state(), track->signal);
    Q_EMIT tracksChanged();
}

void Recorder::tick(Moment now)
{
    if (m_flight.isKeeping() && !m_isTitled && !m_alarm.isEmpty()) {
        m_flight.setTitle(m_alarmText);
        m_isTitled = true;
    }
    keep(m_flight.tick(now));
    if (m_controller.linkState() == robot::LinkState::Monitoring)
        m_positionInterest = m_controller.poller().want({robot::topics::basePosition});
}

void Recorder::keep(std::optional<Incident> incident)
{
    if (!incident)
        return;
    incident->controller = m_controller.profile().name;
    for (Track &track : incident->tracks)
        track.label = label(state(), track.signal);
    const auto kept = std::make_shared<const Incident>(std::move(*incident));
    m_disk.run(
        this, [folder = m_archive.folder(), kept] { return Archive {folder}.keep(*kept); },
        [this](const values::Result<IncidentEntry> &entry) {
            if (entry)
                Q_EMIT incidentKept(*entry);
            else
                Q_EMIT writingFailed(entry.error());
        });
}

} // namespace trend
