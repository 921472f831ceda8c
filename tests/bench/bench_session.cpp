// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
//
// The complete client (encode, session, socket, decode into values) against a bare blocking C loop, interleaved in one run on
// one core: medians over the rounds, and their ratio. Prints a table; nothing here passes or fails.
#include "bareserver.h"
#include "session/filesession.h"
#include "protocol/datarequests.h"
#include "session/session.h"
#include "session/udptransport.h"
#include <QCoreApplication>
#include <QEventLoop>
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

Cost measure(const std::function<void()> &work)
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
};

/// Runs both in turn, so that whatever the machine does hits both.
Pair compare(const std::function<void()> &pendesk, const std::function<void()> &bareC)
{
    std::vector<double> times[2];
    std::vector<double> cpus[2];
    for (int round = 0; round < rounds; ++round) {
        const Cost costs[] {measure(pendesk), measure(bareC)};
        for (int which = 0; which < 2; ++which) {
            times[which].push_back(costs[which].seconds);
            cpus[which].push_back(costs[which].cpu);
        }
    }
    return {{median(times[0]), median(cpus[0])}, {median(times[1]), median(cpus[1])}};
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
        });
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
    return 0;
}
