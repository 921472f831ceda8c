// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
//
// The promises of a session under a network at its worst: 20 % loss, 10 % repeated and 10 % reordered answers, 5 %
// damaged.
#include "protocol/datarequests.h"
#include "session/exchange.h"
#include "session/filesession.h"
#include "session/session.h"
#include "session/udptransport.h"
#include "virtualcontroller/responder.h"
#include "virtualcontroller/server.h"
#include <QDir>
#include <QTest>
#include <queue>
#ifdef __GLIBC__
#include <malloc.h>
#endif

using namespace std::chrono_literals;
using namespace session;
using protocol::Effect;
using values::ErrorKind;
using values::Result;
using virtualcontroller::Direction;
using virtualcontroller::FaultKind;
using virtualcontroller::FaultRule;
using virtualcontroller::Faults;
using Number = values::DoubleVariable;

namespace robot {

/// The only maker of permits. Nothing in this test moves a robot.
class Arming
{
public:
    static const session::Permit &permit()
    {
        static const session::Permit permit;
        return permit;
    }
};

} // namespace robot

namespace {

constexpr quint16 variables = 100;

std::vector<FaultRule> worstNetwork()
{
    std::vector<FaultRule> rules;
    for (const auto direction : {Direction::Request, Direction::Reply})
        rules.push_back({{}, direction, FaultKind::Lose, 0.1});
    rules.push_back({{}, Direction::Reply, FaultKind::Duplicate, 0.1, 0, -1, 3ms});
    rules.push_back({{}, Direction::Reply, FaultKind::Reorder, 0.1});
    rules.push_back({{}, Direction::Reply, FaultKind::Corrupt, 0.05});
    return rules;
}

/// What D000 to D099 hold after `tick` changes: another number each time, and in each variable another.
qint32 valueOf(int tick, quint16 variable) { return tick * 128 + variable; }

void setVariables(virtualcontroller::Memory &memory, int tick)
{
    for (quint16 i = 0; i < variables; ++i)
        memory.d[i].value = valueOf(tick, i);
}

/// True if `value` of `variable` stood in the memory at some moment from `before` to `after`.
bool wasTrue(qint32 value, quint16 variable, int before, int after)
{
    return value % 128 == variable && value / 128 >= before && value / 128 <= after;
}

/// What the program has allocated and not freed, in bytes; 0 where the C library does not tell.
std::size_t memoryInUse()
{
#ifdef __GLIBC__
    return mallinfo2().uordblks;
#else
    return 0;
#endif
}

int openHandles() { return int(QDir {QStringLiteral("/proc/self/fd")}.entryList(QDir::Files | QDir::System).size()); }

/// An exchange and a virtual controller with a network between them that exists in virtual time only.
class VirtualNetwork
{
public:
    explicit VirtualNetwork(const Policy &policy, quint32 seed)
        : exchange {policy, quint8(seed), seed}, m_faults {worstNetwork(), seed}, m_random {seed}
    {
        setVariables(memory, tick);
    }

    void run(int requests)
    {
        while (m_submitted < requests || !exchange.isIdle()) {
            while (m_submitted < requests && m_open.size() < 12)
                submit();
            depart();
            step();
        }
    }

    Exchange exchange;
    virtualcontroller::Memory memory;
    int tick = 0;
    int delivered = 0;
    int untrue = 0;
    int unanswered = 0;
    std::map<QByteArray, int> ordersOnTheWire; ///< By payload, which is different in each order.
    int orders = 0;
    int orderEndings = 0;

private:
    struct Question {
        bool isOrder;
        quint16 variable;
        int tick;
    };
    struct Delivery {
        Time at;
        quint64 number;
        bool toController;
        QByteArray bytes;
        bool operator<(const Delivery &other) const { return std::tie(at, number) > std::tie(other.at, other.number); }
    };

    void submit()
    {
        ++m_submitted;
        const bool isOrder = m_random() % 10 == 0;
        const auto variable = quint16(m_random() % variables);
        const auto kind = std::array {Effect::Writes, Effect::Starts, Effect::Moves}[m_random() % 3];
        protocol::Request request = protocol::ReadItem<Number> {variable}.request();
        if (isOrder) // a write to D, with a payload that tells it from every other one
            request = protocol::WriteItem<Number> {variable, Number {-++orders}}.request();
        const Ticket ticket = exchange.submit(
            request, isOrder ? kind : Effect::Reads, isOrder ? Priority::Control : Priority::Page, m_now);
        m_open[ticket] = {isOrder, variable, tick};
    }

    void depart()
    {
        while (const auto departure = exchange.depart(m_now)) {
            const auto packet = protocol::parseClientPacket(departure->packet);
            if (packet->service == protocol::Service::SetSingle)
                ++ordersOnTheWire[packet->payload.toByteArray()];
            send(Direction::Request, departure->packet);
        }
    }

    void send(Direction direction, QByteArrayView bytes)
    {
        const auto plan = m_faults.plan(direction, 0x7C, bytes);
        for (const auto &delivery : plan.deliveries) {
            const auto way = std::chrono::microseconds {200 + m_random() % 2000};
            m_wire.push({m_now + way + delivery.delay, ++m_number, direction == Direction::Request, delivery.bytes});
        }
    }

