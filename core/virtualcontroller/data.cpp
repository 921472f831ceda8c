// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
// Reading and writing cells, one at a time or many: reference §4.
#include "protocol/plural.h"
#include "virtualcontroller/cells.h"

using protocol::PayloadKind;
using protocol::PluralRule;
using protocol::Request;
using protocol::Service;

namespace virtualcontroller {

namespace {

bool isRead(const Request &request)
{
    const PayloadKind kind = protocol::requestPayload(request.service);
    return kind == PayloadKind::Empty || kind == PayloadKind::Count;
}

/// The element of a request, 0 for all.
int elementOf(const Request &request)
{
    const bool isSingle = request.service == Service::GetSingle || request.service == Service::SetSingle;
    return isSingle ? request.attribute : 0;
}

quint16 checkSingle(const Request &request, const Memory &memory)
{
    if (isRead(request))
        return 0;
    if (!protocol::findCommand(request.command)->isWritable(request.instance, memory.dialect))
        return NotAccessible;
    return cellKind(request.command).check(request.payload, elementOf(request));
}

Answer executeSingle(const Request &request, Memory &memory)
{
    const CellKind &kind = cellKind(request.command);
    const int number = kind.number(request.instance, memory);
    if (isRead(request))
        return kind.load(memory, number, elementOf(request));
    kind.store(memory, number, request.payload, elementOf(request));
    return QByteArray {};
}

/// The items of a plural request, one by one: what they carry and where it belongs.
struct Item {
    quint32 instance;
    QByteArrayView bytes; ///< Empty when reading.
};

std::vector<Item> itemsOf(const Request &request)
{
    const qsizetype size = isRead(request) ? 0 : protocol::findCommand(request.command)->size;
    const auto count = qFromLittleEndian<quint32>(request.payload.data());
    const QByteArrayView data = QByteArrayView {request.payload}.sliced(PluralRule::countSize);
    std::vector<Item> items;
    for (quint32 index = 0; index < count; ++index)
        items.push_back({request.instance + index, data.sliced(index * size, size)});
    return items;
}

quint16 checkPlural(const Request &request, const Memory &memory)
{
    const auto &command = *protocol::findCommand(request.command);
    for (const Item &item : itemsOf(request)) {
        if (!command.hasInstance(item.instance, memory.dialect))
            return RangeFault;
        if (isRead(request))
            continue;
        if (!command.isWritable(item.instance, memory.dialect))
            return NotAccessible;
        if (const quint16 fault = cellKind(request.command).check(item.bytes, 0))
            return fault;
    }
    return 0;
}

Answer executePlural(const Request &request, Memory &memory)
{
    const CellKind &kind = cellKind(request.command);
    QByteArray payload = request.payload.first(PluralRule::countSize);
    for (const Item &item : itemsOf(request)) {
        const int number = kind.number(quint16(item.instance), memory);
        if (!isRead(request)) {
            kind.store(memory, number, item.bytes, 0);
        } else if (Answer loaded = kind.load(memory, number, 0)) {
            payload += *loaded;
        } else {
            return loaded;
        }
    }
    return payload;
}

} // namespace

std::span<const Handler> dataHandlers()
{
    static const auto rows = [] {
        std::vector<Handler> handlers;
        for (const CellKind &kind : cellKinds()) {
            handlers.push_back({kind.single, checkSingle, executeSingle});
            handlers.push_back({kind.plural, checkPlural, executePlural});
        }
        return handlers;
    }();
    return rows;
}

} // namespace virtualcontroller
