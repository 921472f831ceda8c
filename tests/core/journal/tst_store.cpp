// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "journal/store.h"
#include "values/utc.h"
#include <QElapsedTimer>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>
#include <sys/resource.h>

using namespace journal;
using namespace std::chrono_literals;
using values::AlarmHistoryClass;
using values::AlarmWithTexts;
using values::Result;

namespace {

const Store::Options quick {1ms, 20ms, 20'000};

/// What a question to the store answers.
template <typename Value> struct Answer {
    std::optional<Result<Value>> result;
    Store::Handler<Value> handler()
    {
        return [this](const Result<Value> &answer) { result = answer; };
    }
    const Value &value() const { return **result; }
};

#define WAIT_FOR(answer) QTRY_VERIFY_WITH_TIMEOUT((answer).result.has_value(), 20'000)

OrderRecord order(int minute, const char *action, Outcome outcome = Outcome::Done)
{
    OrderRecord record;
    record.at = values::utc({2026, 1, 12}, {8, minute});
    record.user = QStringLiteral("maria");
    record.host = QStringLiteral("desk-3");
    record.level = QStringLiteral("Operate");
    record.controller = QStringLiteral("CELL 4 溶接");
    record.action = QString::fromLatin1(action);
    record.subject = QStringLiteral("M%1").arg(minute, 3, 10, QLatin1Char('0'));
    record.oldValue = QStringLiteral("5");
    record.newValue = QStringLiteral("100%");
    record.outcome = outcome;
    record.duration = 12ms;
    if (outcome == Outcome::Refused) {
        record.status = 0x1F;
        record.added = 0x2060;
        record.reply = QStringLiteral("0x2060 an alarm or error is present");
    }
    return record;
}

AlarmWithTexts alarmEntry(quint32 code, const QByteArray &time)
{
    AlarmWithTexts one;
    one.alarm = {code, {3, values::AlarmDataType::AxesSlurbt}, values::FixedText<16> {time},
        values::FixedText<32> {QByteArray("\x8A\x00", 1) + "UND\xFF"}};
    one.extra = values::FixedText<16> {QByteArrayView("[SV#1]")};
    one.subText = values::FixedText<96> {QByteArrayView("S L")};
    one.reversed[2] = 1;
    return one;
}

QStringList subjects(const QList<OrderRecord> &orders)
{
    QStringList found;
    for (const OrderRecord &order : orders)
        found += order.subject;
    return found;
}

QByteArray contents(const QString &path)
{
    QFile file {path};
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void write(const QString &path, const QByteArray &bytes)
{
    QFile file {path};
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), bytes.size());
}

} // namespace

class TestStore : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    QString path() const
    {
        return m_folder.filePath(QString::fromLatin1(QTest::currentTestFunction()) + QStringLiteral("/j.sqlite"));
    }
    QUrl place() const { return QUrl::fromLocalFile(path()); }
    QStringList filesInFolder() const { return QFileInfo(path()).dir().entryList(QDir::Files, QDir::Name); }

    /// Everything that is kept, the newest first; asked with a store of its own.
    QList<OrderRecord> allOrders() const
    {
        Store store {place(), quick};
        Answer<Page<OrderRecord>> page;
        store.orders({}, {}, 1'000'000, &store, page.handler());
        [&] { WAIT_FOR(page); }();
        return page.result && *page.result ? page.value().records : QList<OrderRecord> {};
    }