    /// Moves on to whatever comes next: a packet that arrives, or a deadline.
    void step()
    {
        const auto deadline = exchange.nextDeadline(m_now);
        if (!m_wire.empty() && (!deadline || m_wire.top().at <= *deadline)) {
            const Delivery delivery = m_wire.top();
            m_wire.pop();
            m_now = std::max(m_now, delivery.at);
            delivery.toController ? answer(delivery.bytes) : receive(delivery.bytes);
        } else if (deadline) {
            m_now = std::max(m_now, *deadline);
            for (const Ending &ending : exchange.expire(m_now))
                finish(ending);
        }
    }

    void answer(const QByteArray &bytes)
    {
        setVariables(memory, ++tick); // the world goes on; an order of ours is undone by it at once
        if (const auto reply = virtualcontroller::respond(bytes, memory, 1ms))
            send(Direction::Reply, *reply);
    }

    void receive(const QByteArray &bytes)
    {
        if (const auto ending = exchange.receive(bytes, m_now))
            finish(*ending);
    }

    void finish(const Ending &ending)
    {
        const auto question = m_open.extract(ending.ticket).mapped();
        if (question.isOrder) {
            ++orderEndings;
            return;
        }
        const auto number = ending.reply.and_then(
            [](const protocol::Reply &reply) { return protocol::decode<Number>(reply.payload, 1); });
        if (!number) {
            ++unanswered;
            return;
        }
        ++delivered;
        untrue += !wasTrue(number->value, question.variable, question.tick, tick);
    }

    Faults m_faults;
    std::minstd_rand m_random;
    Time m_now {1h};
    std::priority_queue<Delivery> m_wire;
    std::map<Ticket, Question> m_open;
    quint64 m_number = 0;
    int m_submitted = 0;
};

Policy impatient(int window)
{
    Policy policy;
    policy.timeout = 8ms;
    policy.repeats = 4;
    policy.controlTimeout = 8ms;
    policy.servoTimeout = 8ms;
    policy.idLinger = 30ms;
    policy.requestsPerSecond = 0;
    policy.window = window;
    return policy;
}

virtualcontroller::Options worstController(quint32 seed)
{
    virtualcontroller::Options options;
    options.port = 0;
    options.filePort = 0;
    options.faults = Faults {worstNetwork(), seed};
    return options;
}

/// One controller, and a session that asks it as fast as it may, over real sockets.
class RealDesk : public QObject
{
public:
    RealDesk(quint32 seed, int requests)
        : server {worstController(seed)},
          m_isStarted {server.start().has_value()},
          m_transport {QHostAddress {QHostAddress::LocalHost}, server.port()},
          m_session {m_transport, impatient(8)},
          m_random {seed},
          m_left {requests}
    {
        setVariables(server.memory(), tick);
    }

    [[nodiscard]] bool isStarted() const { return m_isStarted; }
    [[nodiscard]] bool isDone() const { return m_left == 0 && m_open == 0; }

    void ask()
    {
        while (m_left > 0 && m_open < 12) {
            --m_left;
            ++m_open;
            switch (m_random() % 20) {
            case 0: order(protocol::StartJob {}); break;
            case 1: order(protocol::MoveCartesian {values::CartesianMove::JointAbsolute, {}}); break;
            case 2: order(protocol::WriteItem<values::Register> {5, {}}); break;
            default: read(quint16(m_random() % variables));
            }
        }
    }

    virtualcontroller::Server server;
    int tick = 0;
    int delivered = 0;
    int untrue = 0;
    std::map<quint16, int> ordered; ///< By command.

private:
    void ended()
    {
        --m_open;
        setVariables(server.memory(), ++tick);
        QMetaObject::invokeMethod(this, &RealDesk::ask, Qt::QueuedConnection);
    }

    void read(quint16 variable)
    {
        m_session.send(
            protocol::ReadItem<Number> {variable}, this, [this, variable, before = tick](const Result<Number> &number) {
                if (number) {
                    ++delivered;
                    untrue += !wasTrue(number->value, variable, before, tick);
                }
                ended();
            });
    }

    template <typename Order> void order(const Order &order)
    {
        ++ordered[order.request().command];
        const auto handler = [this](const Result<void> &) { ended(); };
        if constexpr (protocol::needsPermit(Order::effect))
            m_session.send(order, robot::Arming::permit(), this, handler);
        else
            m_session.send(order, this, handler);
    }

    bool m_isStarted;
    UdpTransport m_transport;
    Session m_session;
    std::minstd_rand m_random;
    int m_left;
    int m_open = 0;
};

/// One controller whose files are saved and loaded in turn over real sockets.
class RealFiles : public QObject
{
public:
    RealFiles(quint32 seed, int transfers)
        : server {worstController(seed)},
          m_isStarted {server.start().has_value()},
          m_transport {QHostAddress {QHostAddress::LocalHost}, server.filePort()},
          m_session {m_transport, policy()},
          m_random {seed},
          m_left {transfers}
    {
    }

