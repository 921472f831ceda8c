// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "journal/store.h"

#include "journal/database.h"
#include "journal/exports.h"
#include "journal/queries.h"
#include "journal/unsaved.h"
#include <QDeadlineTimer>
#include <QLoggingCategory>
#include <QStandardPaths>

using values::Result;

namespace journal {

namespace {

Q_LOGGING_CATEGORY(journalLog, "pendesk.journal")

constexpr std::size_t mostInBatch = 5000;
constexpr int mostSightings = 5000;
constexpr std::chrono::milliseconds patience {2000}; ///< At the end of the program.
constexpr std::chrono::milliseconds forTheRest {400}; ///< Of it, to leave behind what could not be written.

} // namespace

/// Asks with the database open. A file that turns out to be damaged is set aside, and the question asked again.
template <typename Value> Store::Answer<Value> Store::attempt(Database &database, const Question<Value> &question)
{
    for (bool isAgain = false;; isAgain = true) {
        Result<Value> answer = database.open().and_then([&] { return question(database); });
        if (answer)
            return {answer, database.takeSetAside()};
        database.close();
        if (isAgain || !database.isDamaged())
            return {answer, database.takeSetAside()};
    }
}

namespace {

template <typename Changes> Result<void> writeAll(Database &database, const Changes &changes)
{
    for (const auto &change : changes) {
        auto done = std::visit([&](const auto &record) { return journal::write(database, record); }, change);
        if (!done)
            return done;
    }
    return {};
}

} // namespace

/// What an earlier program could not write comes first.
std::function<Store::Answer<void>()> Store::writing(const std::shared_ptr<Database> &database, const Batch &batch)
{
    return [database, batch] {
        return attempt<void>(*database, [&](Database &opened) {
            return takeInUnsaved(opened).and_then([&] {
                return batch->empty() ? Result<void> {}
                                      : opened.inTransaction([&] { return writeAll(opened, *batch); });
            });
        });
    };
}

QUrl Store::defaultPlace()
{
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    return QUrl::fromLocalFile(folder + QStringLiteral("/journal.sqlite"));
}

Store::Store(const QUrl &place, QObject *parent) : Store(place, Options {}, parent) { }

Store::Store(const QUrl &place, const Options &options, QObject *parent)
    : QObject {parent},
      m_options {options},
      m_place {place},
      m_writing {std::make_shared<Database>(place)},
      m_reading {std::make_shared<Database>(place, Database::Use::Reading)},
      m_writer {[database = m_writing] { database->close(); }},
      m_reader {[database = m_reading] { database->close(); }}
{
    connect(&m_written, &QFutureWatcherBase::finished, this, &Store::onWritten);
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &Store::flush);
    flush(); // an empty batch: whether the store can be opened at all is said at once
}

Store::~Store()
{
    const QDeadlineTimer end {patience};
    m_written.disconnect(this);
    const Changes rest = unwritten();
    if (!rest.empty()) {
        disk::Worker last;
        QFuture<QString> leaving = last.run([place = m_place, rest] { return leaveUnsaved(place, rest); });
        const QString words = last.waitForDone(forTheRest) ? leaving.result() : tr("the disk does not answer");
        qCWarning(journalLog).noquote() << words;
    }
    for (disk::Worker *worker : {&m_reader, &m_writer})
        worker->end(std::chrono::milliseconds {end.remainingTime()});
}

/// What the database does not have although it was tried until the time was over.
Store::Changes Store::unwritten()
{
    const QDeadlineTimer end {patience - forTheRest};
    const auto isWritten = [&](const QFuture<Answer<void>> &writing) {
        const std::chrono::milliseconds left {end.remainingTime()};
        return m_writer.waitForDone(left) && writing.isResultReadyAt(0) && writing.result().result;
    };
    if (m_batch && !isWritten(m_written.future()))
        putBack(*m_batch);
    else if (m_trouble.isEmpty() && !m_waiting.empty()
        && isWritten(m_writer.run(writing(m_writing, std::make_shared<Changes>(m_waiting.begin(), m_waiting.end())))))
        m_waiting.clear();
    return {m_waiting.begin(), m_waiting.end()};
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
    m_written.setFuture(m_writer.run(writing(m_writing, m_batch)));
}

void Store::onWritten()
{
    const auto [result, setAsidePath] = m_written.result();
    const Batch batch = m_batch;
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

void Store::putBack(const Changes &batch)
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

template <typename Value>
void Store::askWriter(const Question<Value> &question, const QPointer<QObject> &context, const Handler<Value> &handler)
{
    const auto work = [database = m_writing, question] { return attempt<Value>(*database, question); };
    m_writer.run(this, work, [this, context, handler](const Answer<Value> &answer) {
        if (!answer.setAside.isEmpty())
            Q_EMIT setAside(answer.setAside);
        if (context)
            handler(answer.result);
    });
}

/// The reading thread answers; what it cannot open is for the one that writes, which makes and mends.
template <typename Value> void Store::ask(Question<Value> question, QObject *context, Handler<Value> handler, Need need)
{
    using Found = std::optional<Result<Value>>;
    const auto work = [database = m_reading, question](const disk::IsWanted &isWanted) -> Found {
        database->interruptUnless(isWanted);
        if (!database->open())
            return std::nullopt;
        const Result<Value> answer = question(*database);
        database->interruptUnless({});
        return answer || !database->isDamaged() ? Found {answer} : std::nullopt;
    };
    const auto post = [this, work, question, handler, need, guard = QPointer<QObject> {context}] {
        if (!guard)
            return;
        const auto tell = [this, question, handler, guard](const Found &found) {
            if (!found)
                askWriter<Value>(question, guard, handler);
            else if (guard)
                handler(*found);
        };
        auto *asking = new QObject {this}; // of this store and of the context, whichever goes first
        if (need == Need::WhileShown)
            connect(guard, &QObject::destroyed, asking, &QObject::deleteLater);
        m_reader.run(asking, work, [asking, tell](const Found &found) {
            asking->deleteLater();
            tell(found);
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
        std::move(handler), Need::Always);
}

void Store::exportAlarms(const AlarmFilter &filter, const protocol::TextCodec &codec, const QString &path,
    Format format, QObject *context, Handler<qint64> handler)
{
    ask<qint64>([=](Database &database) { return exports::alarms(database, filter, codec, path, format); }, context,
        std::move(handler), Need::Always);
}

void Store::exportNotes(const QString &path, Format format, QObject *context, Handler<qint64> handler)
{
    ask<qint64>([=](Database &database) { return exports::notes(database, path, format); }, context, std::move(handler),
        Need::Always);
}

} // namespace journal
