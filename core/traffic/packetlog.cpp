// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "traffic/packetlog.h"

#include <algorithm>
#include <cstring>

using protocol::Division;

namespace traffic {

namespace {

constexpr std::size_t longest = 2048;
constexpr std::size_t firstEntries = 1024;
constexpr std::size_t firstBytes = 64 * 1024;
constexpr qsizetype idOffset = 11; // reference §1.1

std::size_t slot(Division division, QByteArrayView bytes)
{
    return std::size_t(division == Division::File ? 256 : 0) + std::size_t(quint8(bytes[idOffset]));
}

} // namespace

PacketLog::PacketLog(const Limits &limits)
    : m_limits {std::max<std::size_t>(limits.packets, 1), std::max(limits.bytes, 2 * longest)},
      m_entries(std::min(firstEntries, m_limits.packets)),
      m_bytes(std::min(firstBytes, m_limits.bytes))
{
}

quint64 PacketLog::note(const Note &note, QByteArrayView bytes)
{
    bytes = bytes.first(std::min(bytes.size(), qsizetype(longest)));
    const auto size = std::size_t(bytes.size());
    Note known = note;
    const quint64 partner = partnerOf(known, bytes);
    makeRoom(size);
    const std::size_t at = m_bytesEnd % m_bytes.size();
    std::memcpy(m_bytes.data() + at, bytes.data(), size);
    entry(m_end) = {known, partner, m_bytesEnd, quint16(size)};
    m_bytesEnd += size;
    if (known.passage == Passage::Sent && known.fate != Fate::Repeat && bytes.size() >= protocol::headerSize)
        m_lastSent[slot(known.division, bytes)] = m_end;
    return m_end++;
}

/// A packet that is sent byte for byte once more is a repeat; what comes in with an id answers what left with it last.
quint64 PacketLog::partnerOf(Note &note, QByteArrayView bytes)
{
    if (bytes.size() < protocol::headerSize || isDropped(note.fate))
        return 0;
    const quint64 last = m_lastSent[slot(note.division, bytes)];
    if (!holds(last))
        return 0;
    if (note.passage == Passage::Received)
        return last;
    const bool isSame = bytesOf(entry(last)) == bytes;
    if (isSame && note.fate == Fate::Used)
        note.fate = Fate::Repeat;
    return isSame ? last : 0;
}

/// Bytes of one packet lie side by side: where the end of the memory is too near, the rest of it is passed over.
void PacketLog::makeRoom(std::size_t size)
{
    growEntries();
    while (m_bytes.size() < m_limits.bytes && m_bytesEnd + size > m_bytes.size())
        m_bytes.resize(std::min(m_bytes.size() * 2, m_limits.bytes)); // nothing was overwritten yet: all stays in place
    const std::size_t rest = m_bytes.size() - m_bytesEnd % m_bytes.size();
    if (rest < size)
        m_bytesEnd += rest;
    while (m_first < m_end && entry(m_first).begin + m_bytes.size() < m_bytesEnd + size)
        ++m_first;
    if (m_end - m_first == m_entries.size())
        ++m_first;
}

void PacketLog::growEntries()
{
    if (m_end - m_first < m_entries.size() || m_entries.size() == m_limits.packets)
        return;
    std::vector<Entry> grown(std::min(m_entries.size() * 2, m_limits.packets));
    for (quint64 number = m_first; number < m_end; ++number)
        grown[number % grown.size()] = entry(number);
    m_entries = std::move(grown);
}

QByteArrayView PacketLog::bytesOf(const Entry &entry) const
{
    return {m_bytes.data() + entry.begin % m_bytes.size(), qsizetype(entry.size)};
}

void PacketLog::setFate(quint64 number, Fate fate)
{
    if (!holds(number))
        return;
    Entry &found = entry(number);
    found.note.fate = fate;
    if (isDropped(fate) && fate != Fate::Duplicate)
        found.partner = 0;
}

std::optional<Packet> PacketLog::packet(quint64 number) const
{
    if (!holds(number))
        return std::nullopt;
    const Entry &found = entry(number);
    const Note &note = found.note;
    return Packet {number, note.at, note.passage, note.division, note.fate, note.own, note.other,
        holds(found.partner) ? found.partner : 0, bytesOf(found).toByteArray()};
}

QList<Packet> PacketLog::packets() const
{
    QList<Packet> all;
    all.reserve(qsizetype(size()));
    for (quint64 number = m_first; number < m_end; ++number)
        all << *packet(number);
    return all;
}

void PacketLog::clear() { m_first = m_end; }

} // namespace traffic
