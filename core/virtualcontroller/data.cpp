// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
// Reading and writing cells, one at a time or many: reference §4.
#include "virtualcontroller/cells.h"

#include <QtEndian>

using protocol::Request;
using protocol::Service;

namespace virtualcontroller {

namespace {

constexpr qsizetype countSize = 4;
constexpr qsizetype maxDataSize = 474; ///< Of a plural command (reference §4.5).

bool isRead(Service service)
{
    return service == Service::GetSingle || service == Service::GetAll || service == Service::ReadPlural;
}

bool isSingleElement(Service service) { return service == Service::GetSingle || service == Service::SetSingle; }

/// The element of a request, 0 for all.
int elementOf(const Request &request) { return isSingleElement(request.service) ? request.attribute : 0; }

/// A write on a copy: what the real one would end in, without changing anything.
quint16 storeFault(const CellKind &kind, const Request &request, Memory memory)
{
    const int number = kind.number(request.instance, memory);
    return kind.store(memory, number, request.payload, elementOf(request));
}

quint16 checkSingle(const Request &request, const Memory &memory)
{
    const CellKind &kind = *findCellKind(request.command);
    const int number = kind.number(request.instance, memory);
    if (!kind.exists(memory, number))
        return InstanceFault;
    if (isRead(request.service))
        return checkEmpty(request, memory);
    if (const quint16 refusal = kind.writeRefusal(memory, number))
        return refusal;
    return storeFault(kind, request, memory);
}

Answer executeSingle(const Request &request, Memory &memory)
{
    const CellKind &kind = *findCellKind(request.command);
    const int number = kind.number(request.instance, memory);
    if (isRead(request.service))
        return kind.load(memory, number, elementOf(request));
    kind.store(memory, number, request.payload, elementOf(request));
    return QByteArray {};
}

/// The count that a plural request begins with; the payload holds it.
quint32 countOf(const Request &request) { return qFromLittleEndian<quint32>(request.payload.data()); }

quint16 checkCount(const CellKind &kind, const Request &request)
{
    if (request.payload.size() < countSize)
        return SizeFault;
    const quint32 count = countOf(request);
    if (count == 0 || (kind.isEven && count % 2 != 0))
        return SizeFault;
    if (count > maxDataSize / kind.size)
        return ReplyTooLarge;
    const qsizetype data = isRead(request.service) ? 0 : count * kind.size;
    return request.payload.size() == countSize + data ? 0 : SizeFault;
}

quint16 checkPlural(const Request &request, const Memory &memory)
{
    const CellKind &kind = *findCellKind(request.command);
    if (const quint16 fault = checkCount(kind, request))
        return fault;
    const int first = kind.number(request.instance, memory);
    for (int number = first; number < first + int(countOf(request)); ++number) {
        if (!kind.exists(memory, number))
            return RangeFault;
        const quint16 refusal = isRead(request.service) ? 0 : kind.writeRefusal(memory, number);
        if (refusal)
            return refusal;
    }
    return 0;
}

Answer readPlural(const CellKind &kind, const Request &request, const Memory &memory)
{
    QByteArray payload = request.payload.first(countSize);
    const int first = kind.number(request.instance, memory);
    for (int number = first; number < first + int(countOf(request)); ++number) {
        const Answer item = kind.load(memory, number, 0);
        if (!item)
            return item;
        payload += *item;
    }
    return payload;
}

/// All items or none.
Answer writePlural(const CellKind &kind, const Request &request, Memory &memory)
{
    Memory changed = memory;
    const int first = kind.number(request.instance, memory);
    const QByteArrayView data = QByteArrayView {request.payload}.sliced(countSize);
    for (quint32 item = 0; item < countOf(request); ++item) {
        const auto bytes = data.sliced(item * kind.size, kind.size);
        if (const quint16 fault = kind.store(changed, first + int(item), bytes, 0))
            return refused(fault);
    }
    memory = std::move(changed);
    return request.payload.first(countSize);
}

Answer executePlural(const Request &request, Memory &memory)
{
    const CellKind &kind = *findCellKind(request.command);
    return isRead(request.service) ? readPlural(kind, request, memory) : writePlural(kind, request, memory);
}

} // namespace

std::span<const Handler> dataHandlers()
{
    static constexpr std::array singles {0x78, 0x79, 0x7A, 0x7B, 0x7C, 0x7D, 0x7E, 0x7F, 0x80, 0x81, 0x8C};
    static constexpr std::array plurals {0x300, 0x301, 0x302, 0x303, 0x304, 0x305, 0x306, 0x307, 0x308, 0x309, 0x30C};
    static const auto rows = [] {
        std::vector<Handler> handlers;
        for (const int command : singles)
            handlers.push_back({quint16(command), checkSingle, executeSingle});
        for (const int command : plurals)
            handlers.push_back({quint16(command), checkPlural, executePlural});
        return handlers;
    }();
    return rows;
}

} // namespace virtualcontroller
