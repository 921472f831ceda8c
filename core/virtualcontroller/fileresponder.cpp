// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/fileresponder.h"

#include "virtualcontroller/access.h"
#include "virtualcontroller/filestore.h"
#include "virtualcontroller/frames.h"
#include "virtualcontroller/machine.h"

using protocol::ClientPacket;
using protocol::lastBlock;
using protocol::Service;

namespace virtualcontroller {

namespace {

enum Refusal : quint16 {
    UnknownService = 0xA000,
    WrongInstance = 0xA001,
    WrongAttribute = 0xA002,
    TimedOut = 0xE28B,
    Busy = 0xE444,
    NoMemory = 0x4010,
    NoData = 0xE49D,
    ModeChanged = 0xFFFE,
};

using FileAnswer = std::optional<QByteArray>;

bool needsName(Service service) { return service != Service::ListFiles; }

/// Faults of a request by itself, in the order of reference §1.7. A real controller refused to delete a name with a
/// terminator (§12, conflict 51).
quint16 requestFault(const ClientPacket &packet)
{
    if (packet.command != 0)
        return UnknownService;
    if (packet.instance != 0)
        return WrongInstance;
    if (packet.attribute != 0)
        return WrongAttribute;
    switch (packet.service) {
    case Service::DeleteFile:
    case Service::LoadFile:
    case Service::SaveFile:
    case Service::ListFiles: break;
    default: return UnknownService;
    }
    if (packet.framing.block != 0)
        return WrongBlock;
    const bool isBadDelete = packet.service == Service::DeleteFile && packet.payload.endsWith('\0');
    return (needsName(packet.service) && packet.payload.isEmpty()) || isBadDelete ? NoData : 0;
}

bool hasTimedOut(const Transfer &transfer, const Memory &memory)
{
    return memory.now - transfer.heard > memory.settings.transferTimeout;
}

bool isBusy(const Memory &memory, const QByteArray &peer)
{
    const auto &transfer = memory.transfer;
    return transfer && transfer->peer != peer && !transfer->isOver && !hasTimedOut(*transfer, memory);
}

/// The next block of a file on its way to the client, as a reply to `packet`.
QByteArray nextBlock(Transfer &transfer, const ClientPacket &packet, qsizetype blockSize)
{
    const QByteArray part = transfer.data.first(std::min(blockSize, transfer.data.size()));
    transfer.data.remove(0, part.size());
    ++transfer.block;
    if (transfer.data.isEmpty())
        transfer.block |= lastBlock;
    return successReply(packet, transfer.block, part);
}

/// Begins to send what `found` holds, or refuses.
QByteArray beginSending(
    const tl::expected<QByteArray, quint16> &found, Transfer transfer, const ClientPacket &packet, Memory &memory)
{
    if (!found)
        return refusalReply(packet, found.error());
    transfer.data = *found;
    memory.transfer = std::move(transfer);
    return nextBlock(*memory.transfer, packet, memory.settings.blockSize);
}

QByteArray beginLoading(Transfer transfer, const ClientPacket &packet, Memory &memory)
{
    if (const quint16 refusal = filestore::loadRefusal(memory, transfer.name))
        return refusalReply(packet, refusal);
    memory.transfer = std::move(transfer);
    return successReply(packet, 0, {});
}

QByteArray remove(const QByteArray &name, const ClientPacket &packet, Memory &memory)
{
    const quint16 refusal = filestore::remove(memory, name);
    return refusal ? refusalReply(packet, refusal) : successReply(packet, lastBlock, {});
}

/// A request that begins something. The client's own transfer, if there is one, is over by it.
QByteArray begin(const ClientPacket &packet, const QByteArray &peer, Memory &memory)
{
    if (const quint16 fault = requestFault(packet))
        return refusalReply(packet, fault);
    if (const quint16 refusal = fileAccessRefusal(packet.service, memory))
        return refusalReply(packet, refusal);
    if (isBusy(memory, peer))
        return refusalReply(packet, Busy);
    memory.transfer.reset();
    const QByteArray name = packet.payload.toByteArray();
    Transfer transfer {peer, packet.service, packet.framing.id, name};
    transfer.heard = memory.now;
    switch (packet.service) {
    case Service::DeleteFile: return remove(name, packet, memory);
    case Service::LoadFile: return beginLoading(std::move(transfer), packet, memory);
    case Service::ListFiles: return beginSending(filestore::list(memory, name), std::move(transfer), packet, memory);
    default: return beginSending(filestore::save(memory, name), std::move(transfer), packet, memory);
    }
}

/// A block of a file that the client sends.
QByteArray takeBlock(Transfer &transfer, const ClientPacket &packet, Memory &memory)
{
    const quint32 block = packet.framing.block;
    const bool isLast = block & lastBlock;
    const quint32 expected = transfer.block + 1;
    const bool isOnly = block == lastBlock && expected == 1; // reference §1.4 lets it pass
    if ((block & ~lastBlock) != expected && !isOnly)
        return refusalReply(packet, WrongBlock);
    if (packet.payload.isEmpty())
        return refusalReply(packet, NoData);
    if (transfer.data.size() > maxFileSize)
        return refusalReply(packet, NoMemory);
    transfer.data += packet.payload;
    transfer.block = expected;
    transfer.isOver = isLast;
    const quint16 refusal = isLast ? filestore::load(memory, transfer.name, transfer.data) : 0;
    return refusal ? refusalReply(packet, refusal) : successReply(packet, block, {});
}

/// The client's word that a block has come.
FileAnswer takeAcknowledgement(Transfer &transfer, const ClientPacket &packet, const Memory &memory)
{
    if (packet.framing.block != transfer.block)
        return refusalReply(packet, WrongBlock);
    transfer.isOver = transfer.block & lastBlock;
    return transfer.isOver ? FileAnswer {} : nextBlock(transfer, packet, memory.settings.blockSize);
}

/// What ends a transfer from outside; 0 if nothing does.
quint16 transferFault(const Transfer &transfer, const Memory &memory)
{
    if (hasTimedOut(transfer, memory))
        return TimedOut;
    return transfer.isCutOff ? ModeChanged : 0;
}

/// A packet within a transfer.
FileAnswer goOn(QByteArrayView datagram, const ClientPacket &packet, const QByteArray &peer, Memory &memory)
{
    auto &transfer = memory.transfer;
    const bool belongs =
        transfer && transfer->peer == peer && transfer->id == packet.framing.id && transfer->service == packet.service;
    if (!belongs)
        return refusalReply(packet, WrongAck);
    if (const quint16 fault = transferFault(*transfer, memory)) {
        transfer.reset();
        return refusalReply(packet, fault);
    }
    transfer->heard = memory.now;
    if (datagram == transfer->lastPacket)
        return transfer->lastReply.isEmpty() ? FileAnswer {} : transfer->lastReply;
    if (transfer->isOver)
        return refusalReply(packet, WrongAck);
    const quint32 before = transfer->block;
    FileAnswer answer = packet.service == Service::LoadFile ? takeBlock(*transfer, packet, memory)
                                                            : takeAcknowledgement(*transfer, packet, memory);
    if (transfer->block != before || transfer->isOver) {
        transfer->lastPacket = datagram.toByteArray();
        transfer->lastReply = answer.value_or(QByteArray {});
    }
    return answer;
}

} // namespace

std::optional<QByteArray> respondFile(QByteArrayView datagram, const QByteArray &peer, Memory &memory, Time now)
{
    advanceTo(memory, now);
    const FrameVerdict verdict = judgeFrame(datagram, protocol::Division::File, memory.settings.answersWrongIdentifier);
    if (verdict.isDropped)
        return std::nullopt;
    ClientPacket packet = protocol::peekClientPacket(datagram);
    packet.framing.division = protocol::Division::File; // a refusal of a wrong one is a good frame
    if (verdict.code)
        return refusalReply(packet, verdict.code);
    return packet.framing.ack ? goOn(datagram, packet, peer, memory) : begin(packet, peer, memory);
}

} // namespace virtualcontroller
