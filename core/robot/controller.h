// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/holdstate.h"
#include "robot/poller.h"
#include "robot/robotstate.h"
#include "robot/stoporder.h"
#include "session/statistics.h"
#include "settings/profile.h"
#include <QPointer>
#include <QTimer>
#include <memory>

class QHostAddress;

namespace session {
class FileSession;
class Session;
} // namespace session

namespace robot {

/// One robot controller: its link, what was read from it, and the orders it can be given.
class Controller : public QObject
{
    Q_OBJECT

public:
    explicit Controller(settings::Profile profile, QObject *parent = nullptr);
    ~Controller() override;

    [[nodiscard]] const settings::Profile &profile() const { return m_profile; }
    [[nodiscard]] LinkState linkState() const { return m_linkState; }
    /// When the present link state began, by this computer's clock.
    [[nodiscard]] QDateTime linkStateSince() const { return m_linkStateSince; }
    /// Why checking does not get on; empty while it does, and in the other states.
    [[nodiscard]] const std::optional<values::Error> &trouble() const { return m_trouble; }
    /// How often communication was lost since open(); monitoring with a count over 0 is "monitoring again".
    [[nodiscard]] int timesLost() const { return m_timesLost; }
    [[nodiscard]] const RobotState &state() const { return *m_state; }
    [[nodiscard]] session::LinkStatistics statistics() const;
    [[nodiscard]] Poller &poller() { return *m_poller; }
    /// What is said under HOLD now.
    [[nodiscard]] const HoldState &holdState() const { return m_holdState; }
    /// What holdState() is made from now.
    [[nodiscard]] HoldFacts holdFacts() const;

    /// The file port: lists and saves for whoever asks; what changes files goes through Orders::begin() first. nullptr
    /// while there is no link, and another one whenever the link state changes; transfers under way end silently with
    /// it, as Orders::linkDropped() tells.
    [[nodiscard]] session::FileSession *files() const;

    /// The variables of this controller are numbered so from now on. What was read is forgotten, and an open link
    /// begins anew.
    void setNumbering(protocol::Numbering numbering, const QDateTime &verified, const QString &software);

    /// How closely it is followed from now on.
    void setPace(Pace pace);

    /// Begins checking. Nothing but reads is sent, now and whenever the link comes back.
    void open();
    /// Ends the link and forgets what was read.
    void close();

Q_SIGNALS:
    void linkStateChanged();
    void troubleChanged();
    /// Twice a second while the link is open.
    void statisticsChanged();
    /// An order to hold was given, or came to its end. See HoldFacts::order.
    void holdOrderChanged();
    void holdStateChanged();

private:
    friend class Orders;
    struct Link;

    /// For Orders; nullptr while there is no link. It may be another one whenever the link state changes.
    [[nodiscard]] session::Session *session() const;
    /// For Orders: HOLD on, at once and ahead of everything, see StopOrder. Nobody is told yet. Sends nothing without a
    /// link, or while the host's name has no address yet.
    void sendHold();
    /// Says that HOLD was sent, or that it could not be; nothing while Disconnected.
    void tellHold();

    void resolve();
    void openLink(const QHostAddress &address);
    void dropLink();
    void watch();
    void onFinished(const TopicRange &range, const std::optional<values::Error> &error);
    void readAlarmsOnEdge();
    void onStatusAnswered();
    void setLinkState(LinkState state);
    void setTrouble(const std::optional<values::Error> &trouble);
    void endHold(StopOrder::Outcome outcome, const std::optional<values::Error> &refusal);
    void setHoldOrder(const std::optional<HoldOrder> &order);
    void noteRelease();
    void forgetHold();
    void updateHold();

    settings::Profile m_profile;
    RobotState *m_state;
    Poller *m_poller;
    std::unique_ptr<Link> m_link;
    LinkState m_linkState = LinkState::Disconnected;
    QDateTime m_linkStateSince;
    bool m_hadAlarm = false; ///< An alarm or an error, in the last status.
    Time m_lastStatus {}; ///< When the status was last answered.
    bool m_isIdentified = false; ///< The system information was answered.
    std::optional<values::Error> m_trouble;
    int m_timesLost = 0;
    QPointer<StopOrder> m_stop; ///< HOLD, while it is under way.
    std::optional<HoldOrder> m_holdOrder;
    bool m_wasHeld = false; ///< By command, in the last status.
    std::optional<Time> m_releasedAt;
    HoldState m_holdState;
    QTimer m_watch;
    QTimer m_statisticsTimer;
};

} // namespace robot
