// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
//
// What a fleet costs: a window on the board of 1, 4, 16 and 64 controllers, all connected, one of them in view at 10 Hz
// and the others in the background at 1 Hz; the controllers run in another process. Prints for each number the share of
// one core and the memory of the window's process, the longest the event loop was away, and how many controllers were
// live in the end; nothing passes or fails.
#include "ui/harness.h"

#include "ui/pagecatalog.h"
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <cstdio>
#include <sys/resource.h>
#include <unistd.h>

using namespace std::chrono_literals;

namespace {

constexpr auto measured = 10s;

double processorSeconds()
{
    rusage usage {};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval &time) { return double(time.tv_sec) + double(time.tv_usec) / 1e6; };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Resident, in MiB.
double memory()
{
    QFile file {QStringLiteral("/proc/self/statm")};
    if (!file.open(QIODevice::ReadOnly))
        return 0;
    return file.readAll().split(' ').value(1).toDouble() * double(sysconf(_SC_PAGESIZE)) / (1024 * 1024);
}

/// The ports of robot and file control of each, as the simulator prints them.
QList<std::pair<quint16, quint16>> startSimulators(QProcess &simulator, int count)
{
    simulator.start(QStringLiteral(PENDESK_BIN "/pendesk-sim"),
        {QStringLiteral("--port"), QStringLiteral("0"), QStringLiteral("--file-port"), QStringLiteral("0"),
            QStringLiteral("--count"), QString::number(count)});
    if (!simulator.waitForReadyRead(30000))
        return {};
    static const QRegularExpression form {QStringLiteral(R"(:(\d+), files (\d+))")};
    QList<std::pair<quint16, quint16>> ports;
    auto matches = form.globalMatch(QString::fromUtf8(simulator.readAllStandardOutput()));
    while (matches.hasNext()) {
        const auto match = matches.next();
        ports << std::pair {quint16(match.captured(1).toUInt()), quint16(match.captured(2).toUInt())};
    }
    return ports;
}

struct Cost {
    double share = 0; ///< Of one core.
    double longestGap = 0; ///< ms
};

Cost measure()
{
    Cost cost;
    QElapsedTimer clock;
    QElapsedTimer turn;
    QTimer timer;
    timer.setTimerType(Qt::PreciseTimer);
    QObject::connect(&timer, &QTimer::timeout, &timer, [&] {
        cost.longestGap = std::max(cost.longestGap, double(turn.nsecsElapsed()) / 1e6);
        turn.restart();
    });
    turn.start();
    timer.start(1ms);
    const double before = processorSeconds();
    clock.start();
    while (clock.elapsed() < std::chrono::milliseconds {measured}.count())
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    cost.share = (processorSeconds() - before) / (double(clock.elapsed()) / 1000);
    return cost;
}

void run(int count)
{
    QProcess simulator;
    const auto ports = startSimulators(simulator, count);
    Harness harness;
    harness.window.show();
    for (qsizetype index = 0; index < ports.size(); ++index) {
        settings::Profile profile;
        profile.name = QStringLiteral("CELL %1").arg(index + 1, 2, 10, QLatin1Char('0'));
        profile.host = QStringLiteral("127.0.0.1");
        profile.port = ports[index].first;
        profile.filePort = ports[index].second;
        if (index == 0)
            harness.window.connectTo(profile);
        else
            harness.fleet.open(profile);
    }
    const auto isUp = [](const auto &station) {
        return station->controller.linkState() == robot::LinkState::Monitoring;
    };
    const auto areUp = [&] { return std::ranges::all_of(harness.fleet.stations(), isUp); };
    (void)QTest::qWaitFor(areUp, 30000);
    harness.window.view().openPage(int(ui::pageCatalog().size()) - 1); // the fleet
    const Cost cost = measure();
    const auto stations = harness.fleet.stations();
    std::printf("%2d controllers: %5.1f %% of a core, %6.1f MiB, longest away %5.1f ms, %lld live\n", count,
        100 * cost.share, memory(), cost.longestGap, static_cast<long long>(std::ranges::count_if(stations, isUp)));
    std::fflush(stdout);
    simulator.kill();
    simulator.waitForFinished();
}

} // namespace

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    for (const int count : {1, 4, 16, 64})
        run(count);
}
