// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/poller.h"
#include "robot/robotstate.h"
#include "robot/stoporder.h"
#include "session/statistics.h"
#include "settings/profile.h"
#include <QTimer>
#include <memory>

class QHostAddress;

namespace session {
class FileSession;
class Session;
} // namespace session

namespace robot {

/// Where the link to a controller stands. *Connected* means that status and system information were answered.
enum class LinkState {
    Disconnected, ///< Nobody asked for a link.
    Checking, ///< Asking; no valid reply to system information and status yet. Goes on until told to stop.
    Monitoring, ///< Values are live.
    Lost, ///< Was monitoring, then the status stayed away for three time-outs. Reading resumes by itself.
};

/// How far an order to hold has come. It ends in Confirmed, Refused or Unconfirmed.
enum class HoldProgress { Idle, Sent, Confirmed, Refused, Unconfirmed };

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
    [[nodiscard]] HoldProgress holdProgress() const { return m_holdProgress; }
    /// The refusal, while holdProgress() is Refused.
    [[nodiscard]] const std::optional<values::Error> &holdRefusal() const { return m_holdRefusal; }

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

    /// HOLD on, at once and ahead of everything: see StopOrder. Does nothing while Disconnected; Unconfirmed at
    /// once while the host's name has no address yet, so that nothing can be sent.
    void hold();

Q_SIGNALS:
    void linkStateChanged();
    void troubleChanged();
    /// Twice a second while the link is open.
    void statisticsChanged();
    void holdProgressChanged();

private:
    friend class Orders;
    struct Link;

    /// For Orders; nullptr while there is no link. It may be another one whenever the link state changes.
    [[nodiscard]] session::Session *session() const;

    void resolve();
    void openLink(const QHostAddress &address);
    void dropLink();
    void watch();
    void onFinished(const TopicRange &range, const std::optional<values::Error> &error);
    void readAlarmsOnEdge();
    void onStatusAnswered();
    void setLinkState(LinkState state);
    void setTrouble(const std::optional<values::Error> &trouble);
    void setHold(HoldProgress progress, const std::optional<values::Error> &refusal = {});

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
    HoldProgress m_holdProgress = HoldProgress::Idle;
    std::optional<values::Error> m_holdRefusal;
    QTimer m_watch;
    QTimer m_statisticsTimer;
};

} // namespace robot
