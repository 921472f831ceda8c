// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "journal/store.h"

#include "journal/database.h"
#include "journal/exports.h"
#include "journal/queries.h"
#include <QPointer>
#include <QStandardPaths>

using values::Result;

namespace journal {

namespace {

constexpr std::size_t mostInBatch = 5000;
constexpr int mostSightings = 5000;

} // namespace

/// Lives on the store's thread and owns the connection.
class Store::Worker : public QObject
{
public:
    explicit Worker(const QUrl &place) : m_database {place} { }

    Result<void> write(const std::vector<Change> &batch)
    {
        return attempt<void>([&](Database &database) {
            return batch.empty() ? Result<void> {} : database.inTransaction([&] { return writeAll(database, batch); });
        });
    }

    /// Asks with the database open. A file that turns out to be damaged is set aside, and the question asked again.
    template <typename Value> Result<Value> attempt(const Question<Value> &question)
    {
        for (bool isAgain = false;; isAgain = true) {
            Result<Value> answer = m_database.open().and_then([&] { return question(m_database); });
            if (answer)
                return answer;
            m_database.close();
            if (isAgain || !m_database.isDamaged())
                return answer;
        }
    }

    QString takeSetAside() { return m_database.takeSetAside(); }

private:
    static Result<void> writeAll(Database &database, const std::vector<Change> &batch)
    {
        for (const Change &change : batch) {
            auto done = std::visit([&](const auto &record) { return journal::write(database, record); }, change);
            if (!done)
                return done;
        }
        return {};
    }

    Database m_database;
};

QUrl Store::defaultPlace()
{
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    return QUrl::fromLocalFile(folder + QStringLiteral("/journal.sqlite"));
}

Store::Store(const QUrl &place, QObject *parent) : Store(place, Options {}, parent) { }

Store::Store(const QUrl &place, const Options &options, QObject *parent)
    : QObject {parent}, m_options {options}, m_worker {new Worker {place}}
{
    m_worker->moveToThread(&m_thread);
    connect(&m_thread, &QThread::finished, m_worker, &QObject::deleteLater);
    m_thread.setObjectName(QStringLiteral("journal"));
    m_thread.start();
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &Store::flush);
    flush(); // an empty batch: whether the store can be opened at all is said at once
}

Store::~Store()
{
    if (m_trouble.isEmpty()) {
        auto rest = std::make_shared<std::vector<Change>>(m_waiting.begin(), m_waiting.end());
        QMetaObject::invokeMethod(m_worker, [worker = m_worker, rest] { static_cast<void>(worker->write(*rest)); });
    }
    QMetaObject::invokeMethod(m_worker, [] { QThread::currentThread()->quit(); }); // after what was ordered before
    m_thread.wait();
}

void Store::merge(const HistoryReading &reading)
{
    if (!reading.entries.isEmpty())
        add(reading);
}

qsizetype Store::weight(const Change &change)
{
    const auto *reading = std::get_if<HistoryReading>(&change);
    return reading ? reading->entries.size() : 1;
}

qsizetype Store::waitingCount() const
{
    return qsizetype(m_waiting.size()) + (m_batch ? qsizetype(m_batch->size()) : 0);
}

void Store::add(Change change)
{
    m_waitingWeight += weight(change);
    m_waiting.push_back(std::move(change));
    bound();
    if (!m_timer.isActive() && !m_batch)
        m_timer.start(m_options.gather);
}

void Store::bound()
{
    while (m_waitingWeight > m_options.mostWaiting) {
        m_waitingWeight -= weight(m_waiting.front());
        m_waiting.pop_front();
        ++m_dropped;
        ++m_droppedSinceFailure;
    }
}

void Store::flush()
{
    if (m_batch)
        return;
    m_timer.stop();
    const auto end = m_waiting.begin() + std::ptrdiff_t(std::min(m_waiting.size(), mostInBatch));
    m_batch = std::make_shared<const std::vector<Change>>(m_waiting.begin(), end);
    for (const Change &change : *m_batch)
        m_waitingWeight -= weight(change);
    m_waiting.erase(m_waiting.begin(), end);
    QMetaObject::invokeMethod(m_worker, [this, batch = m_batch] {
        const auto result = m_worker->write(*batch);
        QMetaObject::invokeMethod(
            this, [=, this, path = m_worker->takeSetAside()] { onWritten(batch, result, path); }, Qt::QueuedConnection);
    });
}

