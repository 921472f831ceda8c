// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "station/fileorders.h"

using files::OperationState;
using robot::Act;
using values::Error;
using values::ErrorKind;
using values::FileName;
using values::Result;

namespace station {

namespace {

robot::Order orderOf(const files::Task &task, Act act)
{
    const journal::OrderRecord record = task.record();
    return {act, record.subject, record.oldValue, record.newValue};
}

Result<void> resultOf(const files::Task &task)
{
    if (task.state() == OperationState::Done)
        return {};
    return tl::unexpected(task.error().value_or(Error {ErrorKind::Cancelled}));
}

void ignore(const Result<void> &) { }

Result<void> permission(const robot::Orders &orders, Act act)
{
    const auto obstacle = orders.obstacle(act);
    if (!obstacle)
        return {};
    return values::failure(ErrorKind::NotSent, QString::fromLatin1(robot::title(*obstacle)));
}

} // namespace

/// The attempt that a task is while it is under way.
struct FileOrders::Door {
    Act act;
    const files::Task *task = nullptr;
    QPointer<robot::Attempt> attempt;
};

FileOrders::FileOrders(robot::Orders &orders, QObject *parent) : QObject(parent), m_orders {orders} { }

files::Guard FileOrders::guard(Act act) const
{
    return [this, act](QObject *, const std::function<void(const Result<void> &)> &handler) {
        handler(permission(m_orders, act));
    };
}

files::Guard FileOrders::guard(const std::shared_ptr<Door> &door)
{
    return [this, door](QObject *, const std::function<void(const Result<void> &)> &handler) {
        const auto permitted = permission(m_orders, door->act);
        door->attempt = m_orders.begin(orderOf(*door->task, door->act), this, ignore);
        if (permitted && !door->attempt)
            return handler(values::failure(ErrorKind::NotSent, QStringLiteral("The same order is under way")));
        handler(permitted);
    };
}

template <typename Made, typename... Arguments>
std::unique_ptr<files::Task> FileOrders::make(Act act, const Arguments &...arguments)
{
    session::FileSession *session = m_orders.controller().files();
    if (!session)
        return nullptr;
    const auto door = std::make_shared<Door>(Door {act, nullptr, {}});
    std::unique_ptr<Made> task;
    if constexpr (std::is_same_v<Made, files::Download>)
        task = std::make_unique<Made>(*session, arguments...);
    else
        task = std::make_unique<Made>(*session, arguments..., guard(door));
    door->task = task.get();
    connect(task.get(), &files::Operation::finished, this, [this, door] {
        if (door->act == Act::Download)
            note(*door->task, door->act);
        else if (door->attempt)
            door->attempt->end(resultOf(*door->task));
    });
    return task;
}

std::unique_ptr<files::Task> FileOrders::download(const FileName &name, const QString &localPath)
{
    return make<files::Download>(Act::Download, name, localPath);
}

std::unique_ptr<files::Task> FileOrders::upload(const FileName &name, const QString &localPath)
{
    return make<files::Upload>(Act::Upload, name, localPath);
}

std::unique_ptr<files::Task> FileOrders::upload(const FileName &name, const QByteArray &content)
{
    return make<files::Upload>(Act::Upload, name, content);
}

std::unique_ptr<files::Task> FileOrders::remove(const FileName &name, const QString &folderOfCopies)
{
    return make<files::Removal>(Act::DeleteFile, name, folderOfCopies);
}

void FileOrders::note(const files::Task &task, Act act)
{
    if (robot::Attempt *attempt = m_orders.begin(orderOf(task, act), this, ignore))
        attempt->end(resultOf(task));
}

QByteArrayList FileOrders::jobsInUse() const
{
    const auto &situation = m_orders.situation();
    const bool isRunning = situation.status && situation.status->isRunning();
    return isRunning && situation.job ? QByteArrayList {situation.job->name.bytes().toByteArray()} : QByteArrayList {};
}

} // namespace station
