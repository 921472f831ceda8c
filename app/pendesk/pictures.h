// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

namespace ui {
class MainWindow;
}

namespace pendesk {

/// Pictures of every page, light and dark: not connected, then live as soon as everything on the page was read. The
/// status that was read goes to the output stream. Without a live controller within 20 s there is a sentence instead.
class Pictures : public QObject
{
    Q_OBJECT

public:
    /// `folder` is made if it is missing. `window` must outlive this.
    Pictures(ui::MainWindow &window, const QString &folder, QObject *parent = nullptr);

    /// The window offers the controller but is not connected. Connects, and ends the application with an ExitCode.
    void start();

private:
    void look();
    [[nodiscard]] bool isLive() const;
    [[nodiscard]] bool take(const QString &state);
    void printStatus() const;
    void end(int exitCode);

    ui::MainWindow &m_window;
    QString m_folder;
    QTimer m_look;
    QTimer m_deadline;
};

} // namespace pendesk