void Store::onWritten(const Batch &batch, const Result<void> &result, const QString &setAsidePath)
{
    m_batch.reset();
    if (!setAsidePath.isEmpty())
        Q_EMIT setAside(setAsidePath);
    if (!result) {
        putBack(*batch);
        fail(result.error().detail);
    } else if (!m_waiting.empty()) {
        flush();
    } else if (!m_trouble.isEmpty()) {
        m_trouble.clear();
        Q_EMIT recovered(std::exchange(m_droppedSinceFailure, 0));
    }
    if (!m_batch) {
        for (const auto &post : std::exchange(m_questions, {}))
            post();
    }
    if (result && !batch->empty())
        Q_EMIT written();
}

void Store::putBack(const std::vector<Change> &batch)
{
    m_waiting.insert(m_waiting.begin(), batch.begin(), batch.end());
    for (const Change &change : batch)
        m_waitingWeight += weight(change);
    bound();
}

void Store::fail(const QString &why)
{
    m_timer.start(m_options.retry);
    const QString reason = tr("The journal cannot be written: %1. Work goes on; records wait in memory.").arg(why);
    if (std::exchange(m_trouble, reason) != reason)
        Q_EMIT failed(reason);
}

template <typename Value> void Store::ask(Question<Value> question, QObject *context, Handler<Value> handler)
{
    const QPointer<QObject> guard {context};
    const auto post = [this, guard, question = std::move(question), handler = std::move(handler)] {
        QMetaObject::invokeMethod(m_worker, [=, this] {
            const auto answer = m_worker->attempt<Value>(question);
            const auto tell = [this, guard, handler, answer, path = m_worker->takeSetAside()] {
                if (!path.isEmpty())
                    Q_EMIT setAside(path);
                if (guard)
                    handler(answer);
            };
            QMetaObject::invokeMethod(this, tell, Qt::QueuedConnection);
        });
    };
    if (!m_trouble.isEmpty() || (!m_batch && m_waiting.empty()))
        return post();
    m_questions.push_back(post); // the answer knows what was appended before
    flush();
}

void Store::orders(
    const OrderFilter &filter, const Cursor &from, int count, QObject *context, Handler<Page<OrderRecord>> handler)
{
    ask<Page<OrderRecord>>([=](Database &database) { return journal::orders(database, filter, from, count); }, context,
        std::move(handler));
}

void Store::orderActions(QObject *context, Handler<QStringList> handler)
{
    ask<QStringList>(&journal::orderActions, context, std::move(handler));
}

void Store::orderControllers(QObject *context, Handler<QStringList> handler)
{
    ask<QStringList>(&journal::orderControllers, context, std::move(handler));
}

void Store::alarms(
    const AlarmFilter &filter, const Cursor &from, int count, QObject *context, Handler<Page<AlarmRecord>> handler)
{
    ask<Page<AlarmRecord>>([=](Database &database) { return journal::alarms(database, filter, from, count); }, context,
        std::move(handler));
}

void Store::sightings(const QString &controller, QObject *context, Handler<QList<Sighting>> handler)
{
    ask<QList<Sighting>>([=](Database &database) { return journal::sightings(database, controller, mostSightings); },
        context, std::move(handler));
}

void Store::statistics(const AlarmFilter &filter, int count, QObject *context, Handler<QList<CodeStatistics>> handler)
{
    ask<QList<CodeStatistics>>(
        [=](Database &database) { return journal::statistics(database, filter, count); }, context, std::move(handler));
}

void Store::notes(QObject *context, Handler<QList<Note>> handler)
{
    ask<QList<Note>>(&journal::notes, context, std::move(handler));
}

void Store::exportOrders(
    const OrderFilter &filter, const QString &path, Format format, QObject *context, Handler<qint64> handler)
{
    ask<qint64>([=](Database &database) { return exports::orders(database, filter, path, format); }, context,
        std::move(handler));
}

void Store::exportAlarms(const AlarmFilter &filter, const protocol::TextCodec &codec, const QString &path,
    Format format, QObject *context, Handler<qint64> handler)
{
    ask<qint64>([=](Database &database) { return exports::alarms(database, filter, codec, path, format); }, context,
        std::move(handler));
}

void Store::exportNotes(const QString &path, Format format, QObject *context, Handler<qint64> handler)
{
    ask<qint64>(
        [=](Database &database) { return exports::notes(database, path, format); }, context, std::move(handler));
}

} // namespace journal
