// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "station/station.h"
#include <map>
#include <vector>

namespace station {

/// A controller that somebody may want to see: one of the settings, or one that is open.
struct RosterEntry {
    settings::Profile profile;
    std::shared_ptr<Station> station; ///< nullptr while it is not open.
};

/// The stations of this program. Each lives for itself: one that is silent, slow or closed costs the others nothing.
/// One of them is armed at most. What is nobody's business but to be watched is read once a second; see
/// Station::controller.
class Fleet : public QObject
{
    Q_OBJECT

public:
    /// What is shared must outlive the fleet.
    explicit Fleet(Shared shared, QObject *parent = nullptr);
    ~Fleet() override;

    [[nodiscard]] const Shared &shared() const { return m_shared; }
    /// In the order in which they came.
    [[nodiscard]] QList<std::shared_ptr<Station>> stations() const;
    /// nullptr if there is none of this id.
    [[nodiscard]] std::shared_ptr<Station> find(const QUuid &id) const;
    /// Every controller of the settings in the order of their names, then the stations that are not among them.
    [[nodiscard]] QList<RosterEntry> roster() const;
    /// nullptr while nothing is armed.
    [[nodiscard]] std::shared_ptr<Station> armed() const;

    /// The station of this profile, without connecting. The same controller is never there twice: a station of the same
    /// id is given back, or replaced if its profile was changed. A profile without id gets one that is the same for the
    /// same name and address. A profile without host has a station of its own that belongs to the caller alone.
    std::shared_ptr<Station> add(const settings::Profile &profile);
    /// Begins checking too, unless the link is open.
    std::shared_ptr<Station> open(const settings::Profile &profile);
    /// Ends the link and lets go of the station. Whoever still shows it must let go of it too.
    void close(const QUuid &id);

    /// Orders HOLD at every station that is open, in the order of stations(); asks nothing and waits for nobody.
    void holdAll();
    /// What came of the last holdAll(), by station: nullopt while it is under way.
    [[nodiscard]] const std::map<QUuid, std::optional<journal::Outcome>> &holdOutcomes() const { return m_holds; }
    /// What would be lost if the program ended now, in whole sentences with the controllers' names.
    [[nodiscard]] QStringList unfinished() const;

Q_SIGNALS:
    void added(const std::shared_ptr<station::Station> &station);
    /// It is no longer among stations().
    void removed(const QUuid &id);
    /// holdOutcomes() knows more.
    void holdTold();

private:
    struct Member {
        std::shared_ptr<Station> station;
        robot::Poller::Interest interest; ///< What the fleet shows of each.
    };

    void onRecorded(const QUuid &id, const journal::OrderRecord &record);
    [[nodiscard]] std::vector<Member>::const_iterator place(const QUuid &id) const;

    Shared m_shared;
    std::vector<Member> m_members;
    std::map<QUuid, std::optional<journal::Outcome>> m_holds;
};

} // namespace station