private Q_SLOTS:
    void anOrderIsKeptAsItWas()
    {
        const auto refused = order(1, "start", Outcome::Refused);
        OrderRecord empty;
        empty.at = order(0, "").at;
        {
            Store store {place(), quick};
            store.append(refused);
            store.append(empty);
        }
        const auto kept = allOrders();
        QCOMPARE(kept.size(), 2);
        QVERIFY(kept[0] == refused);
        QVERIFY(kept[1] == empty);
    }

    void ordersAreFoundByTheirFilter_data()
    {
        QTest::addColumn<OrderFilter>("filter");
        QTest::addColumn<QStringList>("expected");
        const auto row = [](const char *name, const OrderFilter &filter, const QStringList &expected) {
            QTest::newRow(name) << filter << expected;
        };
        const auto at = [](int minute) { return values::utc({2026, 1, 12}, {8, minute}); };
        const QString m1 = QStringLiteral("M001"), m2 = QStringLiteral("M002"), m3 = QStringLiteral("M003");
        row("all, the newest first", {}, {m3, m2, m1});
        row("from, inclusive", {at(2), {}, {}, {}, {}, {}, 0}, {m3, m2});
        row("to, exclusive", {{}, at(2), {}, {}, {}, {}, 0}, {m1});
        row("controller", {{}, {}, QStringLiteral("CELL 4 溶接"), {}, {}, {}, 0}, {m3, m2, m1});
        row("another controller", {{}, {}, QStringLiteral("CELL 4"), {}, {}, {}, 0}, {});
        row("action", {{}, {}, {}, QStringLiteral("start"), {}, {}, 0}, {m2});
        row("outcome", {{}, {}, {}, {}, Outcome::Refused, {}, 0}, {m2});
        row("text in the reply", {{}, {}, {}, {}, {}, QStringLiteral("ALARM or"), 0}, {m2});
        row("text in the subject", {{}, {}, {}, {}, {}, QStringLiteral("m003"), 0}, {m3});
        row("a percent sign is a percent sign", {{}, {}, {}, {}, {}, QStringLiteral("0%"), 0}, {m3, m2, m1});
        row("and finds nothing else", {{}, {}, {}, {}, {}, QStringLiteral("5%"), 0}, {});
        row("nor does an underscore", {{}, {}, {}, {}, {}, QStringLiteral("M__1"), 0}, {});
        row("a quote ends nothing", {{}, {}, {}, {}, {}, QStringLiteral("'; DROP TABLE orders; --"), 0}, {});
        row("all at once",
            {at(1), at(3), QStringLiteral("CELL 4 溶接"), QStringLiteral("start"), Outcome::Refused,
                QStringLiteral("maria")},
            {m2});
    }

    void ordersAreFoundByTheirFilter()
    {
        QFETCH(const OrderFilter, filter);
        QFETCH(const QStringList, expected);
        Store store {QUrl::fromLocalFile(m_folder.filePath(QStringLiteral("filter.sqlite"))), quick};
        Answer<Page<OrderRecord>> before;
        store.orders({}, {}, 1, &store, before.handler());
        WAIT_FOR(before);
        if (before.value().records.isEmpty()) {
            store.append(order(2, "start", Outcome::Refused));
            store.append(order(1, "write-register"));
            store.append(order(3, "hold-off", Outcome::Unknown));
        }
        Answer<Page<OrderRecord>> page;
        store.orders(filter, {}, 10, &store, page.handler());
        WAIT_FOR(page);
        QCOMPARE(subjects(page.value().records), expected);
    }

    void pagesFollowEachOther()
    {
        Store store {place(), quick};
        for (const int minute : {1, 2, 2, 2, 3})
            store.append(order(minute, "start"));
        QStringList found;
        int pages = 0;
        for (std::optional<Cursor> next = Cursor {}; next; ++pages) {
            Answer<Page<OrderRecord>> page;
            store.orders({}, *next, 2, &store, page.handler());
            WAIT_FOR(page);
            found += subjects(page.value().records);
            next = page.value().next;
            store.append(order(4, "later")); // newer records do not move the older pages
        }
        QCOMPARE(found.join(u' '), QStringLiteral("M003 M002 M002 M002 M001"));
        QCOMPARE(pages, 3);
        Answer<QStringList> actions;
        store.orderActions(&store, actions.handler());
        WAIT_FOR(actions);
        QCOMPARE(actions.value(), (QStringList {QStringLiteral("later"), QStringLiteral("start")}));
    }

    void nobodyIsToldAfterTheirEnd()
    {
        Store store {place(), quick};
        bool isTold = false;
        auto context = std::make_unique<QObject>();
        store.orders({}, {}, 1, context.get(), [&](const auto &) { isTold = true; });
        context.reset();
        Answer<QList<Note>> later;
        store.notes(&store, later.handler());
        WAIT_FOR(later);
        QVERIFY(!isTold);
    }

    void historyIsKeptForEverAndOnce()
    {
        Store store {place(), quick};
        const QString cell = QStringLiteral("CELL 4");
        const auto seen = values::utc({2026, 1, 12}, {9, 0});
        const auto old = alarmEntry(4416, "2026/01/11 10:05");
        const auto pair = alarmEntry(4107, "1970/01/01 00:05");
        store.merge({cell, AlarmHistoryClass::Minor, {pair, old}, seen});
        store.merge({cell, AlarmHistoryClass::Minor, {pair, old}, seen.addSecs(60)});
        store.merge({cell, AlarmHistoryClass::Minor, {pair, pair, old}, seen.addSecs(120)});
        store.merge({cell, AlarmHistoryClass::User, {pair}, seen});
        store.merge({QStringLiteral("CELL 5"), AlarmHistoryClass::Minor, {old}, seen});
        store.merge({cell, AlarmHistoryClass::Major, {}, seen});

        Answer<Page<AlarmRecord>> page;
        store.alarms({cell, AlarmHistoryClass::Minor, 0}, {}, 100, &store, page.handler());
        WAIT_FOR(page);
        const auto &records = page.value().records;
        QCOMPARE(records.size(), 3);
        QVERIFY((records[0] == AlarmRecord {cell, AlarmHistoryClass::Minor, pair, seen.addSecs(120)}));
        QVERIFY((records[1] == AlarmRecord {cell, AlarmHistoryClass::Minor, pair, seen}));
        QVERIFY((records[2] == AlarmRecord {cell, AlarmHistoryClass::Minor, old, seen}));
        QCOMPARE(records[2].alarm.alarm.name.bytes().toByteArray(), QByteArray("\x8AUND\xFF"));

        Answer<Page<AlarmRecord>> everything;
        store.alarms({}, {}, 100, &store, everything.handler());
        Answer<QList<CodeStatistics>> top;
        store.statistics({cell, {}, 0}, 10, &store, top.handler());
        WAIT_FOR(top);
        QCOMPARE(everything.value().records.size(), 5);
        QCOMPARE(top.value().size(), 2);
        QCOMPARE(top.value().first().code, 4107u);
        QCOMPARE(top.value().first().count, 3);
    }

    void sightingsAndNotesAreReplaced()
    {
        Store store {place(), quick};
        const auto seen = values::utc({2026, 1, 12}, {9, 0});
        Sighting sighting {
            QStringLiteral("CELL 4"), alarmEntry(4416, "1970/01/01 00:05"), seen, seen, 1, AlarmState::Unacknowledged};
        store.keep(sighting);
        sighting.state = AlarmState::Acknowledged;
        sighting.count = 7;
        store.keep(sighting);
        Note note {4416, QStringLiteral("cable"), QStringLiteral("new clamp"), QStringLiteral("maria"), seen};
        store.keep(Note {1325, QStringLiteral("x"), {}, {}, seen});
        store.keep(note);
        store.keep(Note {1325, {}, {}, {}, seen});

        Answer<QList<Sighting>> sightings;
        store.sightings(QStringLiteral("CELL 4"), &store, sightings.handler());
        Answer<QList<Note>> notes;
        store.notes(&store, notes.handler());
        WAIT_FOR(notes);
        QCOMPARE(sightings.value().size(), 1);
        QVERIFY(sightings.value().first() == sighting);
        QCOMPARE(notes.value().size(), 1);
        QVERIFY(notes.value().first() == note);
    }

    void exportsAreWhole()
    {
        Store store {place(), quick};
        store.append(order(1, "start", Outcome::Refused));
        store.merge({QStringLiteral("CELL 4"), AlarmHistoryClass::Minor, {alarmEntry(4416, "2026/01/11 10:05")},
            values::utc({2026, 1, 12}, {9, 0})});
        const QString csv = path() + QStringLiteral(".csv");
        const QString json = path() + QStringLiteral(".json");
        Answer<qint64> orders;
        Answer<qint64> alarms;
        store.exportOrders({}, csv, Format::Csv, &store, orders.handler());
        store.exportAlarms(
            {}, protocol::TextCodec {protocol::Encoding::Utf8}, json, Format::Json, &store, alarms.handler());
        WAIT_FOR(alarms);
        QCOMPARE(orders.value(), 1);
        QCOMPARE(alarms.value(), 1);
        QCOMPARE(contents(csv),
            QByteArray("time_utc,user,host,level,controller,action,subject,old_value,new_value,outcome,status,"
                       "added_status,reply,duration_ms\r\n"
                       "2026-01-12T08:01:00.000Z,maria,desk-3,Operate,CELL 4 溶接,start,M001,5,100%,refused,31,8288,"
                       "0x2060 an alarm or error is present,12\r\n"));
        const auto object = QJsonDocument::fromJson(contents(json)).array().first().toObject();
        QCOMPARE(object.value(u"name").toString(), QStringLiteral("⟨8A⟩UND⟨FF⟩"));
        QCOMPARE(object.value(u"controller_time").toString(), QStringLiteral("2026/01/11 10:05"));
        QCOMPARE(object.value(u"seen_utc").toString(), QStringLiteral("2026-01-12T09:00:00.000Z"));
        QCOMPARE(object.value(u"list").toString(), QStringLiteral("minor"));
        QCOMPARE(object.value(u"data").toString(), QStringLiteral("S L"));

        Answer<qint64> nowhere;
        store.exportNotes(path() + QStringLiteral("/no/folder.csv"), Format::Csv, &store, nowhere.handler());
        WAIT_FOR(nowhere);
        QVERIFY(!*nowhere.result);
        QVERIFY(store.trouble().isEmpty());
    }

    void aDamagedFileIsSetAside_data()
    {
        QTest::addColumn<int>("damage"); // 0 other contents, 1 cut, 2 overwritten in the middle, 3 empty
        QTest::addColumn<bool>("isSetAside");
        QTest::newRow("not a database") << 0 << true;
        QTest::newRow("cut short") << 1 << true;
        QTest::newRow("overwritten in the middle") << 2 << true;
        QTest::newRow("an empty file is a new one") << 3 << false;
    }

    void aDamagedFileIsSetAside()
    {
        QFETCH(const int, damage);
        QFETCH(const bool, isSetAside);
        QDir(QFileInfo(path()).path()).removeRecursively();
        {
            Store store {place(), quick};
            for (int i = 0; i < 2000; ++i)
                store.append(order(1, "start"));
            QTRY_COMPARE(store.waitingCount(), 0);
        }
        QByteArray bytes = contents(path());
        switch (damage) {
        case 0: bytes = QByteArray(20'000, 'x'); break;
        case 1: bytes.resize(bytes.size() / 2); break;
        case 2: bytes.replace(4096, bytes.size() - 8192, QByteArray(bytes.size() - 8192, '\xAA')); break;
        default: bytes.clear();
        }
        write(path(), bytes);

        Store store {place(), quick};
        QSignalSpy setAside {&store, &Store::setAside};
        QSignalSpy failed {&store, &Store::failed};
        store.append(order(2, "start"));
        Answer<Page<OrderRecord>> page;
        store.orders({}, {}, 100, &store, page.handler());
        WAIT_FOR(page);
        QCOMPARE(subjects(page.value().records), QStringList {QStringLiteral("M002")});
        QCOMPARE(setAside.size(), isSetAside ? 1 : 0);
        QCOMPARE(failed.size(), 0);
        if (isSetAside) {
            const QString aside = setAside.first().first().toString();
            QVERIFY(aside.contains(u"damaged-"));
            QCOMPARE(contents(aside).size(), bytes.size());
        }
    }

    /// The folder's name is taken by a file: nobody can write there, whoever they are.
    void aFolderThatCannotBeWritten()
    {
        const QString folder = QFileInfo(path()).path();
        write(folder, "in the way");
        Store store {place(), {1ms, 20ms, 10}};
        QSignalSpy failed {&store, &Store::failed};
        QSignalSpy recovered {&store, &Store::recovered};
        QTRY_COMPARE(failed.size(), 1); // said before there is anything to write
        QVERIFY(store.trouble().contains(QStringLiteral("folder")));
        for (int minute = 1; minute <= 13; ++minute)
            store.append(order(minute, "start"));
        Answer<QStringList> actions;
        store.orderActions(&store, actions.handler());
        WAIT_FOR(actions);
        QVERIFY(!*actions.result);
        QTRY_COMPARE(store.droppedCount(), 3);
        QCOMPARE(store.waitingCount(), 10);

        QVERIFY(QFile::remove(folder));
        QTRY_COMPARE(recovered.size(), 1);
        QCOMPARE(recovered.first().first().toLongLong(), 3);
        QVERIFY(store.trouble().isEmpty());
        QCOMPARE(failed.size(), 1);
        const auto kept = subjects(allOrders());
        QCOMPARE(kept.size(), 10);
        QCOMPARE(kept.last(), QStringLiteral("M004"));
    }

    void aDiskThatIsFull()
    {
        Store store {place(), quick};
        QSignalSpy failed {&store, &Store::failed};
        QSignalSpy recovered {&store, &Store::recovered};
        store.append(order(1, "start"));
        QTRY_COMPARE(store.waitingCount(), 0);

        std::signal(SIGXFSZ, SIG_IGN);
        rlimit before {};
        getrlimit(RLIMIT_FSIZE, &before);
        const rlimit full {4096, before.rlim_max}; // no room for a page
        setrlimit(RLIMIT_FSIZE, &full); // no file may grow
        for (int i = 0; i < 500; ++i)
            store.append(order(2, "start"));
        QTRY_COMPARE(failed.size(), 1);
        QVERIFY(store.waitingCount() > 0);
        setrlimit(RLIMIT_FSIZE, &before);
        QTRY_COMPARE(recovered.size(), 1);
        QCOMPARE(recovered.first().first().toLongLong(), 0);
        QCOMPARE(allOrders().size(), 501);
    }

    void aFileThatIsTakenAwayIsMadeAnew()
    {
        Store store {place(), quick};
        store.append(order(1, "start"));
        QTRY_COMPARE(store.waitingCount(), 0);
        for (const QString &name : filesInFolder())
            QVERIFY(QFile::remove(QFileInfo(path()).dir().filePath(name)));
        store.append(order(2, "start"));
        QTRY_COMPARE(store.waitingCount(), 0);
        QCOMPARE(subjects(allOrders()), QStringList {QStringLiteral("M002")});
    }

    void aNewerJournalIsLeftAlone()
    {
        {
            Store {place(), quick};
        }
        {
            auto database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("newer"));
            database.setDatabaseName(path());
            QVERIFY(database.open());
            QVERIFY(QSqlQuery(database).exec(QStringLiteral("INSERT INTO journal_version VALUES (99)")));
        }
        QSqlDatabase::removeDatabase(QStringLiteral("newer"));
        Store store {place(), quick};
        QSignalSpy failed {&store, &Store::failed};
        QTRY_COMPARE(failed.size(), 1);
        QVERIFY(store.trouble().contains(QStringLiteral("newer version")));
    }

    /// Another program keeps the database for itself while this one ends: the order is neither lost nor waited for, and
    /// the next store takes it in, once.
    void whatTheEndCouldNotWriteIsTakenInLater()
    {
        {
            Store {place(), quick};
        }
        OrderRecord hold = order(1, "hold");
        hold.reply = QStringLiteral("⟨溶接⟩ \"quoted\"");
        const Note note {4416, QStringLiteral("cable"), QStringLiteral("changed"), QStringLiteral("maria"),
            QDateTime({2026, 1, 12}, {9, 0}, Qt::UTC)};
        {
            auto other = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("other"));
            other.setDatabaseName(path());
            QVERIFY(other.open());
            QVERIFY(QSqlQuery(other).exec(QStringLiteral("BEGIN EXCLUSIVE")));
            QTest::ignoreMessage(QtWarningMsg, QRegularExpression {QStringLiteral("kept in .*unsaved")});
            {
                Store store {place(), quick};
                store.append(hold);
                store.keep(note);
            }
            QVERIFY(filesInFolder().contains(QStringLiteral("j.sqlite.unsaved.json")));
            const auto owner = QFile::ReadOwner | QFile::WriteOwner | QFile::ReadUser | QFile::WriteUser;
            QCOMPARE(QFile::permissions(path() + QStringLiteral(".unsaved.json")), owner);
            QVERIFY(QSqlQuery(other).exec(QStringLiteral("ROLLBACK")));
        }
        QSqlDatabase::removeDatabase(QStringLiteral("other"));
        QCOMPARE(allOrders(), QList<OrderRecord> {hold});
        QVERIFY(!filesInFolder().contains(QStringLiteral("j.sqlite.unsaved.json")));
        Store store {place(), quick};
        Answer<QList<Note>> notes;
        store.notes(&store, notes.handler());
        WAIT_FOR(notes);
        QCOMPARE(notes.value(), QList<Note> {note});
        QCOMPARE(allOrders().size(), 1);
    }

    void whatWasLeftAndCannotBeReadIsKept()
    {
        QVERIFY(QDir {}.mkpath(QFileInfo(path()).path()));
        write(path() + QStringLiteral(".unsaved.json"), "{\"orders\": [");
        QTest::ignoreMessage(QtWarningMsg, QRegularExpression {QStringLiteral("cannot be read")});
        QCOMPARE(allOrders().size(), 0);
        QVERIFY(filesInFolder().contains(QStringLiteral("j.sqlite.unsaved.json.damaged")));
    }

    /// Whoever asked is gone before the answer: the question ends, and the next one is answered.
    void aQuestionThatNobodyWantsEnds()
    {
        Store store {place(), quick};
        for (int i = 0; i < 2000; ++i)
            store.append(order(i % 60, "start"));
        QTRY_COMPARE(store.waitingCount(), 0);
        bool isAnswered = false;
        for (int i = 0; i < 50; ++i) {
            QObject context;
            OrderFilter filter;
            filter.text = QStringLiteral("nowhere%1").arg(i);
            store.orders(filter, {}, 100, &context, [&](const auto &) { isAnswered = true; });
        }
        Answer<QStringList> actions;
        store.orderActions(&store, actions.handler());
        WAIT_FOR(actions);
        QCOMPARE(actions.value(), QStringList {QStringLiteral("start")});
        QVERIFY(!isAnswered);
    }

    void isForItsOwnerAlone()
    {
        {
            Store store {place(), quick};
            store.append(order(1, "start"));
        }
        const auto owner = QFile::ReadOwner | QFile::WriteOwner | QFile::ReadUser | QFile::WriteUser;
        QCOMPARE(QFile::permissions(path()), owner);
        QCOMPARE(QFile::permissions(QFileInfo(path()).path()), owner | QFile::ExeOwner | QFile::ExeUser);
    }

    /// A journal as it was before alarms were counted as they come: the first version's tables, with alarms in them.
    void aJournalOfTheFirstVersionIsCounted()
    {
        {
            Store store {place(), quick};
            HistoryReading reading {QStringLiteral("CELL 4"), AlarmHistoryClass::Major,
                {alarmEntry(4416, "2026/01/01 10:00"), alarmEntry(4416, "2026/01/01 08:00"),
                    alarmEntry(1030, "2026/01/01 07:00")},
                QDateTime({2026, 1, 12}, {9, 0}, Qt::UTC)};
            store.merge(reading);
            QTRY_COMPARE(store.waitingCount(), 0);
        }
        {
            auto database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("first"));
            database.setDatabaseName(path());
            QVERIFY(database.open());
            for (const char *statement : {"DROP TABLE tallies", "DROP INDEX orders_by_action",
                     "DROP INDEX orders_by_controller", "DELETE FROM journal_version WHERE number > 1"})
                QVERIFY(QSqlQuery(database).exec(QString::fromLatin1(statement)));
        }
        QSqlDatabase::removeDatabase(QStringLiteral("first"));
        Store store {place(), quick};
        Answer<QList<CodeStatistics>> top;
        store.statistics({QStringLiteral("CELL 4"), {}, 0}, 10, &store, top.handler());
        WAIT_FOR(top);
        QCOMPARE(top.value().size(), 2);
        QCOMPARE(top.value()[0].code, quint32(4416));
        QCOMPARE(top.value()[0].count, 2);
        QVERIFY(top.value()[0].meanBetween == 120min);
        QCOMPARE(top.value()[1].count, 1);
    }

    void twoDesksOnOneJournal()
    {
        {
            Store one {place(), quick};
            Store other {place(), quick};
            for (int i = 0; i < 200; ++i) {
                one.append(order(1, "start"));
                other.append(order(2, "start"));
                QCoreApplication::processEvents();
            }
            QTRY_COMPARE_WITH_TIMEOUT(one.waitingCount() + other.waitingCount(), 0, 30'000);
        }
        QCOMPARE(allOrders().size(), 400);
    }

    /// A quarter of an hour of four alarms that change ten times a second, at once. Whoever appends never waits for the
    /// disk, and what waits is bounded; the times are for the reader.
    void aFloodIsTakenInBatches()
    {
        Store store {place(), {10ms, 20ms, 50'000}};
        QElapsedTimer timer;
        timer.start();
        qint64 longest = 0;
        for (int i = 0; i < 36'000; ++i) {
            const qint64 before = timer.nsecsElapsed();
            store.append(order(i % 60, "alarm"));
            if (i % 1000 == 0)
                QCoreApplication::processEvents();
            longest = std::max(longest, timer.nsecsElapsed() - before);
        }
        QVERIFY(store.waitingCount() <= 50'000);
        QTRY_COMPARE_WITH_TIMEOUT(store.waitingCount(), 0, 120'000);
        qInfo("36,000 records in %lld ms; the longest that the caller waited was %.1f ms", timer.elapsed(),
            double(longest) / 1e6);
        QCOMPARE(store.droppedCount(), 0);
        QCOMPARE(allOrders().size(), 36'000);
    }
};

QTEST_GUILESS_MAIN(TestStore)
#include "tst_store.moc"
