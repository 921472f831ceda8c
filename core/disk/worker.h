// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QFutureWatcher>
#include <QPromise>
#include <chrono>
#include <concepts>
#include <functional>
#include <memory>

namespace disk {

/// Says whether the answer of a piece of work is still wanted. Long work asks between two files.
using IsWanted = std::function<bool()>;

/// Does what may wait for a disk, one piece after another, on a thread of its own: values in, values out. Who orders
/// work never waits for it, however slow the disk is.
class Worker
{
public:
    /// `atEnd` runs on the thread when everything else is over.
    explicit Worker(std::function<void()> atEnd = {});
    /// Work that has not begun is dropped. Nobody waits for work under way: it is told that it is not wanted, and
    /// ends by itself.
    ~Worker();
    Q_DISABLE_COPY_MOVE(Worker)

    /// Work takes nothing, or an IsWanted. It returns a value, which `then` gets on the thread of `context`, from the
    /// event loop. If the context is gone by then nobody is told, and work that has not begun is not done.
    template <typename Work, typename Then> void run(QObject *context, Work work, Then then);

    /// The same for who wants to ask for the value. Destroying the future changes nothing; cancelling it does.
    template <typename Work> [[nodiscard]] auto run(Work work);

    /// Whether all that was ordered is done within that time. This and end() are the only calls that wait; for the end
    /// of the program.
    [[nodiscard]] bool waitForDone(std::chrono::milliseconds most);
    /// As the destructor; and waits until the thread has ended, but no longer than that.
    void end(std::chrono::milliseconds most);

private:
    struct Queue;

    void close();
    void post(std::function<void()> task);
    [[nodiscard]] static IsWanted isOpen(const std::shared_ptr<Queue> &queue);
    static void work(const std::shared_ptr<Queue> &queue);

    template <typename Work> static auto call(Work &work, const IsWanted &isWanted)
    {
        if constexpr (std::invocable<Work &, const IsWanted &>)
            return work(isWanted);
        else
            return work();
    }

    std::shared_ptr<Queue> m_queue; ///< Shared with the thread, which may outlive the worker.
};

template <typename Work> auto Worker::run(Work work)
{
    using Value = decltype(call(work, IsWanted {}));
    const auto promise = std::make_shared<QPromise<Value>>();
    promise->start();
    post([promise, work = std::move(work), isOpen = isOpen(m_queue)]() mutable {
        if (!promise->isCanceled())
            promise->addResult(call(work, [&] { return !promise->isCanceled() && isOpen(); }));
        promise->finish();
    });
    return promise->future();
}

template <typename Work, typename Then> void Worker::run(QObject *context, Work work, Then then)
{
    using Value = decltype(call(work, IsWanted {}));
    auto *watcher = new QFutureWatcher<Value> {context};
    QFuture<Value> future = run(std::move(work));
    QObject::connect(watcher, &QObject::destroyed, [future]() mutable { future.cancel(); });
    QObject::connect(watcher, &QFutureWatcherBase::finished, context, [watcher, then = std::move(then)]() mutable {
        watcher->deleteLater();
        if (!watcher->isCanceled())
            then(watcher->result());
    });
    watcher->setFuture(future);
}

} // namespace disk
