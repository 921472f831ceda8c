// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "contactsheet.h"
#include "ui/theme.h"
#include <QObject>
#include <QTimer>
#include <optional>

namespace ui {
class MainWindow;
}

namespace pendesk {

/// Walks through all pages and takes a picture of each as soon as everything on it was read, light and dark. A page
/// that is not read within 5 s ends it with a sentence instead.
class Pictures : public QObject
{
    Q_OBJECT

public:
    /// `window` must outlive this.
    explicit Pictures(ui::MainWindow &window, QObject *parent = nullptr);

    /// Both connect the controller that the window offers, and end the application with an ExitCode.
    /// A file for each page, not connected and live; the status that was read goes to the output stream. `folder` is
    /// made if it is missing.
    void writeFiles(const QString &folder);
    /// One file with all live pages in all of the languages.
    void writeSheet(const QString &path, const QStringList &languages);

private:
    /// Once through all pages.
    struct Walk {
        QString language; ///< Empty: the one that is spoken.
        ui::Scheme scheme;
    };

    void start();
    void dress(ui::Scheme scheme);
    void begin(int walk);
    void turnTo(int row);
    void look();
    void giveUp();
    [[nodiscard]] bool isLive() const;
    [[nodiscard]] bool take();
    [[nodiscard]] bool save(int row, const QString &state) const;
    [[nodiscard]] bool saveAll(const QString &state);
    void finish();
    void printStatus() const;
    void fail(const QString &sentence, int exitCode);
    void end(int exitCode);

    ui::MainWindow &m_window;
    QString m_path; ///< The folder, or the sheet's file.
    std::optional<ContactSheet> m_sheet;
    QList<Walk> m_walks;
    ui::Scheme m_scheme = ui::Scheme::Light;
    int m_walk = 0;
    int m_row = 0; ///< In the page catalogue: the page whose picture is next.
    QTimer m_look;
    QTimer m_deadline;
};

} // namespace pendesk
