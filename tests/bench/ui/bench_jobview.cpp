// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
// What it costs to open a job of 10,000 lines, from its bytes to the first paint with highlighting. It judges nothing.
#include "inform/job.h"
#include "ui/widgets/jobview.h"
#include <QApplication>
#include <QElapsedTimer>
#include <cstdio>

namespace {

/// 2,000 steps, each followed by four other lines.
QByteArray longJob()
{
    QByteArray points;
    QByteArray lines;
    for (int step = 0; step < 2000; ++step) {
        const QByteArray n = QByteArray::number(step);
        const QByteArray name = 'C' + n.rightJustified(5, '0');
        points += name + '=' + n + ",200,-300,0,500,0\r\n";
        lines += "MOVL " + name + " V=150.0\r\nDOUT OT#(" + n + ") ON\r\nWAIT IN#(12)=ON T=1.50\r\n'STEP " + n
            + " OF THIS JOB\r\nSET D001  EXPRESS D002 * 2 - " + n + "\r\n";
    }
    return "/JOB\r\n//NAME LONG\r\n//POS\r\n///NPOS 2000,0,0,0,0,0\r\n///TOOL 0\r\n///POSTYPE PULSE\r\n///PULSE\r\n"
        + points + "//INST\r\n///ATTR SC,RW\r\n///GROUP1 RB1\r\nNOP\r\n" + lines + "END\r\n";
}

} // namespace

int main(int argc, char *argv[])
{
    const QApplication application {argc, argv};
    const QByteArray content = longJob();
    widgets::JobView view;
    view.resize(600, 800);
    view.show();
    QApplication::processEvents();
    QElapsedTimer clock;
    clock.start();
    const inform::Job job = inform::parse(content);
    QStringList lines;
    for (int line = 0; line < job.lineCount(); ++line)
        lines << QString::fromLatin1(job.at(line).text);
    const double reading = double(clock.nsecsElapsed()) / 1e6;
    view.showLines(lines, job.aliases);
    (void)view.grab();
    std::printf("opening %d lines: %.1f ms to the first paint with highlighting, %.1f ms of it reading\n",
        job.lineCount(), double(clock.nsecsElapsed()) / 1e6, reading);
    return 0;
}
