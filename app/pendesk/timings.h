// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QObject>

namespace ui {
class MainWindow;
}

namespace pendesk {

/// For --timings: prints when the window was painted first and when the first status was live, in nanoseconds of the
/// monotonic clock, each once: "first-paint 123". A benchmark that started the program knows when that was.
class Timings : public QObject
{
    Q_OBJECT

public:
    explicit Timings(ui::MainWindow &window);

    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void watchStatus();

    ui::MainWindow &m_window;
    bool m_isPainted = false;
    bool m_isLive = false;
};

} // namespace pendesk
