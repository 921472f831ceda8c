// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/queue.h"

#include <algorithm>

namespace files {

TransferQueue::~TransferQueue() = default;

bool TransferQueue::isIdle() const
{
    return std::ranges::all_of(m_tasks, [](const auto &task) { return task->isOver(); });
}

int TransferQueue::rowOf(const Task *task) const
{
    const auto found = std::ranges::find(m_tasks, task, [](const auto &each) { return each.get(); });
    return int(found - m_tasks.begin());
}

void TransferQueue::add(std::unique_ptr<Task> task)
{
    Task *added = task.get();
    connect(added, &Task::progressed, this, [this, added] { Q_EMIT changed(rowOf(added)); });
    connect(added, &Task::finished, this, [this, added] {
        Q_EMIT changed(rowOf(added));
        Q_EMIT finished(added);
        startNext();
    });
    Q_EMIT aboutToAdd(size());
    m_tasks.push_back(std::move(task));
    Q_EMIT this->added(size() - 1);
    startNext();
}

void TransferQueue::startNext()
{
    const auto isRunning = [](const auto &task) { return task->state() == OperationState::Running; };
    if (std::ranges::any_of(m_tasks, isRunning))
        return;
    const auto next =
        std::ranges::find(m_tasks, OperationState::Waiting, [](const auto &task) { return task->state(); });
    if (next == m_tasks.end())
        return;
    (*next)->start();
    Q_EMIT changed(int(next - m_tasks.begin()));
}

void TransferQueue::cancelAll()
{
    for (const auto &task : m_tasks)
        task->cancel();
}

void TransferQueue::retryFailed()
{
    for (int row = 0; row < size(); ++row) {
        at(row).reset();
        Q_EMIT changed(row);
    }
    startNext();
}

void TransferQueue::clearFinished()
{
    for (int row = size() - 1; row >= 0; --row) {
        if (at(row).state() != OperationState::Done && at(row).state() != OperationState::Cancelled)
            continue;
        Q_EMIT aboutToRemove(row);
        m_tasks[std::size_t(row)].release()->deleteLater(); // perhaps it is just telling that it is over
        m_tasks.erase(m_tasks.begin() + row);
        Q_EMIT removed(row);
    }
}

} // namespace files
