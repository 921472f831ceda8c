// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/harness.h"
#include "ui/pages/page.h"
#include <QDialog>
#include <QDir>
#include <QPushButton>

/// The window on one of its pages, used as a person does.
struct Room {
    explicit Room(const char *pageId) : id {pageId}
    {
        harness.window.resize(1440, 900);
        QDir().mkpath(QStringLiteral(PENDESK_PICTURES));
    }
    virtual ~Room() = default;

    /// Connected as an engineer; a real controller unless it is a simulation.
    [[nodiscard]] bool open(bool isSimulation = true)
    {
        if (!harness.startController())
            return false;
        settings::Profile profile = harness.profile();
        profile.isSimulation = isSimulation;
        return open(profile);
    }
    [[nodiscard]] bool open(settings::Profile profile)
    {
        profile.readTimeout = std::chrono::milliseconds {1000}; // the computer may be busy
        harness.window.show();
        harness.window.connectTo(profile);
        harness.access().enter(robot::Level::Engineer);
        auto *entry = harness.window.findChild<QPushButton *>(QLatin1String(id) + QStringLiteral("Entry"));
        if (!entry || !QTest::qWaitForWindowExposed(&harness.window))
            return false;
        QTest::mouseClick(entry, Qt::LeftButton);
        page = harness.window.view().findChild<pages::Page *>(QLatin1String(id) + QStringLiteral("Page"));
        if (!page || !activate()) // keys go where the focus is
            return false;
        return QTest::qWaitFor(
            [this] { return harness.window.controller().linkState() == robot::LinkState::Monitoring && isLive(); });
    }

    /// What the page shows first was read.
    [[nodiscard]] virtual bool isLive() const { return true; }

    template <typename Widget> [[nodiscard]] Widget *find(const char *name) const
    {
        return page->findChild<Widget *>(QLatin1String(name));
    }
    /// The window in front, as the desktop would put it after a dialog.
    [[nodiscard]] bool activate()
    {
        harness.window.activateWindow();
        return QTest::qWaitForWindowActive(&harness.window);
    }
    [[nodiscard]] QDialog *dialog(const char *name) const
    {
        for (auto *one : harness.window.findChildren<QDialog *>(QLatin1String(name))) {
            if (one->isVisible())
                return one;
        }
        return nullptr;
    }
    void click(const char *name) const { QTest::mouseClick(find<QPushButton>(name), Qt::LeftButton); }
    /// Of the window, or of a dialog, in both looks. It begins with the present one and stays in the other: a change of
    /// the look takes a second, in which nothing is read.
    void picture(const QString &name, QWidget *what = nullptr)
    {
        const auto take = [&](ui::Scheme scheme) {
            const QString mode = scheme == ui::Scheme::Light ? QStringLiteral("light") : QStringLiteral("dark");
            const QString path = QStringLiteral("%1/%2-%3.png").arg(QStringLiteral(PENDESK_PICTURES), name, mode);
            QVERIFY((what ? what : &harness.window)->grab().save(path));
        };
        const ui::Scheme present = ui::schemeOf(QApplication::palette());
        const ui::Scheme other = present == ui::Scheme::Light ? ui::Scheme::Dark : ui::Scheme::Light;
        take(present);
        ui::apply(*qApp, other);
        QCoreApplication::sendPostedEvents();
        take(other);
    }
    [[nodiscard]] virtualcontroller::Memory &memory() const { return harness.server->memory(); }

    const char *id;
    Harness harness;
    pages::Page *page = nullptr;
};
