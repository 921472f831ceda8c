// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/fileblocks.h"
#include "session/policy.h"
#include "session/retransmission.h"
#include <optional>

namespace session {

/// How long and how often the file port is asked. What a transfer may bring: protocol/filelimits.h.
struct FilePolicy {
    Milliseconds timeout {3000}; ///< For one step: a block and its acknowledgement, one repeat included.
    Milliseconds repeatFloor {100}; ///< The earliest repeat; a controller may take its time to register a job.
    Milliseconds busyLeast {50}; ///< A list or a save answered "busy" is asked again after a random wait between these.
    Milliseconds busyMost {200};
    int busyRepeats = 5;
    /// A controller that sends a byte now and then answers every step and gets nowhere: a file that does not end must
    /// have grown by `leastProgress` bytes in each `progressPeriod`. A block of 400 bytes in 3 s is 8000 in a minute.
    Milliseconds progressPeriod {60000};
    qsizetype leastProgress = 1024;
    /// How long a second copy of an answer may still come: an id rests for that long, so about 120 transfers a second
    /// can begin. A block of one file must not be taken for that of another.
    Milliseconds idLinger {2000};
    qsizetype blockSize = protocol::blockSize; ///< Of a load, 1 to 479.
};

/// One file service from its request to its end: stop and wait, block by block (reference §7). No socket and no clock;
/// `now` is a parameter.
///
/// A block or an acknowledgement that got no answer is repeated once, by its number, which tells the controller that it
/// has it already; then the transfer fails. So is the request of a save or a list. The request of a load and a delete
/// are sent once.
class Transfer
{
public:
    /// What to do next: send `packet` if it is not empty, and then, if `end` is there, let go of the transfer.
    struct Step {
        QByteArray packet = {};
        std::optional<values::Result<QByteArray>> end = {}; ///< What was saved or listed; empty for the others.
    };

    /// `upload` is what a load sends; it is not empty there. `retransmission` learns from the transfer.
    Transfer(protocol::Request request, quint8 id, const FilePolicy &policy, Retransmission &retransmission,
        QByteArray upload = {});

    [[nodiscard]] QByteArray start(Time now);
    [[nodiscard]] Step receive(const protocol::Reply &reply, Time now);
    [[nodiscard]] Step expire(Time now);
    /// When expire() is due.
    [[nodiscard]] Time deadline() const { return m_nextTry; }

    /// Ends the transfer at the next block border, which is at once unless the last block of a load is under way.
    [[nodiscard]] Step cancel();

    [[nodiscard]] qint64 bytesDone() const;
    /// Of a load; a save does not tell its size beforehand.
    [[nodiscard]] qint64 bytesTotal() const { return m_upload.size(); }
    [[nodiscard]] quint8 id() const { return m_id; }
    /// Some packet was sent twice, so that an answer may come twice too.
    [[nodiscard]] bool wasRepeated() const { return m_wasRepeated; }
    /// The acknowledgement of the last block of a finished save or list. It may have been lost, then the controller
    /// asks again.
    [[nodiscard]] const QByteArray &lastPacket() const { return m_packet; }

private:
    [[nodiscard]] bool isLoad() const { return m_request.service == protocol::Service::LoadFile; }
    [[nodiscard]] bool isLastBlockOut() const { return m_block > 0 && m_block == m_blockCount; }
    [[nodiscard]] QByteArray packetOfBlock(quint32 index) const;
    Step receiveAcknowledgement(const protocol::Reply &reply, Time now);
    Step receiveBlock(const protocol::Reply &reply, Time now);
    Step send(const QByteArray &packet, Time now);
    void measure(Time now);
    values::Error silence() const;
    [[nodiscard]] bool mayRepeat() const;
    [[nodiscard]] bool hasStalled(Time now);

    protocol::Request m_request;
    quint8 m_id;
    FilePolicy m_policy;
    Retransmission &m_retransmission;
    QByteArray m_upload;
    quint32 m_block = 0; ///< The block of a load that waits for its acknowledgement; 0 for the request.
    quint32 m_blockCount = 0;
    protocol::BlockCollector m_collector;
    QByteArray m_packet; ///< The last one sent.
    Time m_sentAt {};
    Time m_nextTry {};
    Time m_markedAt {}; ///< When the present progress period began,
    qsizetype m_markedSize = 0; ///< and how much had come by then.
    int m_tries = 0;
    bool m_wasRepeated = false;
};

} // namespace session
