// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
// What a trend costs: five minutes of eight signals at 10 Hz, recorded and drawn four times a second. It prints a table
// and judges nothing. The bare loop beside it walks over the same samples once, to compare machines.
#include "trend/decimate.h"
#include "ui/theme.h"
#include "ui/widgets/plot.h"
#include <QApplication>
#include <chrono>
#include <cstdio>
#include <ctime>

using namespace std::chrono_literals;
using trend::Track;

namespace {

constexpr trend::Moment zero {1'800'000'000'000ms};
constexpr int samples = 3000; ///< Five minutes at 10 Hz.
constexpr int frames = 100;
constexpr int framesPerSecond = 4;

std::vector<Track> tracks()
{
    std::vector<Track> result;
    for (int t = 0; t < widgets::Plot::mostTracks; ++t) {
        Track track {{}, QStringLiteral("R1 %1").arg(t), t < 6 ? trend::Unit::Millimetre : trend::Unit::Plain,
            trend::Series {samples * 2}};
        for (int i = 0; i < samples + frames; ++i)
            track.series.append(zero + i * 100ms, 300 * std::sin(i / (20.0 + t)) + i * 37 % 23);
        result.push_back(std::move(track));
    }
    return result;
}

/// Milliseconds of this process's time for one call.
template <typename Function> double cost(int rounds, Function function)
{
    const std::clock_t begin = std::clock();
    for (int i = 0; i < rounds; ++i)
        function(i);
    return double(std::clock() - begin) * 1000 / CLOCKS_PER_SEC / rounds;
}

trend::Range window(int frame) { return {zero + frame * 100ms, zero + frame * 100ms + 300s}; }

} // namespace

int main(int argc, char *argv[])
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    const std::vector<Track> given = tracks();
    std::vector<const Track *> shown;
    for (const Track &track : given)
        shown.push_back(&track);

    double sum = 0;
    const double bare = cost(frames, [&](int) {
        for (const Track &track : given) {
            for (const trend::Sample &sample : track.series.samples())
                sum += sample.value;
        }
    });
    const double thinning = cost(frames, [&](int frame) {
        for (const Track &track : given)
            sum += double(trend::decimate(track.series, window(frame), 1000).size());
    });

    widgets::Plot plot;
    plot.resize(1120, 520);
    plot.show();
    plot.show(shown, window(0), window(0).to);
    QCoreApplication::processEvents();
    const double drawing = cost(frames, [&](int frame) {
        plot.show(shown, window(frame), window(frame).to);
        QCoreApplication::processEvents();
        plot.viewport()->repaint();
    });

    std::printf("eight signals, %d samples each, %d x %d pixels\n", samples, plot.width(), plot.height());
    std::printf("  %-34s %8.3f ms\n", "bare loop over the samples", bare);
    std::printf("  %-34s %8.3f ms  %6.1f bare loops\n", "thinned to 1000 columns", thinning, thinning / bare);
    std::printf("  %-34s %8.3f ms  %6.1f bare loops\n", "one picture, thinned and painted", drawing, drawing / bare);
    std::printf("  %-34s %8.1f %% of one core\n", "four pictures a second", drawing * framesPerSecond / 10);
    return sum == 0;
}
