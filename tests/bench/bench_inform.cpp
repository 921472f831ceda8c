// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
// What jobs cost: reading and checking a few megabytes of them, comparing two backups of 500 jobs. It prints a table
// and judges nothing; the floor of reading is a pass over the same bytes that looks for line ends.
#include "inform/check.h"
#include "inform/jobdiff.h"
#include "support/jobs.h"
#include <QDir>
#include <QElapsedTimer>
#include <cstdio>

namespace {

/// All valid jobs of the test data, one after another, `megabytes` of them.
QList<QByteArray> jobsOfMegabytes(double megabytes)
{
    const QStringList names =
        QDir {QStringLiteral(PENDESK_TEST_DATA "/jobs")}.entryList({QStringLiteral("*.JBI")}, QDir::Files);
    QList<QByteArray> jobs;
    qsizetype size = 0;
    while (double(size) < megabytes * 1e6) {
        jobs << testdata::job(names[jobs.size() % names.size()]);
        size += jobs.last().size();
    }
    return jobs;
}

/// A job of `steps` steps, each followed by four other lines; with `version` 1, one step in ten goes elsewhere, and a
/// step more comes first.
QByteArray longJob(int steps, int version)
{
    QByteArray points;
    QByteArray lines;
    int number = 0;
    const auto addStep = [&](int value) {
        const QByteArray name = 'C' + QByteArray::number(number++).rightJustified(5, '0');
        points += name + '=' + QByteArray::number(value) + ",200,-300,0,500,0\r\n";
        lines += "MOVL " + name + " V=150.0\r\n";
    };
    if (version > 0)
        addStep(-1);
    for (int step = 0; step < steps; ++step) {
        addStep(step * 7 + (version > 0 && step % 10 == 0 ? 3 : 0));
        const QByteArray n = QByteArray::number(step);
        lines += "DOUT OT#(" + n + ") ON\r\nWAIT IN#(12)=ON T=1.50\r\n'STEP " + n
            + " OF THIS JOB\r\nSET D001  EXPRESS D002 * 2 - " + n + "\r\n";
    }
    return "/JOB\r\n//NAME LONG\r\n//POS\r\n///NPOS " + QByteArray::number(number)
        + ",0,0,0,0,0\r\n///TOOL 0\r\n///POSTYPE PULSE\r\n///PULSE\r\n" + points
        + "//INST\r\n///DATE 2026/03/02 10:15\r\n///ATTR SC,RW\r\n///GROUP1 RB1\r\nNOP\r\n" + lines + "END\r\n";
}

double milliseconds(const QElapsedTimer &clock) { return double(clock.nsecsElapsed()) / 1e6; }

void benchReading()
{
    const auto jobs = jobsOfMegabytes(5);
    qsizetype bytes = 0;
    qsizetype found = 0;
    QElapsedTimer clock;
    clock.start();
    for (const QByteArray &job : jobs) {
        found += job.count("\r\n");
        bytes += job.size();
    }
    const double floor = milliseconds(clock);
    clock.start();
    for (const QByteArray &job : jobs)
        found += inform::parse(job).lineCount();
    const double reading = milliseconds(clock);
    clock.start();
    for (const QByteArray &job : jobs)
        found += inform::check(inform::parse(job)).size();
    const double checking = milliseconds(clock);
    std::printf("reading   %8.1f MB/s   (%lld jobs, %.1f times the search for line ends)\n",
        double(bytes) / 1e3 / reading, jobs.size(), reading / floor);
    std::printf("checking  %8.1f MB/s   (reading included; %lld)\n", double(bytes) / 1e3 / checking, found);
}

void benchComparing()
{
    QElapsedTimer clock;
    clock.start();
    qsizetype edits = 0;
    for (int job = 0; job < 500; ++job)
        edits += inform::diffJobs(inform::parse(longJob(40, 0)), inform::parse(longJob(40, 1))).size();
    std::printf("comparing %8.1f ms     (500 pairs of jobs with 40 steps, all of them different; %lld edits)\n",
        milliseconds(clock), edits);
}

} // namespace

int main()
{
    benchReading();
    benchComparing();
    return 0;
}
