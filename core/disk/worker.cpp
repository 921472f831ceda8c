// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "disk/worker.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace disk {

struct Worker::Queue {
    std::mutex mutex;
    std::condition_variable changed;
    std::deque<std::function<void()>> tasks;
    std::function<void()> atEnd;
    std::atomic_bool isOpen = true;
    bool hasThread = false;
    bool isBusy = false;
};

Worker::Worker(std::function<void()> atEnd) : m_queue {std::make_shared<Queue>()} { m_queue->atEnd = std::move(atEnd); }

Worker::~Worker() { close(); }

void Worker::close()
{
    std::deque<std::function<void()>> dropped; // their promises end outside the lock
    const std::lock_guard lock {m_queue->mutex};
    dropped.swap(m_queue->tasks);
    m_queue->isOpen = false;
    m_queue->changed.notify_all();
}

IsWanted Worker::isOpen(const std::shared_ptr<Queue> &queue)
{
    return [queue] { return queue->isOpen.load(); };
}

void Worker::end(std::chrono::milliseconds most)
{
    close();
    std::unique_lock lock {m_queue->mutex};
    m_queue->changed.wait_for(lock, most, [this] { return !m_queue->hasThread; });
}

bool Worker::waitForDone(std::chrono::milliseconds most)
{
    std::unique_lock lock {m_queue->mutex};
    return m_queue->changed.wait_for(lock, most, [this] { return !m_queue->isBusy && m_queue->tasks.empty(); });
}

void Worker::post(std::function<void()> task)
{
    const std::lock_guard lock {m_queue->mutex};
    m_queue->tasks.push_back(std::move(task));
    if (!std::exchange(m_queue->hasThread, true))
        std::thread {[queue = m_queue] { work(queue); }}.detach();
    m_queue->changed.notify_all();
}

void Worker::work(const std::shared_ptr<Queue> &queue)
{
    std::unique_lock lock {queue->mutex};
    for (;;) {
        queue->changed.wait(lock, [&] { return !queue->tasks.empty() || !queue->isOpen; });
        if (queue->tasks.empty())
            break;
        auto task = std::move(queue->tasks.front());
        queue->tasks.pop_front();
        queue->isBusy = true;
        lock.unlock();
        task();
        task = {};
        lock.lock();
        queue->isBusy = false;
        queue->changed.notify_all();
    }
    lock.unlock();
    if (queue->atEnd)
        queue->atEnd();
    queue->atEnd = {};
    lock.lock();
    queue->hasThread = false;
    queue->changed.notify_all();
}

} // namespace disk
