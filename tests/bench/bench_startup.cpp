// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
//
// What the window costs: from the start of the process to the first paint and to the first live status, warm and (as
// root, who may empty the page cache) cold, the processor while it watches the demo at 10 Hz, and the peak of its
// memory. Prints medians; nothing here passes or fails.
#include <QCoreApplication>
#include <QFile>
#include <QProcess>
#include <QThread>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <unistd.h>
#include <vector>

namespace {

constexpr int rounds = 11;
constexpr int coldRounds = 3;
constexpr int watchSeconds = 5;

qint64 now() { return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds {1}; }

double median(std::vector<double> samples)
{
    std::ranges::sort(samples);
    return samples[samples.size() / 2];
}

QByteArray contentOf(const QString &path)
{
    QFile file {path};
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray {};
}

/// User and system time of a process so far, in seconds.
double processorTime(qint64 pid)
{
    const QByteArray stat = contentOf(QStringLiteral("/proc/%1/stat").arg(pid));
    const auto fields = stat.mid(stat.lastIndexOf(')') + 2).split(' ');
    return (fields.value(11).toDouble() + fields.value(12).toDouble()) / double(sysconf(_SC_CLK_TCK));
}

double peakMemory(qint64 pid)
{
    for (const QByteArray &line : contentOf(QStringLiteral("/proc/%1/status").arg(pid)).split('\n')) {
        if (line.startsWith("VmHWM:"))
            return line.mid(6).simplified().split(' ').value(0).toDouble() / 1024;
    }
    return 0;
}

struct Figures {
    double firstPaint = 0; ///< Milliseconds.
    double firstLive = 0;
    double processor = 0; ///< Percent of a core.
    double memory = 0; ///< MiB.
};

Figures watchOnce(int seconds)
{
    Figures figures;
    QProcess pendesk;
    pendesk.setProcessChannelMode(QProcess::SeparateChannels);
    const qint64 begin = now();
    pendesk.start(QStringLiteral(PENDESK_BIN "/pendesk"), {QStringLiteral("--demo"), QStringLiteral("--timings")});
    QByteArray heard;
    while (!heard.contains("first-live") && pendesk.waitForReadyRead(20000))
        heard += pendesk.readAllStandardOutput();
    for (const QByteArray &line : heard.split('\n')) {
        const double at = double(line.split(' ').value(1).toLongLong() - begin) / 1e6;
        if (line.startsWith("first-paint"))
            figures.firstPaint = at;
        else if (line.startsWith("first-live"))
            figures.firstLive = at;
    }
    QThread::sleep(1);
    const double before = processorTime(pendesk.processId());
    QThread::sleep(static_cast<unsigned long>(seconds));
    figures.processor = (processorTime(pendesk.processId()) - before) / seconds * 100;
    figures.memory = peakMemory(pendesk.processId());
    pendesk.kill();
    pendesk.waitForFinished();
    return figures;
}

void row(const char *what, double value, const char *unit, const char *aim)
{
    std::printf("%-40s %8.1f %-12s (aim: at most %s)\n", what, value, unit, aim);
}

/// Nothing of the program and its libraries is in memory afterwards. Only root may do that.
bool emptyPageCache()
{
    ::sync();
    QFile file {QStringLiteral("/proc/sys/vm/drop_caches")};
    return file.open(QIODevice::WriteOnly | QIODevice::Unbuffered) && file.write("3") == 1;
}

void measureColdStart()
{
    std::vector<double> paints;
    for (int round = 0; round < coldRounds && emptyPageCache(); ++round)
        paints.push_back(watchOnce(0).firstPaint);
    if (paints.empty())
        std::printf("cold start to first paint: not measured, only root may empty the page cache\n");
    else
        std::printf("%-40s %8.1f ms\n", "cold start to first paint", median(paints));
}

} // namespace

int main(int argc, char *argv[])
{
    const QCoreApplication application {argc, argv};
    std::vector<double> paints;
    std::vector<double> lives;
    watchOnce(0); // warms the file cache
    for (int round = 0; round < rounds; ++round) {
        const Figures figures = watchOnce(0);
        paints.push_back(figures.firstPaint);
        lives.push_back(figures.firstLive);
    }
    measureColdStart();
    const Figures watched = watchOnce(watchSeconds);
    row("start to first paint", median(paints), "ms", "200");
    row("start to first live status", median(lives), "ms", "400");
    row("processor while watching at 10 Hz", watched.processor, "% of a core", "5");
    row("peak memory, demo controller included", watched.memory, "MiB", "80");
    return 0;
}
