// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
// How long a packet takes to encode and to decode, and how often memory is asked for. It prints a table and judges
// nothing.
#include "protocol/decoder.h"
#include "protocol/requests.h"
#include "support/golden.h"
#include <chrono>
#include <cstdio>

namespace {

quint64 allocations = 0; ///< By operator new and by malloc, which Qt's containers use.

} // namespace

#ifndef __SANITIZE_ADDRESS__ // which has a malloc of its own; the column then stays 0
extern "C" void *__libc_malloc(std::size_t size);

extern "C" void *malloc(std::size_t size)
{
    ++allocations;
    return __libc_malloc(size);
}
#endif

using namespace protocol;

namespace {

constexpr int rounds = 200000;

struct Measured {
    double nanoseconds;
    double allocations;
};

template <typename Function> Measured measured(Function function)
{
    using Clock = std::chrono::steady_clock;
    const quint64 before = allocations;
    const auto start = Clock::now();
    for (int round = 0; round < rounds; ++round)
        function();
    const std::chrono::duration<double, std::nano> elapsed = Clock::now() - start;
    return {elapsed.count() / rounds, double(allocations - before) / rounds};
}

/// Keeps the compiler from leaving the work out.
template <typename Value> void keep(const Value &value) { asm volatile("" : : "g"(&value) : "memory"); }

void print(const char *name, Measured result)
{
    std::printf("%-44s %10.1f %12.2f\n", name, result.nanoseconds, result.allocations);
}

QByteArray packetOf(const char *title, int index)
{
    return golden::exchange(QString::fromUtf8(title)).packets[index].bytes;
}

/// Encodes the request, and decodes the golden reply to it as the session does.
template <TypedRequest R> void bench(const char *name, const char *title, const R &request)
{
    const QByteArray datagram = packetOf(title, 1);
    print(qPrintable(QStringLiteral("encode %1").arg(QLatin1StringView(name))), measured([&] {
        keep(encode(request.request(), Framing {Division::Robot, false, 1, 0}));
    }));
    print(qPrintable(QStringLiteral("decode %1").arg(QLatin1StringView(name))), measured([&] {
        const auto reply = parseReply(datagram);
        keep(request.decode(reply->payload));
    }));
}

void benchTraffic()
{
    const QByteArray request = packetOf("Base position of a 6-axis arm", 0);
    const QByteArray reply = packetOf("Base position of a 6-axis arm", 1);
    Decoder decoder;
    decoder.setRequest(request);
    print("traffic: name every field of a position", measured([&] { keep(decoder.decode(reply)); }));
}

} // namespace

int main()
{
    using namespace values;
    std::printf("%-44s %10s %12s\n", "packet", "ns", "allocations");
    bench("status", "Status of a robot that runs in remote play", ReadStatus {});
    bench("executing job", "Job of the master task", ReadExecutingJob {});
    bench("position", "Base position of a 6-axis arm", ReadPosition {ControlGroup::robotCartesian(1)});
    bench("alarm with texts", "Active alarm with texts, 268 bytes", ReadAlarmWithTexts {});
    bench("axis names", "Axis names of R1 in pulses", ReadAxisNames {ControlGroup::robotPulse(1)});
    bench("system information", "System information of S1, which has no model", ReadSystemInformation::station(1));
    bench("register", "Register M005", ReadItem<Register> {5});
    bench("p variable", "P127 in a user frame", ReadItem<PositionVariable> {127});
    bench("474 b variables", "The most B variables that fit", *ReadItems<ByteVariable>::create(0, 474));
    benchTraffic();
    return 0;
}
