// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "cell/crossreference.h"

namespace cell {

/// A line of a job that leads into another job.
struct Call {
    QByteArray caller;
    int line = 0; ///< The controller's.
    How how = How::Calls;
    QByteArray callee; ///< Empty if a number, a text or a table says it when the line runs.
    QByteArray through = {}; ///< "MJ#(2)" of a macro; otherwise empty.
    bool isConditional = false;
    bool isMissing = false; ///< No file has the job.

    bool operator==(const Call &) const = default;
};

/// Which job calls which.
class CallTree
{
public:
    CallTree() = default;
    explicit CallTree(const Cell &cell);

    /// In the order of their lines.
    [[nodiscard]] QList<Call> callsOf(const QByteArray &job) const;
    [[nodiscard]] QList<Call> callersOf(const QByteArray &job) const;
    [[nodiscard]] const QList<Call> &calls() const { return m_calls; }
    /// Jobs that no job and no macro names, in order: the heads of the tree. Whether the master job, the ladder or a
    /// person starts them is not in the files of jobs.
    [[nodiscard]] QByteArrayList heads() const;
    /// Heads whose attributes do not say that something else runs them: neither macro jobs nor system jobs. A job that
    /// is named only from its own lines, or by jobs in a circle of which none is a head, is not among them.
    [[nodiscard]] QByteArrayList unused() const;
    /// Some line starts a job that the files do not name: any job may be used.
    [[nodiscard]] bool hasUnknownTargets() const;

private:
    void take(const Cell &cell, const QByteArray &name, const inform::Job &job, int line);

    QList<Call> m_calls;
    QByteArrayList m_heads;
    QByteArrayList m_unused;
};

} // namespace cell
