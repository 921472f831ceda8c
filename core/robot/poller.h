// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/readplan.h"
#include "robot/robotstate.h"
#include "session/policy.h"
#include <QTimer>
#include <memory>
#include <set>

namespace session {
class Session;
}

namespace robot {

/// Reads topics into the state, each at its pace, as long as somebody wants them, in the fewest packets. A slot that
/// comes while the last one still waits for its answer is skipped, so there is never a burst after a silence.
///
/// What the controller refuses to tell is found out item by item, shown as refused, and asked for again only now and
/// then; the status, on which the link depends, keeps its pace.
class Poller : public QObject
{
    Q_OBJECT

public:
    /// Somebody's wish to have topics read; letting go of it ends the reading. A page holds one while it is visible.
    using Interest = std::shared_ptr<const QList<TopicRange>>;

    /// `state` must outlive the poller.
    Poller(RobotState &state, protocol::Dialect dialect, QObject *parent = nullptr);
    ~Poller() override;

    [[nodiscard]] Interest want(const QList<TopicRange> &topics);
    /// Each topic is read once, in the background, and not again while this interest is held.
    [[nodiscard]] Interest wantOnce(const QList<TopicRange> &topics);

    /// Only while nothing is read.
    void setDialect(protocol::Dialect dialect) { m_dialect = dialect; }
    /// Begins reading over `session`, which must stay until stop(). Topics that are read once are read again.
    void start(session::Session &session);
    void stop();
    /// Reads a topic that somebody wants without waiting for its slot, unless it is being read.
    void readNow(Topic topic);
    /// From the next slot on; faster at once.
    void setPace(Pace pace);
    /// Tells the state what was read in another way, such as the read back after a write.
    template <Kind kind> void note(int number, const ValueOf<kind> &value)
    {
        m_state.take<kind>(number, value, values::now());
    }
    /// While probing, only the status and the system information are read: enough to find out whether somebody answers.
    void setProbing(bool probing);
    /// Requests that one round of everything wanted now takes.
    [[nodiscard]] int planSize();

Q_SIGNALS:
    /// A read ended: with values or with an error, after the state was told. Silence tells the state nothing.
    void finished(const robot::TopicRange &range, const std::optional<values::Error> &error);

private:
    struct Slot {
        Time due {};
        bool isOnce = false; ///< An answer is enough.
        bool isWaiting = false; ///< A read is on its way.
        bool isHalf = false; ///< Part of a packet that was refused, not answered yet.
    };
    using Plan = std::map<PlannedRead, Slot>;

    using Interests = std::vector<std::weak_ptr<const QList<TopicRange>>>;

    [[nodiscard]] Interest hold(Interests &interests, const QList<TopicRange> &topics);
    [[nodiscard]] QList<TopicRange> wanted();
    [[nodiscard]] QList<TopicRange> wantedOnce();
    [[nodiscard]] bool isDone(const PlannedRead &read, const Slot &slot) const;
    [[nodiscard]] session::Priority priorityOf(const PlannedRead &read) const;
    void noteAnswered(const TopicRange &range);
    void replan();
    void add(Plan &plan, const QList<TopicRange> &topics, bool isOnce);
    void poll();
    void schedule(Time now);
    void send(const PlannedRead &read);
    template <Kind kind> void sendSingle(const PlannedRead &read);
    void sendAlarm(const PlannedRead &read);
    template <Kind kind, typename Item> void sendItems(const PlannedRead &read);
    template <typename Request, typename Take> void ask(const PlannedRead &read, const Request &request, Take take);
    void settle(const PlannedRead &read, const std::optional<values::Error> &error, Time now);
    void settleRefusal(Plan::iterator slot, const values::Error &error, Time now);
    void wake();

    RobotState &m_state;
    protocol::Dialect m_dialect;
    session::Session *m_session = nullptr;
    std::unique_ptr<QObject> m_context; ///< Of the reads on their way; gone with stop().
    Interests m_interests;
    Interests m_onceInterests;
    Plan m_plan;
    std::set<Topic> m_answered; ///< Of those that are read once: for the link, or while an interest is held.
    std::set<Topic> m_refused;
    QTimer m_timer;
    bool m_isProbing = true;
    bool m_isPlanOld = true;
    bool m_hasAlarmTexts = true; ///< Until the controller refuses them.
};

} // namespace robot
