// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "traffic/packet.h"
#include <array>
#include <optional>
#include <vector>

namespace traffic {

/// The last packets of one controller, across reconnects. It is always on: noting a packet copies its bytes into memory
/// that is reused for ever, and nothing is taken apart before somebody looks.
class PacketLog
{
public:
    /// Whichever is reached first makes the oldest packets go.
    struct Limits {
        std::size_t packets = 20'000;
        std::size_t bytes = 4 * 1024 * 1024; ///< Of packets; 40,000 reads and their answers, or 8,000 blocks of files.
    };

    explicit PacketLog(const Limits &limits);
    PacketLog() : PacketLog {Limits {}} { }

    /// What is known of a packet while it passes.
    struct Note {
        WallTime at;
        Passage passage;
        protocol::Division division;
        Endpoint own;
        Endpoint other;
        Fate fate = Fate::Used;
    };

    /// Keeps a copy of `bytes` and returns the packet's number. Bytes after the first 2048 are cut off.
    quint64 note(const Note &note, QByteArrayView bytes);
    /// What became of a packet was found out later; nothing happens if the ring has lost it.
    void setFate(quint64 number, Fate fate);

    /// Numbers of the oldest packet that is still here, and of the one after the newest.
    [[nodiscard]] quint64 first() const { return m_first; }
    [[nodiscard]] quint64 end() const { return m_end; }
    [[nodiscard]] std::size_t size() const { return std::size_t(m_end - m_first); }
    /// nullopt if it is not here any more, or not yet.
    [[nodiscard]] std::optional<Packet> packet(quint64 number) const;
    /// All that are here, the oldest first.
    [[nodiscard]] QList<Packet> packets() const;
    void clear();

private:
    struct Entry {
        Note note;
        quint64 partner;
        quint64 begin; ///< In the endless row of bytes of which m_bytes holds the end.
        quint16 size;
    };

    [[nodiscard]] bool holds(quint64 number) const { return number >= m_first && number < m_end; }
    [[nodiscard]] const Entry &entry(quint64 number) const { return m_entries[number % m_entries.size()]; }
    [[nodiscard]] Entry &entry(quint64 number) { return m_entries[number % m_entries.size()]; }
    [[nodiscard]] QByteArrayView bytesOf(const Entry &entry) const;
    [[nodiscard]] quint64 partnerOf(Note &note, QByteArrayView bytes);
    void makeRoom(std::size_t size);
    void growEntries();

    Limits m_limits;
    std::vector<Entry> m_entries; ///< Grows to the limit, then goes round.
    std::vector<char> m_bytes; ///< Likewise.
    quint64 m_first = 1;
    quint64 m_end = 1;
    quint64 m_bytesEnd = 0;
    std::array<quint64, 512> m_lastSent {}; ///< By division and id.
};

} // namespace traffic
