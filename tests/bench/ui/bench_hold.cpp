// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
//
// From the press of HOLD, a button of a real window, to its datagram, while the program has other things to do:
// nothing, a transfer, repaints at 20 Hz, a locked journal, settings that another program holds, a disk that does not
// answer. Prints median, 99th percentile and maximum of each, and their ratio to doing nothing; nothing here passes or
// fails. bench_hold [presses]
#include "ui/harness.h"

#include "disk/worker.h"
#include "files/collection.h"
#include <QElapsedTimer>
#include <QEventLoop>
#include <QLockFile>
#include <QPushButton>
#include <QSemaphore>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QUdpSocket>
#include <algorithm>
#include <cstdio>

using namespace std::chrono_literals;

namespace {

constexpr quint16 holdCommand = 0x83;

/// What a program does besides; it goes on until it is destroyed.
using Load = std::function<std::shared_ptr<void>(Harness &)>;

/// Milliseconds from the press to the datagram at the controller, for each press.
std::vector<double> presses(Harness &harness, int count)
{
    auto *hold = harness.window.findChild<QAbstractButton *>(QStringLiteral("holdButton"));
    std::vector<double> times;
    for (int press = 0; press < count; ++press) {
        const int before = harness.server->arrived(holdCommand);
        QElapsedTimer timer;
        timer.start();
        QTest::mousePress(hold, Qt::LeftButton);
        while (harness.server->arrived(holdCommand) == before && timer.elapsed() < 10'000)
            QCoreApplication::processEvents(QEventLoop::AllEvents, 1);
        times.push_back(double(timer.nsecsElapsed()) / 1e6);
        QTest::mouseRelease(hold, Qt::LeftButton);
        (void)QTest::qWaitFor([&] { return harness.window.controller().linkState() == robot::LinkState::Monitoring; });
        QEventLoop pause; // the repeats of this press end, and the values come again
        QTimer::singleShot(50ms, &pause, &QEventLoop::quit);
        pause.exec();
    }
    std::ranges::sort(times);
    return times;
}

void print(const char *name, const std::vector<double> &times, double idle)
{
    const auto at = [&](double part) { return times[std::size_t(double(times.size() - 1) * part)]; };
    std::printf(
        "%-34s %8.2f %8.2f %8.2f ms   p99 of idle's %7.2f\n", name, at(0.5), at(0.99), times.back(), at(0.99) / idle);
    std::fflush(stdout);
}

std::shared_ptr<void> nothing(Harness &) { return {}; }

std::shared_ptr<void> transfers(Harness &harness)
{
    harness.server->memory().files["BIG.JBI"] = QByteArray(5 << 20, 'x');
    auto list = std::make_shared<files::Collection>(*harness.window.controller().files(),
        [](const values::FileName &, const QByteArray &) { return values::Result<void> {}; });
    list->start();
    return list;
}

std::shared_ptr<void> repaints(Harness &harness)
{
    auto timer = std::make_shared<QTimer>();
    QObject::connect(timer.get(), &QTimer::timeout, &harness.window, [&harness] {
        for (QWidget *widget : harness.window.findChildren<QWidget *>())
            widget->update();
    });
    timer->start(50ms);
    return timer;
}

/// An order is appended all the time, so that the journal always has something to write.
std::shared_ptr<void> lockedJournal(Harness &harness)
{
    struct Lock {
        Lock(const QString &path)
        {
            auto database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("bench"));
            database.setDatabaseName(path);
            if (!database.open() || !QSqlQuery(database).exec(QStringLiteral("BEGIN EXCLUSIVE")))
                std::printf("the journal could not be locked\n");
        }
        ~Lock() { QSqlDatabase::removeDatabase(QStringLiteral("bench")); }
        QTimer timer;
    };
    auto lock = std::make_shared<Lock>(harness.folder.filePath(QStringLiteral("journal.sqlite")));
    QObject::connect(&lock->timer, &QTimer::timeout, &harness.window, [&harness] { harness.journal.append({}); });
    lock->timer.start(20ms);
    return lock;
}

std::shared_ptr<void> heldSettings(Harness &harness)
{
    struct Lock {
        Lock(const QString &path) : file {path} { file.lock(); }
        QLockFile file;
        QTimer timer;
        int number = 0;
    };
    auto lock = std::make_shared<Lock>(harness.folder.filePath(QStringLiteral("settings.json.lock")));
    QObject::connect(&lock->timer, &QTimer::timeout, &harness.window,
        [&harness, raw = lock.get()] { harness.file.setValue(QStringLiteral("bench"), ++raw->number); });
    lock->timer.start(20ms);
    return lock;
}

/// Work for a disk that does not answer for half a second each time.
std::shared_ptr<void> slowDisk(Harness &harness)
{
    struct Disk {
        ~Disk() { answered.release(1'000'000); }
        QSemaphore answered;
        QTimer timer;
        disk::Worker worker;
    };
    auto disk = std::make_shared<Disk>();
    const auto order = [disk = disk.get(), &harness] {
        disk->worker.run(
            &harness.window, [disk] { return disk->answered.tryAcquire(1, 500); }, [](bool) {});
    };
    QObject::connect(&disk->timer, &QTimer::timeout, &harness.window, order);
    disk->timer.start(50ms);
    return disk;
}

} // namespace

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    const int count = argc > 1 ? std::atoi(argv[1]) : 200;
    const std::pair<const char *, Load> loads[] {{"nothing else", nothing}, {"a transfer", transfers},
        {"repaints at 20 Hz", repaints}, {"a locked journal", lockedJournal},
        {"settings held by another program", heldSettings}, {"a disk that does not answer", slowDisk}};
    std::printf("%d presses each%27s %8s %8s\n", count, "median", "p99", "maximum");
    double idle = 0;
    for (const auto &[name, load] : loads) {
        Harness harness;
        if (!harness.connectLive())
            return 1;
        const auto besides = load(harness);
        const auto times = presses(harness, count);
        if (idle == 0)
            idle = times[std::size_t(double(times.size() - 1) * 0.99)];
        print(name, times, idle);
    }
    return 0;
}
