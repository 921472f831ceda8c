// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "disk/worker.h"

#include <QSemaphore>
#include <QSignalSpy>
#include <QTest>
#include <QThread>

using namespace std::chrono_literals;
using disk::IsWanted;
using disk::Worker;

namespace {

/// Work that stands still, as on a disk that does not answer, until it is let go.
struct SlowDisk {
    std::shared_ptr<QSemaphore> entered = std::make_shared<QSemaphore>();
    std::shared_ptr<QSemaphore> answered = std::make_shared<QSemaphore>();

    [[nodiscard]] auto work() const
    {
        return [entered = entered, answered = answered] {
            entered->release();
            answered->acquire();
            return 1;
        };
    }
};

} // namespace

class TestWorker : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void worksElsewhereAndAnswersHere()
    {
        Worker worker;
        QObject context;
        QList<int> answers;
        const QThread *here = QThread::currentThread();
        for (int i = 0; i < 3; ++i) {
            worker.run(
                &context, [i, here] { return QThread::currentThread() == here ? -1 : i; },
                [&, here](int answer) { answers << (QThread::currentThread() == here ? answer : -2); });
        }
        QVERIFY(answers.isEmpty()); // never from within run()
        QTRY_COMPARE(answers, (QList<int> {0, 1, 2}));
    }

    void whoOrdersNeverWaits()
    {
        const SlowDisk disk;
        QObject outlivesAll;
        int answers = 0;
        {
            QObject context;
            Worker worker;
            worker.run(&context, disk.work(), [&](int) { ++answers; });
            worker.run(&outlivesAll, disk.work(), [&](int) { ++answers; });
            disk.entered->acquire();
            QVERIFY(!worker.waitForDone(1ms));
        } // the disk still does not answer
        disk.answered->release(2);
        QCoreApplication::processEvents();
        QCOMPARE(answers, 0);
        QCOMPARE(disk.entered->available(), 0); // the second was never begun
    }

    void aContextThatIsGoneHearsNothing()
    {
        const SlowDisk disk;
        Worker worker;
        auto context = std::make_unique<QObject>();
        bool isTold = false;
        bool isDone = false;
        worker.run(context.get(), disk.work(), [&](int) { isTold = true; });
        worker.run(
            context.get(), [&] { return isDone = true; }, [&](bool) { isTold = true; });
        disk.entered->acquire();
        context.reset();
        disk.answered->release();
        QVERIFY(worker.waitForDone(20s));
        QCoreApplication::processEvents();
        QVERIFY(!isTold);
        QVERIFY(!isDone); // nobody wanted it any more
    }

    void longWorkHearsThatItIsNotWanted()
    {
        Worker worker;
        QSemaphore begun;
        QSemaphore ended;
        auto context = std::make_unique<QObject>();
        const auto untilUnwanted = [&](const IsWanted &isWanted) {
            begun.release();
            while (isWanted())
                QThread::yieldCurrentThread();
            ended.release();
            return 0;
        };
        worker.run(context.get(), untilUnwanted, [](int) {});
        begun.acquire();
        context.reset();
        ended.acquire();
        auto *other = new Worker;
        QFuture<int> future = other->run(untilUnwanted);
        begun.acquire();
        delete other;
        ended.acquire();
    }

    void theEndIsOnTheThreadToo()
    {
        const QThread *worked = nullptr;
        const QThread *ended = nullptr;
        Worker worker {[&] { ended = QThread::currentThread(); }};
        const auto done = worker.run([&] { return (worked = QThread::currentThread()) != nullptr; });
        QVERIFY(worker.waitForDone(20s));
        QVERIFY(done.result());
        worker.end(20s);
        QVERIFY(ended);
        QCOMPARE(ended, worked);
    }
};

QTEST_GUILESS_MAIN(TestWorker)
#include "tst_worker.moc"