    static FilePolicy policy()
    {
        FilePolicy policy;
        policy.timeout = 24ms;
        policy.repeatFloor = 8ms;
        return policy;
    }

    [[nodiscard]] bool isStarted() const { return m_isStarted; }
    [[nodiscard]] bool isDone() const { return m_left == 0; }

    void next()
    {
        if (m_left == 0)
            return;
        const QByteArray content = fileContent();
        if (m_random() % 2)
            save(content);
        else
            load(content);
    }

    virtualcontroller::Server server;
    int exact = 0;
    int failed = 0;
    int wrong = 0;

private:
    QByteArray fileContent()
    {
        QByteArray content(1 + qsizetype(m_random() % 1500), Qt::Uninitialized);
        std::ranges::generate(content, [this] { return char(m_random()); });
        return content;
    }

    void count(bool isDone, bool isExact)
    {
        (isDone ? (isExact ? exact : wrong) : failed) += 1;
        --m_left;
        QMetaObject::invokeMethod(this, &RealFiles::next, Qt::QueuedConnection);
    }

    void save(const QByteArray &content)
    {
        server.memory().files["ANY.DAT"] = content;
        m_session.save(*values::FileName::create("ANY.DAT"), this,
            [this, content](const Result<QByteArray> &got) { count(got.has_value(), got == content); });
    }

    /// A load that failed must have left the file there was, or, when the last answer was lost, the whole new one.
    void load(const QByteArray &content)
    {
        const QByteArray before = server.memory().files["ANY.DAT"];
        m_session.load(
            *values::FileName::create("ANY.DAT"), content, this, [this, content, before](const Result<void> &done) {
                const QByteArray &now = server.memory().files["ANY.DAT"];
                const bool mayBeBoth = !done && done.error().kind == ErrorKind::UnknownOutcome;
                const bool isTrue = now == content ? done || mayBeBoth : !done && now == before;
                wrong += !isTrue;
                if (isTrue)
                    (done ? exact : failed) += 1;
                --m_left;
                QMetaObject::invokeMethod(this, &RealFiles::next, Qt::QueuedConnection);
            });
    }

    bool m_isStarted;
    UdpTransport m_transport;
    FileSession m_session;
    std::minstd_rand m_random;
    int m_left;
};

} // namespace

class TestSoak : public QObject
{
    Q_OBJECT

    /// Asks eight controllers at once, so often in all.
    void soak(int requests)
    {
        constexpr int desks = 8;
        std::vector<std::unique_ptr<RealDesk>> all;
        for (quint32 i = 0; i < desks; ++i) {
            all.push_back(std::make_unique<RealDesk>(i + 1, requests / desks));
            QVERIFY(all.back()->isStarted());
            all.back()->ask();
        }
        int delivered = 0;
        for (const auto &desk : all) {
            QTRY_VERIFY_WITH_TIMEOUT(desk->isDone(), 240'000);
            QCOMPARE(desk->untrue, 0);
            delivered += desk->delivered;
            for (const auto &[command, times] : desk->ordered)
                QTRY_COMPARE(desk->server.arrived(command), times);
        }
        QVERIFY(delivered > requests / 2);
    }

private Q_SLOTS:
    void virtualTime_data()
    {
        QTest::addColumn<int>("window");
        QTest::newRow("one outstanding") << 1;
        QTest::newRow("window of eight") << 8;
    }

    void virtualTime()
    {
        QFETCH(int, window);
        Policy policy;
        policy.window = window;
        policy.requestsPerSecond = 0;
        VirtualNetwork network {policy, 7};
        network.run(100'000);
        QCOMPARE(network.untrue, 0);
        QVERIFY(network.delivered > 80'000);
        QVERIFY(network.unanswered > 0); // else there was no bad network
        QVERIFY(network.orders > 9'000);
        QCOMPARE(network.orderEndings, network.orders);
        QCOMPARE(int(network.ordersOnTheWire.size()), network.orders);
        for (const auto &[payload, times] : network.ordersOnTheWire)
            QCOMPARE(times, 1);
    }

    void realSockets()
    {
        constexpr int requests = 100'000;
        soak(100); // what is made once and kept, Qt makes now
        const int handles = openHandles();
        const std::size_t memory = memoryInUse();
        soak(requests);
        QCOMPARE(openHandles(), handles);
        QVERIFY2(memoryInUse() < memory + 64 * 1024, qPrintable(QString::number(memoryInUse() - memory)));
    }

    void files()
    {
        constexpr int desks = 8;
        constexpr int transfers = 1'000;
        std::vector<std::unique_ptr<RealFiles>> all;
        for (quint32 i = 0; i < desks; ++i) {
            all.push_back(std::make_unique<RealFiles>(i + 1, transfers / desks));
            QVERIFY(all.back()->isStarted());
            all.back()->next();
        }
        int exact = 0;
        for (const auto &desk : all) {
            QTRY_VERIFY_WITH_TIMEOUT(desk->isDone(), 240'000);
            QCOMPARE(desk->wrong, 0);
            exact += desk->exact;
        }
        QVERIFY(exact > transfers / 10);
    }
};

QTEST_GUILESS_MAIN(TestSoak)
#include "tst_soak.moc"
