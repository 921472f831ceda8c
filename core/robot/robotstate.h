// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/reading.h"
#include "values/job.h"
#include "values/position.h"
#include "values/status.h"
#include "values/systeminformation.h"
#include <QObject>
#include <array>

namespace robot {

/// What is read from a controller, each at its own pace.
enum class Topic {
    Status,
    Job, ///< The master task.
    BasePosition, ///< R1 in the base frame.
    PulsePosition, ///< R1 in pulses.
    BaseAxisNames,
    PulseAxisNames,
    SystemInformation, ///< R1.
};
constexpr int topicCount = 7;

/// How often a topic is read while something wants it; 0: once for each link.
[[nodiscard]] Milliseconds period(Topic topic);

/// The latest value of every topic. Pages listen and show; only the poller writes.
class RobotState : public QObject
{
    Q_OBJECT

public:
    explicit RobotState(QObject *parent = nullptr);

    [[nodiscard]] const Reading<values::Status> &status() const { return m_status; }
    [[nodiscard]] const Reading<values::ExecutingJob> &job() const { return m_job; }
    [[nodiscard]] const Reading<values::Position> &basePosition() const { return m_basePosition; }
    [[nodiscard]] const Reading<values::Position> &pulsePosition() const { return m_pulsePosition; }
    [[nodiscard]] const Reading<values::AxisNames> &baseAxisNames() const { return m_baseAxisNames; }
    [[nodiscard]] const Reading<values::AxisNames> &pulseAxisNames() const { return m_pulseAxisNames; }
    [[nodiscard]] const Reading<values::SystemInformation> &systemInformation() const { return m_systemInformation; }

    /// As of the last change or tick; a change of it is announced by changed().
    [[nodiscard]] Freshness freshness(Topic topic) const { return m_freshness[std::size_t(topic)]; }

    void takeStatus(const values::Status &status, Time now);
    void takeJob(const values::ExecutingJob &job, Time now);
    void takeBasePosition(const values::Position &position, Time now);
    void takePulsePosition(const values::Position &position, Time now);
    void takeBaseAxisNames(const values::AxisNames &names, Time now);
    void takePulseAxisNames(const values::AxisNames &names, Time now);
    void takeSystemInformation(const values::SystemInformation &information, Time now);
    void refuse(Topic topic, const values::Error &error, Time now);

    /// Looks at the clock: values that grew old become stale. Called a few times a period.
    void tick(Time now);
    /// While the link is down every value is stale at once.
    void setLinkUp(bool up, Time now);
    /// Forgets everything: another controller, or none.
    void clear();

Q_SIGNALS:
    /// The value, the refusal or the freshness of `topic` is another than before, or the value was read again.
    void changed(robot::Topic topic);

private:
    template <typename Function> void visit(Topic topic, Function function);
    template <typename Value> void store(Reading<Value> &reading, Topic topic, const Value &value, Time now);
    void update(Topic topic, Time now, bool readAgain);

    Reading<values::Status> m_status;
    Reading<values::ExecutingJob> m_job;
    Reading<values::Position> m_basePosition;
    Reading<values::Position> m_pulsePosition;
    Reading<values::AxisNames> m_baseAxisNames;
    Reading<values::AxisNames> m_pulseAxisNames;
    Reading<values::SystemInformation> m_systemInformation;
    std::array<Freshness, topicCount> m_freshness {};
    bool m_isLinkUp = false;
};

} // namespace robot
