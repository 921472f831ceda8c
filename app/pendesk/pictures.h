// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/theme.h"
#include <QObject>
#include <QTimer>

namespace ui {
class MainWindow;
}

namespace pendesk {

/// Pictures of every page, light and dark: not connected, then live, each as soon as everything on it was read. The
/// status that was read goes to the output stream. A page that is not read within 5 s ends it with a sentence instead.
class Pictures : public QObject
{
    Q_OBJECT

public:
    /// `folder` is made if it is missing. `window` must outlive this.
    Pictures(ui::MainWindow &window, const QString &folder, QObject *parent = nullptr);

    /// The window offers the controller but is not connected. Connects, and ends the application with an ExitCode.
    void start();

private:
    void dress(ui::Scheme scheme);
    void turnTo(int row);
    void look();
    void giveUp();
    [[nodiscard]] bool isLive() const;
    [[nodiscard]] bool take(int row, const QString &state) const;
    [[nodiscard]] bool takeAll(const QString &state);
    void printStatus() const;
    void end(int exitCode);

    ui::MainWindow &m_window;
    QString m_folder;
    ui::Scheme m_scheme = ui::Scheme::Light;
    int m_row = 0; ///< In the page catalogue: the page whose picture is next.
    QTimer m_look;
    QTimer m_deadline;
};

} // namespace pendesk
