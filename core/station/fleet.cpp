// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "station/fleet.h"

#include <algorithm>

namespace station {

namespace {

/// What is known of every station, whatever page is in view.
QList<robot::TopicRange> always()
{
    return {robot::topics::status, robot::topics::masterJob, robot::topics::systemInformation,
        {robot::Kind::Alarm, 1, values::activeAlarmCount}};
}

/// For a controller that is not in the store, such as the demo or one of the command line.
QUuid idOf(const settings::Profile &profile)
{
    static constexpr QUuid space {0x4dd6ab3f, 0x2f5c, 0x4f35, 0x9d, 0x0e, 0x6a, 0x51, 0x3c, 0x0b, 0x77, 0x21};
    return QUuid::createUuidV5(space, QStringLiteral("%1 %2:%3").arg(profile.name, profile.host).arg(profile.port));
}

/// As the store knows it by its name, else by name and address.
void identify(settings::Profile &profile, const settings::ProfileStore &store)
{
    const auto known = store.find(profile.name);
    profile.id = known ? known->id : idOf(profile);
    if (!known)
        return;
    profile.folder = known->folder;
    profile.formerNames = known->formerNames;
}

} // namespace

Fleet::Fleet(Shared shared, QObject *parent) : QObject {parent}, m_shared {shared} { }

Fleet::~Fleet()
{
    for (const Member &member : m_members)
        member.station->controller.close();
}

QList<std::shared_ptr<Station>> Fleet::stations() const
{
    QList<std::shared_ptr<Station>> result;
    for (const Member &member : m_members)
        result << member.station;
    return result;
}

std::vector<Fleet::Member>::const_iterator Fleet::place(const QUuid &id) const
{
    return std::ranges::find(m_members, id, [](const Member &member) { return member.station->id(); });
}

std::shared_ptr<Station> Fleet::find(const QUuid &id) const
{
    const auto found = place(id);
    return found == m_members.end() ? nullptr : found->station;
}

std::shared_ptr<Station> Fleet::armed() const
{
    const auto found =
        std::ranges::find_if(m_members, [](const Member &member) { return member.station->orders.isArmed(); });
    return found == m_members.end() ? nullptr : found->station;
}

std::shared_ptr<Station> Fleet::add(const settings::Profile &profile)
{
    settings::Profile identified = profile;
    if (profile.host.isEmpty())
        return std::make_shared<Station>(profile, m_shared);
    if (identified.id.isNull())
        identify(identified, m_shared.store);
    if (auto known = find(identified.id)) {
        if (known->profile() == identified)
            return known;
        close(identified.id);
    }
    auto station = std::make_shared<Station>(identified, m_shared);
    station->controller.setPace(robot::Pace::Background);
    station->names.follow(station->controller);
    connect(&station->orders, &robot::Orders::recorded, this,
        [this, id = station->id()](const journal::OrderRecord &record) { onRecorded(id, record); });
    m_members.push_back({station, station->controller.poller().want(always())});
    Q_EMIT added(station);
    return station;
}

std::shared_ptr<Station> Fleet::open(const settings::Profile &profile)
{
    auto station = add(profile);
    station->controller.open();
    return station;
}

void Fleet::close(const QUuid &id)
{
    const auto found = place(id);
    if (found == m_members.end())
        return;
    const Member gone = *found;
    m_members.erase(found);
    gone.station->controller.close(); // disarms
    Q_EMIT removed(id);
}

/// First every datagram, then the words.
void Fleet::holdAll()
{
    m_holds.clear();
    for (const Member &member : m_members) {
        if (member.station->isOpen())
            m_holds[member.station->id()] = std::nullopt;
    }
    QList<robot::Orders *> open;
    for (const Member &member : m_members) {
        if (member.station->isOpen())
            open << &member.station->orders;
    }
    robot::Orders::hold(open);
    Q_EMIT holdTold();
}

void Fleet::onRecorded(const QUuid &id, const journal::OrderRecord &record)
{
    const auto asked = m_holds.find(id);
    if (asked == m_holds.end() || asked->second || record.action != QLatin1String(key(robot::Act::Hold)))
        return;
    asked->second = record.outcome;
    Q_EMIT holdTold();
}

QList<RosterEntry> Fleet::roster() const
{
    QList<RosterEntry> result;
    for (const settings::Profile &profile : m_shared.store.profiles())
        result << RosterEntry {profile, nullptr};
    for (const Member &member : m_members) {
        const auto known = std::ranges::find(
            result, member.station->profile().name, [](const RosterEntry &entry) { return entry.profile.name; });
        if (known != result.end())
            *known = {member.station->profile(), member.station};
        else
            result << RosterEntry {member.station->profile(), member.station};
    }
    return result;
}

QStringList Fleet::unfinished() const
{
    QStringList sentences;
    for (const Member &member : m_members) {
        for (const QString &sentence : member.station->unfinished())
            sentences << tr("%1: %2", "controller: sentence").arg(member.station->profile().name, sentence);
    }
    return sentences;
}

} // namespace station
