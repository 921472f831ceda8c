// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/task.h"
#include <memory>
#include <vector>

namespace files {

/// Files that wait for their turn, one at a time as HSES has it. What is over stays until it is cleared away, so that a
/// person can read how it went.
class TransferQueue : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;
    ~TransferQueue() override;

    [[nodiscard]] int size() const { return int(m_tasks.size()); }
    [[nodiscard]] Task &at(int row) const { return *m_tasks[std::size_t(row)]; }
    [[nodiscard]] bool isIdle() const;

    /// It starts by itself when those before it are over.
    void add(std::unique_ptr<Task> task);
    void cancel(int row) { at(row).cancel(); }
    void cancelAll();
    /// Starts once more what failed or was cancelled, in the old order. For a person's order only.
    void retryFailed();
    /// Forgets what was done, or was cancelled.
    void clearFinished();

Q_SIGNALS:
    void aboutToAdd(int row);
    void added(int row);
    void aboutToRemove(int row);
    void removed(int row);
    /// State, bytes or rate of a task.
    void changed(int row);
    /// A task is over.
    void finished(files::Task *task);

private:
    void startNext();
    [[nodiscard]] int rowOf(const Task *task) const;

    std::vector<std::unique_ptr<Task>> m_tasks;
};

} // namespace files
