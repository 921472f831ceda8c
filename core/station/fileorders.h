// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/queue.h"
#include "robot/orders.h"

namespace station {

/// Makes transfers that go through the door for orders: what stands against one withholds it, and each leaves its
/// record in the journal.
class FileOrders : public QObject
{
    Q_OBJECT

public:
    /// `orders` must outlive it.
    explicit FileOrders(robot::Orders &orders, QObject *parent = nullptr);

    /// nullptr while there is no link; so are the others.
    [[nodiscard]] std::unique_ptr<files::Task> download(const values::FileName &name, const QString &localPath);
    [[nodiscard]] std::unique_ptr<files::Task> upload(const values::FileName &name, const QString &localPath);
    [[nodiscard]] std::unique_ptr<files::Task> upload(const values::FileName &name, const QByteArray &content);
    [[nodiscard]] std::unique_ptr<files::Task> remove(const values::FileName &name, const QString &folderOfCopies);

    /// Lets something pass while nothing stands against `act`.
    [[nodiscard]] files::Guard guard(robot::Act act) const;
    /// Leaves the record of a task that was carried out by a larger procedure.
    void note(const files::Task &task, robot::Act act);
    /// The names of the jobs that are being executed, without extension.
    [[nodiscard]] QByteArrayList jobsInUse() const;

private:
    struct Door;

    [[nodiscard]] files::Guard guard(const std::shared_ptr<Door> &door);
    template <typename Made, typename... Arguments>
    std::unique_ptr<files::Task> make(robot::Act act, const Arguments &...arguments);

    robot::Orders &m_orders;
};

} // namespace station
