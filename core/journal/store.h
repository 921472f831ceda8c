// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "disk/worker.h"
#include "journal/filter.h"
#include "journal/tablewriter.h"
#include "protocol/text.h"
#include "values/error.h"
#include <QObject>
#include <QPointer>
#include <QTimer>
#include <QUrl>
#include <deque>
#include <functional>
#include <memory>
#include <variant>
#include <vector>

namespace journal {

class Database;

/// The journal: what was tried and what alarms came, for ever. An embedded SQLite file, or a PostgreSQL server that
/// several desks share.
///
/// All SQL runs on two threads, one that writes and one that answers; no call here waits. What is appended is written a
/// moment later, many records in one transaction. While the store fails everything goes on: records wait in memory, are
/// tried again and again, and beyond a number the oldest are dropped and counted. A damaged file is set aside, never
/// deleted.
class Store : public QObject
{
    Q_OBJECT

public:
    struct Options {
        std::chrono::milliseconds gather {100}; ///< From the first record to the transaction that holds it.
        std::chrono::milliseconds retry {2000}; ///< Between tries while the store fails.
        qsizetype mostWaiting = 20'000; ///< Records in memory; an entry of a history reading counts as one.
    };
    /// Runs on the thread of the store, from the event loop, unless `context` is gone by then; a question of a context
    /// that is gone is not asked any further. The error says why the store cannot answer.
    template <typename Value> using Handler = std::function<void(const values::Result<Value> &)>;

    /// journal.sqlite in the user's folder of application data.
    [[nodiscard]] static QUrl defaultPlace();

    /// `place`: a file URL, or postgresql://user@host/database.
    explicit Store(const QUrl &place, const Options &options, QObject *parent = nullptr);
    explicit Store(const QUrl &place = defaultPlace(), QObject *parent = nullptr);
    /// Writes what waits, if the store works, for at most two seconds. Orders and notes that are not written by then
    /// are left in a small file beside the journal, for the next store to take in; the log says so.
    ~Store() override;

    void append(const OrderRecord &order) { add(order); }
    /// Replaces what was kept of that alarm.
    void keep(const Sighting &sighting) { add(sighting); }
    /// Adds the entries that the history does not have yet.
    void merge(const HistoryReading &reading);
    /// Replaces the note of that code; an empty note is removed.
    void keep(const Note &note) { add(note); }

    void orders(
        const OrderFilter &filter, const Cursor &from, int count, QObject *context, Handler<Page<OrderRecord>> handler);
    void orderActions(QObject *context, Handler<QStringList> handler);
    void orderControllers(QObject *context, Handler<QStringList> handler);
    /// The entry found last first; within a list that is the newest.
    void alarms(
        const AlarmFilter &filter, const Cursor &from, int count, QObject *context, Handler<Page<AlarmRecord>> handler);
    void sightings(const QString &controller, QObject *context, Handler<QList<Sighting>> handler);
    void statistics(const AlarmFilter &filter, int count, QObject *context, Handler<QList<CodeStatistics>> handler);
    void notes(QObject *context, Handler<QList<Note>> handler);

    /// Writes everything that matches into a file, which is replaced only when all is well. Answers how many rows.
    void exportOrders(
        const OrderFilter &filter, const QString &path, Format format, QObject *context, Handler<qint64> handler);
    void exportAlarms(const AlarmFilter &filter, const protocol::TextCodec &codec, const QString &path, Format format,
        QObject *context, Handler<qint64> handler);
    void exportNotes(const QString &path, Format format, QObject *context, Handler<qint64> handler);

    /// Why the store fails, as a translated sentence; empty while it works.
    [[nodiscard]] QString trouble() const { return m_trouble; }
    /// Records dropped because the store failed for too long.
    [[nodiscard]] qint64 droppedCount() const { return m_dropped; }
    /// Records that are not written yet.
    [[nodiscard]] qsizetype waitingCount() const;

Q_SIGNALS:
    void failed(const QString &reason);
    /// Works again, and all that waited is written but `dropped` records.
    void recovered(qint64 dropped);
    /// A damaged journal was put there and a new one begun.
    void setAside(const QString &path);
    /// Records were written.
    void written();

private:
    using Change = std::variant<OrderRecord, Sighting, HistoryReading, Note>;
    using Changes = std::vector<Change>;
    using Batch = std::shared_ptr<const Changes>;
    template <typename Value> using Question = std::function<values::Result<Value>(Database &)>;
    /// What the writing thread answers: the value, and where a damaged journal was put meanwhile.
    template <typename Value> struct Answer {
        values::Result<Value> result;
        QString setAside;
    };
    enum class Need {
        WhileShown, ///< Nobody asks for the answer any more when the context is gone.
        Always, ///< A file comes of it.
    };

    template <typename Value> static Answer<Value> attempt(Database &database, const Question<Value> &question);
    [[nodiscard]] static std::function<Answer<void>()> writing(
        const std::shared_ptr<Database> &database, const Batch &batch);
    static qsizetype weight(const Change &change);
    void add(Change change);
    void flush();
    void bound();
    void putBack(const Changes &batch);
    void onWritten();
    void fail(const QString &why);
    [[nodiscard]] Changes unwritten();
    template <typename Value>
    void ask(Question<Value> question, QObject *context, Handler<Value> handler, Need need = Need::WhileShown);
    template <typename Value>
    void askWriter(const Question<Value> &question, const QPointer<QObject> &context, const Handler<Value> &handler);

    Options m_options;
    QUrl m_place;
    std::shared_ptr<Database> m_writing; ///< Each is for its worker alone.
    std::shared_ptr<Database> m_reading;
    disk::Worker m_writer;
    disk::Worker m_reader;
    QFutureWatcher<Answer<void>> m_written; ///< Of m_batch.
    std::deque<Change> m_waiting;
    qsizetype m_waitingWeight = 0;
    Batch m_batch; ///< On its way.
    std::vector<std::function<void()>> m_questions; ///< They wait until what was appended before is written.
    QTimer m_timer;
    QString m_trouble;
    qint64 m_dropped = 0; ///< Ever.
    qint64 m_droppedSinceFailure = 0;
};

} // namespace journal
