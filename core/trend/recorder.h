// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "disk/worker.h"
#include "robot/controller.h"
#include "trend/archive.h"
#include "trend/flightrecorder.h"
#include "trend/measured.h"

namespace trend {

/// What is recorded of one controller, whatever page is in view: the signals that somebody plots, and the flight
/// recorder. It takes what is read anyway: status, positions, torques, I/O, jobs, alarms. For itself it only asks for
/// the position of R1 in the base frame, once a second: one request a second. A signal that nobody reads has a gap.
class Recorder : public QObject
{
    Q_OBJECT

public:
    static constexpr std::size_t capacity = 36000; ///< Samples of a plotted signal: an hour at 10 Hz.
    static constexpr int mostSignals = 64;

    /// `controller` must outlive the recorder. Begins with the saved signals.
    Recorder(robot::Controller &controller, const QString &folder, QObject *parent = nullptr);
    ~Recorder() override;

    /// Begins to record a signal, unless it is recorded. False if there are too many.
    bool add(const Signal &signal);
    void remove(const Signal &signal);
    /// In the order in which they were added. The pointers hold until the signal is removed.
    [[nodiscard]] const std::vector<std::unique_ptr<Track>> &tracks() const { return m_tracks; }
    [[nodiscard]] QList<Signal> signalSet() const;

    [[nodiscard]] const Archive &archive() const { return m_archive; }
    /// Looks at the clock: incidents that are due are kept. It calls itself once a second.
    void tick(Moment now);
    /// A signal may be plotted although nothing of it was read yet; so may every other number of this controller.
    [[nodiscard]] const robot::RobotState &state() const { return m_controller.state(); }

Q_SIGNALS:
    /// A signal came or went, or the controller told the name of its axis.
    void tracksChanged();
    /// An incident was written to the archive.
    void incidentKept(const trend::IncidentEntry &entry);
    /// An incident or the set of signals could not be written.
    void writingFailed(const values::Error &error);

private:
    void onChanged(const robot::TopicRange &range);
    void recordPlotted(const robot::TopicRange &range);
    void recordFlight(const robot::Topic &topic);
    void watchAlarm();
    void watchJob();
    void nameAxes();
    void keep(std::optional<Incident> incident);
    void save();

    robot::Controller &m_controller;
    Archive m_archive;
    std::vector<std::unique_ptr<Track>> m_tracks;
    FlightRecorder m_flight;
    bool m_hadAlarm = true; ///< As of the last live status; the first one is no edge.
    values::Alarm m_alarm; ///< The newest one.
    QString m_alarmText;
    bool m_isTitled = false; ///< The incident that is being kept has the text of an alarm.
    values::JobName m_job;
    robot::Poller::Interest m_positionInterest; ///< Until the position is read, once a second.
    QTimer m_timer;
    disk::Worker m_disk;
};

} // namespace trend
