// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/robotstate.h"
#include <QTimer>
#include <memory>

namespace session {
class Session;
}

namespace robot {

/// Reads topics into the state, each at its pace, as long as somebody wants them. A slot that comes while the last one
/// still waits for its answer is skipped, so there is never a burst after a silence.
class Poller : public QObject
{
    Q_OBJECT

public:
    /// Somebody's wish to have topics read; letting go of it ends the reading. A page holds one while it is visible.
    using Interest = std::shared_ptr<const QList<Topic>>;

    /// `state` must outlive the poller.
    explicit Poller(RobotState &state, QObject *parent = nullptr);
    ~Poller() override;

    [[nodiscard]] Interest want(const QList<Topic> &topics);

    /// Begins reading over `session`, which must stay until stop(). Topics that are read once are read again.
    void start(session::Session &session);
    void stop();
    /// Reads a topic without waiting for its slot, unless it is being read.
    void readNow(Topic topic);
    /// While probing, only the status and the system information are read: enough to find out whether somebody answers.
    void setProbing(bool probing);

Q_SIGNALS:
    /// A read of `topic` ended: with a value or with an error, after the state was told. Silence tells the state
    /// nothing.
    void finished(robot::Topic topic, const std::optional<values::Error> &error);

private:
    struct Slot {
        Time due {};
        bool isWaiting = false; ///< A read is on its way.
        bool isDone = false; ///< Read once, and that was enough.
    };

    [[nodiscard]] bool isWanted(Topic topic) const;
    void poll();
    void schedule(Time now);
    void read(Topic topic);
    template <typename Request, typename Take> void ask(Topic topic, const Request &request, Take take);
    void settle(Topic topic, const std::optional<values::Error> &error, Time now);
    Slot &slot(Topic topic) { return m_slots[std::size_t(topic)]; }

    RobotState &m_state;
    session::Session *m_session = nullptr;
    std::unique_ptr<QObject> m_context; ///< Of the reads on their way; gone with stop().
    std::vector<std::weak_ptr<const QList<Topic>>> m_interests;
    std::array<Slot, topicCount> m_slots;
    QTimer m_timer;
    bool m_isProbing = true;
};

} // namespace robot
