// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/catalog.h"
#include "protocol/decoder.h"
#include "protocol/fileblocks.h"
#include "support/golden.h"
#include "support/typedrequests.h"
#include "virtualcontroller/fileresponder.h"
#include "virtualcontroller/machine.h"
#include "virtualcontroller/responder.h"
#include <QTest>
#include <set>

using namespace protocol;

namespace {

/// A cell's row: what a client can ask for. Command 0 is the file port.
using Order = std::pair<quint16, Service>;
using Orders = std::set<Order>;

Order orderOf(const Request &request) { return {request.command, request.service}; }

/// Everything the catalogue offers.
Orders offered()
{
    Orders orders;
    for (const Command &command : commands()) {
        for (const Service service : command.services)
            orders.insert({command.number, service});
    }
    for (const FileService &service : fileServices())
        orders.insert({0, service.service});
    return orders;
}

/// A typed request exists.
Orders typedOrders()
{
    Orders orders;
    for (const typed::Row &row : typed::rows())
        orders.insert(orderOf(row.request));
    for (const typed::FileRow &row : typed::fileRows())
        orders.insert(orderOf(row.request));
    return orders;
}

bool makes(const char *title, const Request &request)
{
    const auto packet = parseClientPacket(golden::exchange(QString::fromUtf8(title)).packets.first().bytes);
    return packet && packet->request() == request;
}

/// A typed request makes exactly the bytes of a golden packet.
Orders encodedOrders()
{
    Orders orders;
    for (const typed::Row &row : typed::rows()) {
        if (makes(row.title, row.request))
            orders.insert(orderOf(row.request));
    }
    for (const typed::FileRow &row : typed::fileRows()) {
        if (makes(row.title, row.request))
            orders.insert(orderOf(row.request));
    }
    return orders;
}

/// No packet of the exchange is malformed and none a refusal.
bool isUnderstood(const golden::Exchange &exchange)
{
    Decoder decoder;
    return std::ranges::all_of(exchange.packets, [&decoder](const golden::Packet &packet) {
        const DecodedPacket decoded = decoder.decode(packet.bytes);
        return !decoded.isMalformed() && decoded.meaning.isEmpty();
    });
}

/// A golden reply that is no refusal was understood: by the typed request, and on the file port by the decoder.
Orders decodedOrders()
{
    Orders orders;
    for (const typed::Row &row : typed::rows()) {
        const auto reply = parseReply(golden::exchange(QString::fromUtf8(row.title)).packets[1].bytes);
        if (reply && !reply->isRefusal() && row.check(reply->payload).isEmpty())
            orders.insert(orderOf(row.request));
    }
    for (const golden::Exchange &exchange : golden::exchanges()) {
        const auto request = parseClientPacket(exchange.packets.first().bytes);
        if (request && request->command == 0 && isUnderstood(exchange))
            orders.insert(orderOf(request->request()));
    }
    return orders;
}

/// A virtual controller on which nothing stands against any order of the table.
virtualcontroller::Memory readyForAnything()
{
    using values::ControlGroup;
    virtualcontroller::Memory memory;
    memory.settings.hasBatchBackup = true;
    memory.status.data2.setFlag(values::Status::ServoOn);
    memory.tasks.resize(16);
    memory.groups = {{ControlGroup::robotPulse(1), {0, 0, 0, 0, 0, 0}, {}}};
    for (const auto group : {ControlGroup::robotPulse(2), ControlGroup::basePulse(1), ControlGroup::basePulse(2),
             ControlGroup::stationPulse(1), ControlGroup::stationPulse(2)})
        memory.groups.push_back({group, {0, 0, 0}, {}});
    memory.p.assign(memory.p.size(), values::PositionVariable {});
    memory.bp.assign(memory.bp.size(), values::BasePosition {});
    memory.ex.assign(memory.ex.size(), values::ExternalPosition {});
    for (quint16 instance = 1; instance < 400; ++instance) {
        memory.times[instance] = {};
        memory.systemInformation[instance] = {};
        memory.encoderTemperatures[instance] = {};
        memory.converterTemperatures[instance] = {};
    }
    for (const golden::Exchange &exchange : golden::exchanges()) {
        const auto request = parseClientPacket(exchange.packets.first().bytes);
        if (request && request->command == 0x87) // the jobs that the golden packets select
            memory.files[decode<values::JobSelection>(request->payload)->job.bytes().toByteArray() + ".JBI"] =
                memory.files.at("HOME.JBI");
    }
    for (const char *name : {"DEMO01.JBI", "BIG.JBI", "CMOSBK.BIN"})
        memory.files[name] = memory.files.at("HOME.JBI");
    virtualcontroller::selectJob(memory, 0, "HOME", 0);
    return memory;
}

/// What the virtual controller answers to a request on its own; the code of a refusal, 0 for a good reply.
int simulatedCode(const Request &request)
{
    auto memory = readyForAnything();
    const bool isFile = request.command == 0;
    const QByteArray packet = encode(request, {isFile ? Division::File : Division::Robot, false, 1, 0});
    const auto reply = isFile ? virtualcontroller::respondFile(packet, "peer", memory, {})
                              : virtualcontroller::respond(packet, memory, {});
    return reply ? int(parseReply(*reply)->addedStatus) : -1;
}

/// The virtual controller does it, or refuses it to the instance that nothing has.
Orders simulatedOrders(bool isWronglyAddressed)
{
    constexpr quint16 nobody = 9999;
    constexpr int instanceError = 0xA001;
    Orders orders;
    const auto tryOut = [&](Request request) {
        if (isWronglyAddressed)
            request.instance = nobody;
        if (simulatedCode(request) == (isWronglyAddressed ? instanceError : 0))
            orders.insert(orderOf(request));
    };
    for (const typed::Row &row : typed::rows())
        tryOut(row.request);
    for (const typed::FileRow &row : typed::fileRows())
        tryOut(row.request);
    return orders;
}

struct Column {
    const char *name;
    Orders covered;
};

/// Another column is another row here.
QList<Column> columns()
{
    return {
        {"typed", typedOrders()},
        {"encoded golden", encodedOrders()},
        {"decoded golden", decodedOrders()},
        {"simulated", simulatedOrders(false)},
        {"misaddressed", simulatedOrders(true)},
    };
}

QByteArray nameOf(Order order)
{
    const auto service = "0x" + QByteArray::number(uint(order.second), 16).rightJustified(2, '0');
    if (order.first == 0)
        return "file  " + service + ' ' + findFileService(order.second)->name;
    return "0x" + QByteArray::number(order.first, 16).rightJustified(3, '0') + ' ' + service + ' '
        + findCommand(order.first)->name;
}

} // namespace

/// No cell of the table command and service × what is proved about it is empty.
class CoverageTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasNoEmptyCell_data();
    void hasNoEmptyCell();
    void printsTable();
};

void CoverageTest::hasNoEmptyCell_data()
{
    QTest::addColumn<bool>("isCovered");
    for (const Column &column : columns()) {
        for (const Order &order : offered())
            QTest::addRow("%s: %s", nameOf(order).constData(), column.name) << column.covered.contains(order);
    }
}

void CoverageTest::hasNoEmptyCell()
{
    QFETCH(bool, isCovered);
    QVERIFY(isCovered);
}

void CoverageTest::printsTable()
{
    const auto all = columns();
    QByteArray table = QByteArray("command and service").leftJustified(44);
    for (const Column &column : all)
        table += QByteArray(column.name).leftJustified(16);
    for (const Order &order : offered()) {
        table += '\n' + nameOf(order).leftJustified(44);
        for (const Column &column : all)
            table += QByteArray(column.covered.contains(order) ? "yes" : "-").leftJustified(16);
    }
    fprintf(stdout, "%s\n", table.constData());
}

QTEST_APPLESS_MAIN(CoverageTest)
#include "tst_coverage.moc"
