// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
//
// Files through the complete client (session, transfer, task, disk) against a bare stop-and-wait loop in C, interleaved
// in one run on one core. Prints a table; nothing here passes or fails.
#include "bareserver.h"
#include "files/backup.h"
#include "files/task.h"
#include "session/udptransport.h"
#include <QCoreApplication>
#include <QEventLoop>
#include <QHostAddress>
#include <QTemporaryDir>
#include <algorithm>
#include <cstdio>
#include <functional>
#include <sched.h>

using namespace std::chrono_literals;

namespace {

using Work = std::function<void()>;

double seconds(const Work &work)
{
    const auto begin = bare::Clock::now();
    work();
    return std::chrono::duration<double>(bare::Clock::now() - begin).count();
}

double median(std::vector<double> samples)
{
    std::ranges::sort(samples);
    return samples[samples.size() / 2];
}

/// Runs both in turn, so that whatever the machine does hits both.
void compare(const char *what, double bytes, int rounds, const Work &pendesk, const Work &bareC)
{
    std::vector<double> ours;
    std::vector<double> theirs;
    for (int round = 0; round < rounds; ++round) {
        ours.push_back(seconds(pendesk));
        theirs.push_back(seconds(bareC));
    }
    const double a = bytes / median(ours) / 1024;
    const double b = bytes / median(theirs) / 1024;
    std::printf("%-48s %10.0f %10.0f KiB/s  ratio %6.3f\n", what, a, b, a / b);
    std::fflush(stdout);
}

/// The client and the bare loop at the same server.
struct Desk {
    Desk(std::chrono::microseconds delay, std::size_t size, int jobs) : server {1, delay}, plain {server.port()}
    {
        server.file.assign(size, 'x');
        for (int number = 0; number < jobs; ++number) {
            const QByteArray line = "JOB" + QByteArray::number(number) + ".JBI\r\n";
            server.list.insert(server.list.end(), line.begin(), line.end());
        }
        policy.blockSize = protocol::maxPayloadSize;
    }

    void finish(files::Operation &task)
    {
        QEventLoop loop;
        QObject::connect(&task, &files::Operation::finished, &loop, &QEventLoop::quit);
        task.start();
        loop.exec();
        if (task.state() != files::OperationState::Done)
            std::printf("a transfer failed\n");
    }

    void get(int count)
    {
        for (int number = 0; number < count; ++number) {
            files::Download task {session, name, folder.filePath(QStringLiteral("A%1.JBI").arg(number))};
            finish(task);
        }
    }
    void put(int count)
    {
        const QByteArray content(qsizetype(server.file.size()), 'x');
        const auto always = [](QObject *, const std::function<void(const values::Result<void> &)> &handler) {
            handler({});
        };
        for (int number = 0; number < count; ++number) {
            files::Upload task {session, name, content, always};
            finish(task);
            if (task.readBack() != files::ReadBack::Identical)
                std::printf("a file came back different\n");
        }
    }

    void backUp()
    {
        files::BackupOrder order;
        order.root = folder.path();
        order.info.controller = QStringLiteral("CELL 4");
        files::Backup backup {session, order};
        finish(backup);
        if (backup.info().failures() > 0)
            std::printf("a file is missing\n");
    }

    bare::Server server;
    bare::Client plain;
    session::FilePolicy policy;
    session::UdpTransport transport {QHostAddress {QHostAddress::LocalHost}, quint16(server.port())};
    session::FileSession session {transport, policy};
    values::FileName name = *values::FileName::create("A.JBI");
    QTemporaryDir folder;
};

void compareAll(std::chrono::microseconds delay, const char *title, int rounds)
{
    constexpr std::size_t large = 1 << 20;
    constexpr std::size_t small = 4096;
    constexpr int jobs = 500;
    std::printf("%s\n", title);
    {
        Desk desk {delay, large, 0};
        compare(
            "1 MiB to disk", large, rounds, [&] { desk.get(1); }, [&] { desk.plain.get(); });
        compare(
            "1 MiB sent and read back", 2.0 * large, rounds, [&] { desk.put(1); },
            [&] {
                desk.plain.put(desk.server.file);
                desk.plain.get();
            });
    }
    Desk desk {delay, small, jobs};
    const auto bareJobs = [&] {
        for (int number = 0; number < jobs; ++number)
            desk.plain.get();
    };
    compare(
        "500 jobs of 4 KiB into a backup", double(jobs) * small, rounds, [&] { desk.backUp(); }, bareJobs);
    compare(
        "500 jobs of 4 KiB, each flushed to disk", double(jobs) * small, rounds, [&] { desk.get(jobs); }, bareJobs);
}

} // namespace

int main(int argc, char *argv[])
{
    const QCoreApplication application {argc, argv};
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(0, &one);
    sched_setaffinity(0, sizeof one, &one);
    std::printf("%-48s %10s %10s\n", "", "Pendesk", "bare C");
    compareAll(2ms, "a controller that answers after 2 ms", 3);
    compareAll(0us, "a controller that answers at once (loopback only)", 3);
    return 0;
}
