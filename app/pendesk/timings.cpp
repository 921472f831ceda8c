// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "timings.h"

#include "robot/controller.h"
#include "ui/mainwindow.h"
#include <QEvent>
#include <QTimer>
#include <chrono>
#include <cstdio>

namespace pendesk {

namespace {

void tell(const char *what)
{
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    std::printf("%s %lld\n", what, static_cast<long long>(std::chrono::nanoseconds {now}.count()));
    std::fflush(stdout);
}

} // namespace

Timings::Timings(ui::MainWindow &window) : m_window {window} { window.installEventFilter(this); }

bool Timings::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Paint && !std::exchange(m_isPainted, true)) {
        QTimer::singleShot(0, this, [this] { // behind the painting that begins now
            tell("first-paint");
            watchStatus();
        });
    }
    return QObject::eventFilter(watched, event);
}

void Timings::watchStatus()
{
    const auto look = [this] {
        const auto &state = m_window.controller().state();
        if (state.freshness(robot::topics::status) == robot::Freshness::Live && !std::exchange(m_isLive, true))
            tell("first-live");
    };
    look();
    connect(&m_window.controller().state(), &robot::RobotState::changed, this, look);
}

} // namespace pendesk
