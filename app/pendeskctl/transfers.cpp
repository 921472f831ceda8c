// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "transfers.h"

#include "files/queue.h"
#include "protocol/codes.h"
#include <QJsonArray>
#include <QJsonObject>

using files::OperationState;
using values::FileName;
using values::Result;

namespace pendeskctl {

namespace {

QString wordsOf(files::ReadBack readBack, int lines)
{
    switch (readBack) {
    case files::ReadBack::NotYet: break;
    case files::ReadBack::Identical: return QStringLiteral("identical");
    case files::ReadBack::Reformatted: return QStringLiteral("reformatted %1 lines").arg(lines);
    case files::ReadBack::Different: return QStringLiteral("different");
    case files::ReadBack::Unreadable: return QStringLiteral("could not be read back");
    }
    return {};
}

/// Carries out a queue, tells of each task, and finds the exit code.
class Transfers : public QObject
{
public:
    Transfers(Desk &desk, int skipped) : QObject {&desk}, m_desk {desk}, m_skipped {skipped}
    {
        connect(&m_queue, &files::TransferQueue::changed, this, &Transfers::onChanged);
        connect(&m_queue, &files::TransferQueue::finished, this, &Transfers::onFinished);
    }

    void add(std::unique_ptr<files::Task> task) { m_queue.add(std::move(task)); }

private:
    void onChanged(int row)
    {
        const files::Task &task = m_queue.at(row);
        if (task.state() == OperationState::Running)
            showProgress(m_desk.call(),
                QStringLiteral("%1/%2  %3  %4 bytes")
                    .arg(row + 1)
                    .arg(m_queue.size())
                    .arg(QString::fromLatin1(task.name().bytes()))
                    .arg(task.bytesDone()));
    }

    void onFinished(files::Task *task)
    {
        tell(*task);
        if (m_queue.isIdle())
            end();
    }

    void tell(const files::Task &task)
    {
        const QString name = m_desk.codec().decode(task.name().bytes());
        QJsonObject json {{QStringLiteral("name"), name}};
        if (task.error()) {
            m_desk.complainOf(*task.error(), name);
            json.insert(QStringLiteral("error"), protocol::explain(*task.error()));
            m_lastFailure = exitCodeOf(*task.error());
            ++m_failures;
        }
        const QString result = resultOf(task);
        json.insert(QStringLiteral("result"), result);
        if (!m_desk.call().isJson)
            print(QStringLiteral("%1  %2").arg(name, result));
        m_report << json;
    }

    QString resultOf(const files::Task &task)
    {
        if (task.error())
            return QStringLiteral("failed");
        if (const auto *upload = qobject_cast<const files::Upload *>(&task)) {
            using enum files::ReadBack;
            m_differs = m_differs || upload->readBack() == Different || upload->readBack() == Unreadable;
            return wordsOf(upload->readBack(), upload->reformattedLines());
        }
        if (const auto *removal = qobject_cast<const files::Removal *>(&task))
            return QStringLiteral("deleted, copy in %1").arg(removal->copy());
        return QStringLiteral("%1 bytes").arg(task.bytesDone());
    }

    void end()
    {
        if (m_desk.call().isJson)
            print(QJsonValue {m_report});
        if (m_failures > 0)
            return m_desk.finish(m_failures == m_queue.size() ? m_lastFailure : Partial);
        m_desk.finish(m_differs ? VerificationFailed : m_skipped > 0 ? Partial : Done);
    }

    Desk &m_desk;
    files::TransferQueue m_queue;
    QJsonArray m_report;
    ExitCode m_lastFailure = Done;
    int m_failures = 0;
    int m_skipped;
    bool m_differs = false;
};

Result<FileName> nameOf(const QString &text, const Desk &desk)
{
    return desk.codec().encode(text).and_then([](const QByteArray &bytes) { return FileName::create(bytes); });
}

} // namespace

void transfer(Desk &desk, const QStringList &names, const TaskMaker &taskFor)
{
    std::vector<std::unique_ptr<files::Task>> tasks;
    int skipped = 0;
    for (const QString &text : names) {
        const auto name = nameOf(text, desk);
        if (!name)
            return desk.fail(name.error());
        if (auto task = taskFor(*name))
            tasks.push_back(std::move(task));
        else
            ++skipped;
    }
    if (tasks.empty())
        return desk.finish(Partial);
    auto *transfers = new Transfers {desk, skipped};
    for (auto &task : tasks)
        transfers->add(std::move(task));
}

} // namespace pendeskctl
