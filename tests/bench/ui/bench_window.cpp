// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
//
// What a full desk costs: the overview, and I/O, variables and position in windows of their own, with 512 inputs and
// 512 outputs at 4 Hz, 100 variables at 2 Hz, position and status at 10 Hz, all read from a controller in another
// process. Prints the processor time of the window's process and the longest the event loop was away; nothing passes or
// fails.
#include "ui/harness.h"

#include "ui/pagewindow.h"
#include <QElapsedTimer>
#include <QProcess>
#include <QRegularExpression>
#include <cstdio>
#include <sys/resource.h>

using namespace std::chrono_literals;

namespace {

constexpr auto span = 20s;

double processorSeconds()
{
    rusage usage {};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval &time) { return double(time.tv_sec) + double(time.tv_usec) / 1e6; };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Notes how long the event loop was away at the most: no frame was painted in that time.
class Stopwatch : public QObject
{
public:
    Stopwatch()
    {
        m_timer.setTimerType(Qt::PreciseTimer);
        connect(&m_timer, &QTimer::timeout, this,
            [this] { gaps.push_back(double(m_clock.nsecsElapsed()) / 1e6), m_clock.restart(); });
        m_clock.start();
        m_timer.start(1ms);
    }

    std::vector<double> gaps; ///< Milliseconds between two turns; 1 ms of each is the timer's own.

private:
    QTimer m_timer;
    QElapsedTimer m_clock;
};

/// The robot port of a simulator in a process of its own; 0 if it does not start.
quint16 startSimulator(QProcess &simulator)
{
    simulator.start(QStringLiteral(PENDESK_BIN "/pendesk-sim"),
        {QStringLiteral("--port"), QStringLiteral("0"), QStringLiteral("--file-port"), QStringLiteral("0")});
    if (!simulator.waitForReadyRead(10000))
        return 0;
    const QString line = QString::fromUtf8(simulator.readAllStandardOutput());
    const auto match = QRegularExpression(QStringLiteral(R"(:(\d+))")).match(line);
    return quint16(match.captured(1).toUInt());
}

} // namespace

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    QProcess simulator;
    Harness harness;
    settings::Profile profile = harness.profile();
    profile.port = startSimulator(simulator);
    profile.window = 4;
    if (profile.port == 0)
        return std::fputs("The simulator did not start.\n", stderr), 1;
    harness.window.resize(1440, 900);
    harness.window.show();
    harness.window.connectTo(profile);
    for (const auto *id : {"io", "variables", "position"})
        harness.window.view().openInWindow(QLatin1String(id));
    const auto both = harness.window.controller().poller().want(
        {{robot::Kind::IoGroup, 1, 64}, {robot::Kind::IoGroup, 1001, 1064}, {robot::Kind::ByteVariable, 0, 99}});
    if (!QTest::qWaitFor([&] { return harness.isAllLive(); }))
        return std::fputs("Not every value came.\n", stderr), 1;
    QTest::qWait(2000); // windows settle
    Stopwatch stopwatch;
    const double before = processorSeconds();
    QTest::qWait(int(std::chrono::milliseconds(span).count()));
    const double share = (processorSeconds() - before) / double(span.count()) * 100;
    std::ranges::sort(stopwatch.gaps);
    const auto at = [&](double part) { return stopwatch.gaps[std::size_t(double(stopwatch.gaps.size() - 1) * part)]; };
    std::printf("processor of the window            %8.1f %% of a core (aim: under 15)\n", share);
    std::printf("longest turn of the event loop     %8.1f ms (aim: at most 50)\n", stopwatch.gaps.back());
    std::printf("99.9 %% of the turns                %8.1f ms\n", at(0.999));
    std::printf("requests per second                %8d\n", harness.window.controller().statistics().requestsPerSecond);
    simulator.kill();
    simulator.waitForFinished();
    return 0;
}
