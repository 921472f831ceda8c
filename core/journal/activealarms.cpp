// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "journal/activealarms.h"

#include <algorithm>

using values::AlarmWithTexts;

namespace journal {

namespace {

bool isActive(AlarmState state) { return state == AlarmState::Unacknowledged || state == AlarmState::Acknowledged; }

AlarmState cleared(AlarmState state)
{
    return state == AlarmState::Unacknowledged ? AlarmState::ClearedUnacknowledged : AlarmState::Cleared;
}

AlarmState acknowledged(AlarmState state) { return isActive(state) ? AlarmState::Acknowledged : AlarmState::Cleared; }

auto findAlarm(auto &sightings, const AlarmWithTexts &alarm)
{
    return std::ranges::find_if(sightings, [&](const Sighting &one) { return isSameAlarm(one.alarm, alarm); });
}

} // namespace

bool isSameAlarm(const AlarmWithTexts &a, const AlarmWithTexts &b)
{
    return a.alarm.code == b.alarm.code && a.alarm.data == b.alarm.data;
}

void ActiveAlarms::restore(const QList<Sighting> &kept)
{
    for (const Sighting &old : kept) {
        Entry *present = find(old.alarm);
        if (!present && old.state == AlarmState::Cleared) {
            remember(old);
        } else if (!present) {
            m_entries.append({old, false, 0});
        } else {
            Sighting &sighting = present->sighting;
            const bool isOneOccurrence = sighting.alarm.alarm.time == old.alarm.alarm.time && isActive(old.state);
            sighting.firstSeen = std::min(sighting.firstSeen, old.firstSeen);
            sighting.count += old.count - (isOneOccurrence ? 1 : 0);
            if (isOneOccurrence && sighting.state == AlarmState::Unacknowledged)
                sighting.state = old.state;
        }
    }
    tidy();
}

ActiveAlarms::Changes ActiveAlarms::take(const QList<AlarmWithTexts> &slotValues, const QDateTime &now)
{
    Changes changes;
    for (Entry &entry : m_entries)
        entry.isInSlot = false;
    for (auto slot = slotValues.crbegin(); slot != slotValues.crend();
         ++slot) { // the newest one comes last, to the top
        const auto isNewer = [&](const AlarmWithTexts &other) { return isSameAlarm(other, *slot); };
        if (!slot->alarm.isEmpty() && std::none_of(slot + 1, slotValues.crend(), isNewer))
            see(*slot, now, changes);
    }
    const auto empty = std::ranges::count_if(slotValues, [](const AlarmWithTexts &one) { return one.alarm.isEmpty(); });
    for (Entry &entry : m_entries) {
        if (!entry.isInSlot && isActive(entry.sighting.state) && empty > 0)
            miss(entry, empty == slotValues.size(), changes);
    }
    tidy();
    return changes;
}

ActiveAlarms::Changes ActiveAlarms::acknowledge(const QList<AlarmWithTexts> &alarms)
{
    Changes changes;
    for (const AlarmWithTexts &alarm : alarms) {
        Entry *entry = find(alarm);
        if (!entry || entry->sighting.state == AlarmState::Acknowledged)
            continue;
        entry->sighting.state = acknowledged(entry->sighting.state);
        changes.toKeep.append(entry->sighting);
    }
    tidy();
    return changes;
}

ActiveAlarms::Entry *ActiveAlarms::find(const AlarmWithTexts &alarm)
{
    const auto found =
        std::ranges::find_if(m_entries, [&](const Entry &entry) { return isSameAlarm(entry.sighting.alarm, alarm); });
    return found == m_entries.end() ? nullptr : &*found;
}

void ActiveAlarms::see(const AlarmWithTexts &alarm, const QDateTime &now, Changes &changes)
{
    if (Entry *entry = find(alarm)) {
        Sighting &sighting = entry->sighting;
        entry->isInSlot = true;
        entry->misses = 0;
        if (isActive(sighting.state) && sighting.alarm.alarm.time == alarm.alarm.time) {
            sighting.lastSeen = now;
            sighting.alarm = alarm; // the texts may have come later
            return;
        }
        const Sighting again = sighting;
        m_entries.removeAt(entry - m_entries.data());
        return come(again, alarm, now, changes);
    }
    const auto past = findAlarm(m_past, alarm);
    if (past == m_past.end())
        return come({m_controller, alarm, now, now, 0, {}}, alarm, now, changes);
    const Sighting again = *past;
    m_past.erase(past);
    come(again, alarm, now, changes);
}

void ActiveAlarms::come(Sighting sighting, const AlarmWithTexts &alarm, const QDateTime &now, Changes &changes)
{
    sighting.alarm = alarm;
    sighting.lastSeen = now;
    ++sighting.count;
    sighting.state = AlarmState::Unacknowledged;
    m_entries.prepend({sighting, true, 0});
    changes.came.append(sighting);
    changes.toKeep.append(sighting);
}

void ActiveAlarms::miss(Entry &entry, bool isCertain, Changes &changes)
{
    if (++entry.misses < 2 && !isCertain)
        return;
    entry.sighting.state = cleared(entry.sighting.state);
    changes.toKeep.append(entry.sighting);
}

void ActiveAlarms::remember(const Sighting &sighting)
{
    m_past.append(sighting);
    if (m_past.size() > mostRemembered)
        m_past.removeFirst();
}

/// Cleared alarms become the past; a list that grew too long loses its oldest.
void ActiveAlarms::tidy()
{
    const auto done = std::stable_partition(m_entries.begin(), m_entries.end(),
        [](const Entry &entry) { return entry.sighting.state != AlarmState::Cleared; });
    std::for_each(done, m_entries.end(), [this](const Entry &entry) { remember(entry.sighting); });
    m_entries.erase(done, m_entries.end());
    while (m_entries.size() > mostListed) {
        const auto old = std::find_if(
            m_entries.rbegin(), m_entries.rend(), [](const Entry &entry) { return !isActive(entry.sighting.state); });
        const auto leaving = old == m_entries.rend() ? m_entries.end() - 1 : old.base() - 1;
        remember(leaving->sighting);
        m_entries.erase(leaving);
    }
}

} // namespace journal
