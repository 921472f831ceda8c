// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/conditionwords.h"
#include "ui/harness.h"
#include "ui/pagecatalog.h"
#include "ui/pages/jobspage.h"
#include "virtualcontroller/machine.h"

#include <QAbstractButton>
#include <QDialog>
#include <QLabel>

/// The Jobs page with a controller at rest: servo on, WELD_A12 selected, Operate or Engineer, and a person who clicks.
class JobsHarness : public Harness
{
public:
    /// Patient with a busy computer: a link that is given up disarms.
    JobsHarness() { readTimeout = std::chrono::milliseconds {300}; }

    /// Why "Start" is not possible, and why arming dropped.
    [[nodiscard]] QString armingText() const
    {
        const auto &drop = orders().lastDrop();
        return text("reason-start") + u' ' + (drop ? ui::reason(drop->reason) : QString());
    }
    [[nodiscard]] bool openJobs(robot::Level level = robot::Level::Engineer)
    {
        if (!connectLive())
            return false;
        rest();
        access().enter(level);
        click("jobsEntry");
        const auto isListed = [this] { return list()->model()->rowCount() > 0; };
        return QTest::qWaitFor(isListed)
            && QTest::qWaitFor([this] { return orders().situation().status && !running(); });
    }
    /// As after a job that has ended.
    void rest()
    {
        using values::Status;
        virtualcontroller::Memory &memory = server->memory();
        memory.isJobRunning = false;
        memory.servoOnAt.reset();
        memory.status = Status {Status::Data1 {Status::Remote} | Status::Play | Status::Continuous, Status::ServoOn};
        memory.settings.servoDelay = std::chrono::milliseconds {0};
        virtualcontroller::selectJob(memory, 0, "WELD_A12", 0);
    }
    [[nodiscard]] bool running() const
    {
        const auto &status = orders().situation().status;
        return status && status->isRunning();
    }
    [[nodiscard]] robot::Orders &orders() const { return window.view().orders(); }
    static int pageRow()
    {
        const auto rows = ui::pageCatalog();
        const auto found = std::ranges::find_if(
            rows, [](const ui::PageRow &row) { return QLatin1String(row.id) == QLatin1String("jobs"); });
        return int(found - rows.begin());
    }
    [[nodiscard]] pages::Page *page() const { return window.view().page(pageRow()); }
    [[nodiscard]] QAbstractItemView *list() const
    {
        return page()->findChild<QAbstractItemView *>(QStringLiteral("jobList"));
    }
    /// On the page first: other pages can be armed too.
    template <typename Widget = QWidget> [[nodiscard]] Widget *find(const char *name) const
    {
        auto *found = page()->findChild<Widget *>(QLatin1String(name));
        return found ? found : window.findChild<Widget *>(QLatin1String(name));
    }
    void click(const char *name) const { QTest::mouseClick(find(name), Qt::LeftButton); }
    [[nodiscard]] QString text(const char *name) const { return find<QLabel>(name)->text(); }
    /// That is open; one that was answered goes a little later.
    [[nodiscard]] QDialog *sheet() const
    {
        for (auto *one : window.findChildren<QDialog *>(QStringLiteral("startSheet"))) {
            if (one->isVisible())
                return one;
        }
        return nullptr;
    }

    /// Three boxes, and the button for a second.
    [[nodiscard]] bool arm() const
    {
        for (const char *box : {"armNobody", "armSight", "armStop"}) {
            if (!find<QAbstractButton>(box)->isChecked())
                find<QAbstractButton>(box)->click();
        }
        QTest::mousePress(find("arm"), Qt::LeftButton);
        const bool isArmed = QTest::qWaitFor([this] { return arming.isArmed(); }, 2500);
        QTest::mouseRelease(find("arm"), Qt::LeftButton);
        return isArmed;
    }
    /// The way to a sheet whose button works.
    [[nodiscard]] bool openSheet() const
    {
        const bool canOpen = QTest::qWaitFor([this] { return find("start")->isEnabled(); });
        click("start");
        return canOpen && sheet() && QTest::qWaitFor([this] { return find("sheetStart")->isEnabled(); });
    }
    void choose(const QString &job) const
    {
        const QModelIndexList found = list()->model()->match(
            list()->model()->index(0, 0), Qt::DisplayRole, job, 1, Qt::MatchExactly | Qt::MatchCaseSensitive);
        if (!found.isEmpty())
            QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, list()->visualRect(found.first()).center());
    }
};
