// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/fileblocks.h"

#include "protocol/filelimits.h"
#include <algorithm>
#include <array>

using values::ErrorKind;
using values::FileName;
using values::Result;

namespace protocol {

namespace {

constexpr std::array services {
    FileService {Service::DeleteFile, "delete file", Effect::Writes},
    FileService {Service::LoadFile, "load file", Effect::Writes},
    FileService {Service::SaveFile, "save file", Effect::Reads},
    FileService {Service::ListFiles, "list files", Effect::Reads},
};

Request fileRequest(Service service, QByteArrayView payload) { return {0, 0, 0, service, payload.toByteArray()}; }

} // namespace

qsizetype sizeLimit(const Request &request)
{
    if (request.service == Service::ListFiles)
        return listLimit;
    const QByteArray name = request.payload.toUpper();
    return name.endsWith(".JBI") || name.endsWith(".JBR") ? jobLimit : fileLimit;
}

std::span<const FileService> fileServices() { return services; }

const FileService *findFileService(Service service)
{
    const auto found = std::ranges::find(services, service, &FileService::service);
    return found == services.end() ? nullptr : &*found;
}

Request deleteFile(const FileName &name) { return fileRequest(Service::DeleteFile, name.bytes()); }
Request loadFile(const FileName &name) { return fileRequest(Service::LoadFile, name.bytes()); }
Request saveFile(const FileName &name) { return fileRequest(Service::SaveFile, name.bytes()); }
Request listFiles(QByteArrayView pattern) { return fileRequest(Service::ListFiles, pattern); }

QByteArray encodeFileRequest(const Request &request, quint8 id)
{
    return encode(request, Framing {Division::File, false, id, 0});
}

QByteArray encodeAcknowledgement(Service service, quint8 id, quint32 block)
{
    return encode(fileRequest(service, {}), Framing {Division::File, true, id, block});
}

quint32 blockCount(QByteArrayView content, qsizetype size) { return quint32((content.size() + size - 1) / size); }

QByteArray encodeLoadBlock(QByteArrayView content, quint32 index, quint8 id, qsizetype size)
{
    const qsizetype start = qsizetype(index - 1) * size;
    Q_ASSERT(index >= 1 && start < content.size());
    const auto data = content.sliced(start, std::min(size, content.size() - start));
    const Framing framing {Division::File, true, id, blockNumber(index, blockCount(content, size))};
    return encode(fileRequest(Service::LoadFile, data), framing);
}

Result<void> checkGoAhead(const Reply &reply)
{
    if (reply.isRefusal())
        return tl::unexpected(reply.refusal());
    if (reply.framing.block != 0 && reply.framing.block != lastBlock)
        return values::failure(ErrorKind::Malformed, QStringLiteral("go-ahead with a block number"));
    return {};
}

Result<void> checkAcknowledgement(const Reply &reply, quint32 block)
{
    if (reply.isRefusal())
        return tl::unexpected(reply.refusal());
    if (reply.framing.block != block)
        return values::failure(ErrorKind::Malformed, QStringLiteral("acknowledges another block"));
    return {};
}

Result<BlockCollector::Step> BlockCollector::take(const Reply &reply)
{
    if (reply.isRefusal())
        return tl::unexpected(reply.refusal());
    const bool isLast = reply.framing.block & lastBlock;
    quint32 number = reply.framing.block & ~lastBlock;
    if (number == 0 && isLast)
        number = 1; // a transfer of one block may also be marked so (reference §1.4)
    if (number == m_last && number > 0)
        return Step::Repeated;
    if (m_isComplete || number != m_last + 1)
        return values::failure(ErrorKind::Malformed, QStringLiteral("block %1 is out of turn").arg(number));
    if (reply.payload.isEmpty() && !isLast)
        return broken(QStringLiteral("block %1 is empty and not the last one").arg(number));
    if (m_content.size() + reply.payload.size() > m_limit)
        return broken(QStringLiteral("more than %1 bytes").arg(m_limit));
    m_content += reply.payload;
    m_last = number;
    m_isComplete = isLast;
    return isLast ? Step::Complete : Step::Next;
}

tl::unexpected<values::Error> BlockCollector::broken(const QString &why)
{
    m_fault = values::Error {ErrorKind::Malformed, 0, 0, why};
    return tl::unexpected(*m_fault);
}

FileList parseFileList(const QByteArray &content)
{
    FileList list;
    for (qsizetype start = 0; start < content.size();) {
        const qsizetype found = content.indexOf('\n', start);
        const qsizetype end = found < 0 ? content.size() : found;
        QByteArray line = content.mid(start, end - start);
        start = end + 1;
        if (line.endsWith('\r'))
            line.chop(1);
        if (line.isEmpty())
            continue;
        if (const auto name = FileName::create(line))
            list.names += *name;
        else
            list.rejected += line;
    }
    return list;
}

} // namespace protocol
