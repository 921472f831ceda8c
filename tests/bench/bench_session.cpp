// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
//
// The complete client (encode, session, socket, decode into values) against a bare blocking C loop, interleaved in one
// run on one core: medians over the rounds, and their ratio. Prints a table; nothing here passes or fails.
#include "bareserver.h"
#include "protocol/datarequests.h"
#include "session/filesession.h"
#include "session/session.h"
#include "session/udptransport.h"
#include <QCoreApplication>
#include <QEventLoop>
#include <QUdpSocket>
#include <algorithm>
#include <cstdio>
#include <functional>
#include <sched.h>
#include <sys/resource.h>

using namespace std::chrono_literals;
using namespace session;
using values::Result;

namespace {

constexpr int rounds = 21;

struct Cost {
    double seconds;
    double cpu; ///< Of the calling thread, in seconds.
};

double threadCpu()
{
    timespec time {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + double(time.tv_nsec) / 1e9;
}

using Work = std::function<void()>;

Cost measure(const Work &work)
{
    const double cpu = threadCpu();
    const auto begin = bare::Clock::now();
    work();
    return {std::chrono::duration<double>(bare::Clock::now() - begin).count(), threadCpu() - cpu};
}

double median(std::vector<double> samples)
{
    std::ranges::sort(samples);
    return samples[samples.size() / 2];
}

struct Pair {
    Cost pendesk;
    Cost bareC;
    Cost bareQt {}; ///< Where there is such a loop to compare with.
};

/// Runs both in turn, so that whatever the machine does hits both.
Pair compare(
    const Work &pendesk, const Work &bareC, const Work &bareQt = [] {})
{
    const Work *works[] {&pendesk, &bareC, &bareQt};
    std::vector<double> times[3];
    std::vector<double> cpus[3];
    for (int round = 0; round < rounds; ++round) {
        for (int which = 0; which < 3; ++which) {
            const Cost cost = measure(*works[which]);
            times[which].push_back(cost.seconds);
            cpus[which].push_back(cost.cpu);
        }
    }
    const auto cost = [&](int which) { return Cost {median(times[which]), median(cpus[which])}; };
    return {cost(0), cost(1), cost(2)};
}

void row(const char *what, double pendesk, double bareC, const char *unit, double ratio)
{
    std::printf("%-44s %12.2f %12.2f %-6s ratio %6.3f\n", what, pendesk, bareC, unit, ratio);
    std::fflush(stdout);
}

using Bytes = values::ByteVariable;

Policy fastPolicy(int window = 1)
{
    Policy policy;
    policy.window = window;
    policy.requestsPerSecond = 0;
    policy.idLinger = {}; // what is measured is the cost of a request, not how many a second may leave
    return policy;
}

/// A session to one port of the bare server.
struct Client {
    explicit Client(unsigned port, const Policy &policy = fastPolicy())
        : transport {QHostAddress {QHostAddress::LocalHost}, quint16(port)}, session {transport, policy}
    {
    }
    UdpTransport transport;
    Session session;
};

/// `count` status reads one after the other, each asked for when the last one was answered.
class StatusLoop : public QObject
{
public:
    StatusLoop(Session &session, int count, std::function<void()> done)
        : m_session {session}, m_left {count}, m_done {std::move(done)}
    {
    }
    void next()
    {
        m_session.send(protocol::ReadStatus {}, this, [this](const Result<values::Status> &status) {
            m_failures += !status;
            if (--m_left > 0)
                next();
            else
                m_done();
        });
    }
    [[nodiscard]] int failures() const { return m_failures; }

private:
    Session &m_session;
    int m_left;
    int m_failures = 0;
    std::function<void()> m_done;
};

int readStatuses(Session &session, int count)
{
    QEventLoop loop;
    StatusLoop reads {session, count, [&] { loop.quit(); }};
    reads.next();
    loop.exec();
    return reads.failures();
}

/// What the session stands on, and nothing else: an unconnected QUdpSocket that sends when it has received.
void bareQtRoundTrips(quint16 port, int count)
{
    QUdpSocket socket;
    socket.bind(QHostAddress {QHostAddress::AnyIPv4}, 0);
    const QByteArray packet = protocol::encode(protocol::ReadStatus {}.request(), protocol::Framing {});
    const QHostAddress peer {QHostAddress::LocalHost};
    QEventLoop loop;
    std::array<char, 2048> buffer;
    int left = count;
    QObject::connect(&socket, &QUdpSocket::readyRead, &socket, [&] {
        QHostAddress sender;
        quint16 senderPort = 0;
        socket.readDatagram(buffer.data(), qint64(buffer.size()), &sender, &senderPort);
        if (--left > 0)
            socket.writeDatagram(packet, peer, port);
        else
            loop.quit();
    });
    socket.writeDatagram(packet, peer, port);
    loop.exec();
}

void roundTrips()
{
    constexpr int count = 4000;
    bare::Server server {1, 0us};
    Client client {server.port()};
    bare::Client plain {server.port()};
    const Pair pair = compare([&] { readStatuses(client.session, count); },
        [&] {
            for (int i = 0; i < count; ++i)
                plain.ask(0x72, 1, 0x01);
        },
        [&] { bareQtRoundTrips(quint16(server.port()), count); });
    row("bare QUdpSocket round trips/s (the limit)", count / pair.bareQt.seconds, count / pair.bareC.seconds, "1/s",
        pair.bareC.seconds / pair.bareQt.seconds);
    row("bare QUdpSocket CPU per round trip", pair.bareQt.cpu / count * 1e6, pair.bareC.cpu / count * 1e6, "us",
        pair.bareQt.cpu / pair.bareC.cpu);
    row("status round trips/s, one outstanding", count / pair.pendesk.seconds, count / pair.bareC.seconds, "1/s",
        pair.bareC.seconds / pair.pendesk.seconds);
    row("CPU per round trip", pair.pendesk.cpu / count * 1e6, pair.bareC.cpu / count * 1e6, "us",
        pair.pendesk.cpu / pair.bareC.cpu);
}

/// Sends any number of typed reads and waits for all.
class Batch : public QObject
{
public:
    explicit Batch(Session &session) : m_session {session} { }

    template <typename Request> void add(const Request &request)
    {
        ++m_open;
        m_session.send(request, this, [this](const Result<typename Request::Reply> &reply) {
            m_failures += !reply;
            if (--m_open == 0)
                m_loop.quit();
        });
    }
    void wait()
    {
        if (m_open > 0)
            m_loop.exec();
        if (m_failures > 0)
            std::printf("%d reads failed\n", m_failures);
    }

private:
    Session &m_session;
    QEventLoop m_loop;
    int m_open = 0;
    int m_failures = 0;
};

void thousandBytes()
{
    bare::Server server {1, 0us};
    Client client {server.port()};
    bare::Client plain {server.port()};
    long packets = 0;
    constexpr int repeats = 50;
    const auto pendesk = [&] {
        const long before = server.requests();
        for (int i = 0; i < repeats; ++i) {
            Batch batch {client.session};
            for (const auto &chunk : protocol::chunksToRead(protocol::pluralRule<Bytes>(), {0, 999}, 999))
                batch.add(*protocol::ReadItems<Bytes>::create(chunk.first, chunk.count));
            batch.wait();
        }
        packets = (server.requests() - before) / repeats;
    };
    const Pair pair = compare(pendesk, [&] {
        for (int i = 0; i < repeats; ++i) {
            plain.ask(0x302, 0, 0x33, 474);
            plain.ask(0x302, 474, 0x33, 474);
            plain.ask(0x302, 948, 0x33, 52);
        }
    });
    std::printf("1,000 B variables take %ld packets\n", packets);
    row("1,000 B variables (plural)", pair.pendesk.seconds / repeats * 1e6, pair.bareC.seconds / repeats * 1e6, "us",
        pair.pendesk.seconds / pair.bareC.seconds);
}

/// What a window with everything on it asks for once: status, job, position, torque, 4 alarms, 16 I/O groups, 100 B.
void addMonitorCycle(Batch &batch)
{
    const auto robot = values::ControlGroup::robotPulse(1);
    batch.add(protocol::ReadStatus {});
    batch.add(protocol::ReadExecutingJob {});
    batch.add(protocol::ReadPosition {robot});
    batch.add(protocol::ReadTorque {robot});
    for (int slot = 1; slot <= 4; ++slot)
        batch.add(protocol::ReadAlarm {slot});
    batch.add(*protocol::ReadItems<values::IoGroup>::create(1, 16));
    batch.add(*protocol::ReadItems<Bytes>::create(0, 100));
}

void monitorCycle()
{
    bare::Server server {1, 2ms};
    for (const int window : {1, 4, 8, 10}) {
        Client client {server.port(), fastPolicy(window)};
        std::vector<double> times;
        times.reserve(rounds);
        for (int round = 0; round < rounds; ++round) {
            times.push_back(measure([&] {
                Batch batch {client.session};
                addMonitorCycle(batch);
                batch.wait();
            }).seconds);
        }
        std::printf("monitor cycle, 10 requests, 2 ms delay, window %d %11.2f ms\n", window, median(times) * 1e3);
    }
}

/// Adaptive repeats against a fixed time-out of 300 ms, in the same run.
void lossyLink()
{
    constexpr int count = 1000;
    bare::Server server {1, 0us, 10};
    Policy fixed = fastPolicy();
    fixed.isAdaptive = false;
    Client adaptive {server.port()};
    Client waiting {server.port(), fixed};
    int failures = 0;
    const double fast = measure([&] { failures += readStatuses(adaptive.session, count); }).seconds;
    const double slow = measure([&] { failures += readStatuses(waiting.session, count); }).seconds;
    std::printf("status reads/s at 1 %% loss: %.0f, with a fixed 300 ms time-out %.0f, factor %.1f, failures %d\n",
        count / fast, count / slow, slow / fast, failures);
}

void manyControllers()
{
    constexpr int controllers = 64;
    constexpr int each = 500;
    bare::Server server {controllers, 2ms};
    std::vector<std::unique_ptr<Client>> clients;
    clients.reserve(controllers);
    for (int i = 0; i < controllers; ++i)
        clients.push_back(std::make_unique<Client>(server.port(i)));
    const Cost cost = measure([&] {
        QEventLoop loop;
        std::vector<std::unique_ptr<StatusLoop>> loops;
        int open = controllers;
        for (const auto &client : clients) {
            loops.push_back(std::make_unique<StatusLoop>(client->session, each, [&] {
                if (--open == 0)
                    loop.quit();
            }));
            loops.back()->next();
        }
        loop.exec();
    });
    std::printf("64 controllers, 2 ms delay, one thread: %.0f requests/s at %.0f %% of a core\n",
        controllers * each / cost.seconds, cost.cpu / cost.seconds * 100);
}

void files()
{
    bare::Server server {1, 2ms};
    server.file.assign(std::size_t(20) * 479, 'x');
    bare::Client plain {server.port()};
    UdpTransport transport {QHostAddress {QHostAddress::LocalHost}, quint16(server.port())};
    FilePolicy policy;
    policy.blockSize = protocol::maxPayloadSize;
    FileSession session {transport, policy};
    QObject context;
    QEventLoop loop;
    const QByteArray content {reinterpret_cast<const char *>(server.file.data()), qsizetype(server.file.size())};
    const auto name = *values::FileName::create("A.JBI");
    const auto get = [&] {
        session.save(name, &context, [&](const Result<QByteArray> &got) {
            if (got != content)
                std::printf("a download failed\n");
            loop.quit();
        });
        loop.exec();
    };
    const auto put = [&] {
        session.load(name, content, &context, [&](const Result<void> &done) {
            if (!done)
                std::printf("an upload failed\n");
            loop.quit();
        });
        loop.exec();
    };
    const Pair down = compare(get, [&] { plain.get(); });
    row("file get, 20 blocks of 479, 2 ms delay", down.pendesk.seconds * 1e3, down.bareC.seconds * 1e3, "ms",
        down.bareC.seconds / down.pendesk.seconds);
    const Pair up = compare(put, [&] { plain.put(server.file); });
    row("file put, 20 blocks of 479, 2 ms delay", up.pendesk.seconds * 1e3, up.bareC.seconds * 1e3, "ms",
        up.bareC.seconds / up.pendesk.seconds);
}

} // namespace

int main(int argc, char *argv[])
{
    const QCoreApplication application {argc, argv};
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(0, &one);
    sched_setaffinity(0, sizeof one, &one);
    std::printf("%-44s %12s %12s\n", "", "Pendesk", "bare C");
    roundTrips();
    thousandBytes();
    monitorCycle();
    lossyLink();
    manyControllers();
    files();
    return 0;
}
