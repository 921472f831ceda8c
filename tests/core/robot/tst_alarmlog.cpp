// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/alarmlog.h"
#include "values/utc.h"
#include "virtualcontroller/alarms.h"
#include "virtualcontroller/server.h"
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace std::chrono_literals;
using namespace robot;
using journal::AlarmState;
using protocol::Model;
using values::AlarmHistoryClass;
using values::AlarmWithTexts;
using values::Result;
using virtualcontroller::Direction;
using virtualcontroller::FaultKind;
using virtualcontroller::Faults;

namespace {

AlarmWithTexts entry(quint32 code, const QByteArray &time, QByteArrayView name = "TEST")
{
    AlarmWithTexts one;
    one.alarm.code = code;
    one.alarm.time = values::FixedText<16> {time};
    one.alarm.name = values::FixedText<32> {name};
    return one;
}

/// A controller, a journal in a folder of its own, and the log between them.
struct Cell {
    explicit Cell(Model model = Model::YRC1000)
    {
        virtualcontroller::Options options;
        options.port = 0;
        options.filePort = 0;
        options.settings.model = model;
        server = std::make_unique<virtualcontroller::Server>(options);
        isUp = server->start().has_value();
        settings::Profile profile;
        profile.name = QStringLiteral("CELL 4");
        profile.host = QStringLiteral("127.0.0.1");
        profile.port = server->port();
        profile.filePort = server->filePort();
        profile.model = model;
        profile.readTimeout = 100ms;
        profile.requestsPerSecond = 10'000;
        controller = std::make_unique<Controller>(profile);
        orders = std::make_unique<Orders>(*controller, access, arming);
        startLog();
    }

    void startLog()
    {
        log.reset();
        store.reset();
        store = std::make_unique<journal::Store>(QUrl::fromLocalFile(folder.filePath(QStringLiteral("journal.sqlite"))),
            journal::Store::Options {1ms, 20ms, 20'000});
        log = std::make_unique<AlarmLog>(*orders, *store, AlarmLog::Options {0ms});
    }

    [[nodiscard]] bool live()
    {
        controller->open();
        return isUp && QTest::qWaitFor([this] { return orders->situation().isLinkUp; });
    }

    /// Reads the history to its end.
    [[nodiscard]] bool read()
    {
        log->readHistory();
        return QTest::qWaitFor([this] { return log->isReading(); }, 1000)
            && QTest::qWaitFor([this] { return !log->isReading(); }, 20'000);
    }

    /// What the journal has of a list, the newest first.
    [[nodiscard]] QList<AlarmWithTexts> kept(AlarmHistoryClass list)
    {
        QList<AlarmWithTexts> found;
        bool isAnswered = false;
        const auto take = [&](const Result<journal::Page<journal::AlarmRecord>> &page) {
            isAnswered = true;
            for (const journal::AlarmRecord &record : page->records)
                found += record.alarm;
        };
        store->alarms({QStringLiteral("CELL 4"), list, 0}, {}, 1000, store.get(), take);
        return QTest::qWaitFor([&] { return isAnswered; }) ? found : QList<AlarmWithTexts> {};
    }
    [[nodiscard]] QList<AlarmWithTexts> atController(AlarmHistoryClass list) const
    {
        const auto &history = server->memory().histories[list];
        return {history.begin(), history.end()};
    }
    [[nodiscard]] QList<quint32> activeCodes() const
    {
        QList<quint32> codes;
        for (const auto &alarm : log->alarms())
            codes += alarm.sighting.alarm.alarm.code;
        return codes;
    }

    QTemporaryDir folder;
    AccessRules rules;
    Access access {rules};
    Arming arming;
    std::unique_ptr<virtualcontroller::Server> server;
    std::unique_ptr<Controller> controller;
    std::unique_ptr<Orders> orders;
    std::unique_ptr<journal::Store> store;
    std::unique_ptr<AlarmLog> log;
    bool isUp = false;
};

} // namespace

class TestAlarmLog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theHistoryIsReadOnce_data()
    {
        QTest::addColumn<Model>("model");
        QTest::addColumn<int>("command");
        QTest::addColumn<bool>("refusesTexts");
        QTest::newRow("with texts") << Model::YRC1000 << 0x30B << false;
        QTest::newRow("a model without texts") << Model::DX100 << 0x71 << false;
        QTest::newRow("an older software without texts") << Model::FS100 << 0x71 << true;
    }

    void theHistoryIsReadOnce()
    {
        QFETCH(const Model, model);
        QFETCH(const int, command);
        QFETCH(const bool, refusesTexts);
        Cell cell {model};
        if (refusesTexts)
            cell.server->setFaults(Faults {{{0x30B, Direction::Request, FaultKind::Refuse, 1, 0, -1, {}, 0xA000}}});
        QVERIFY(cell.live());
        QVERIFY(cell.read());
        for (const auto list : values::allAlarmHistoryClasses) {
            const auto kept = cell.kept(list);
            const auto there = cell.atController(list);
            QCOMPARE(kept.size(), there.size());
            for (qsizetype i = 0; i < kept.size(); ++i)
                QVERIFY(kept[i].alarm == there[i].alarm);
        }
        QVERIFY(!cell.log->readingError());

        // What is new costs little, even after a restart of the program.
        cell.startLog();
        // A busy computer makes a read late and asks again: that costs, but not because of the history.
        const auto asked = [&] {
            return cell.server->arrived(quint16(command)) - int(cell.controller->statistics().counters.repeats);
        };
        const int before = asked();
        cell.server->memory().histories[AlarmHistoryClass::User].push_front(entry(9001, "2026/01/12 08:13"));
        QVERIFY(cell.read());
        QVERIFY(asked() - before <= 17); // 2 + 2, 2 + 2, 2 + 1, 3 + 2 and 1: what is new, and the top again
        QCOMPARE(cell.kept(AlarmHistoryClass::User).size(), 2);
    }

    void equalAlarmsWithinAMinuteAllCount()
    {
        Cell cell;
        auto &list = cell.server->memory().histories[AlarmHistoryClass::Minor];
        const auto same = entry(4107, "1970/01/01 00:05", "\x8A\xE0 \xFF");
        list = {same, same};
        QVERIFY(cell.live());
        QVERIFY(cell.read());
        QCOMPARE(cell.kept(AlarmHistoryClass::Minor).size(), 2);
        list.push_front(same);
        QVERIFY(cell.read());
        QCOMPARE(cell.kept(AlarmHistoryClass::Minor).size(), 3);
        QVERIFY(cell.read());
        QCOMPARE(cell.kept(AlarmHistoryClass::Minor).size(), 3);
        QVERIFY(cell.kept(AlarmHistoryClass::Minor).first() == same);
        list.clear(); // cleared at the pendant
        QVERIFY(cell.read());
        QCOMPARE(cell.kept(AlarmHistoryClass::Minor).size(), 3);
    }

    void aListThatMovesWhileItIsRead()
    {
        Cell cell;
        auto &list = cell.server->memory().histories[AlarmHistoryClass::Minor];
        for (int minute = 0; minute < 30; ++minute)
            list.push_front(entry(4107, QStringLiteral("2026/01/12 08:%1").arg(minute + 10).toLatin1()));
        QVERIFY(cell.live());
        int moves = 0;
        connect(cell.log.get(), &AlarmLog::readingChanged, this, [&] {
            if (cell.log->entriesRead() % 17 == 5 && moves < 3)
                list.push_front(entry(4108, QStringLiteral("2026/01/12 09:0%1").arg(moves++).toLatin1()));
        });
        QVERIFY(cell.read());
        QCOMPARE(moves, 3);
        QVERIFY(cell.read());
        QVERIFY(cell.kept(AlarmHistoryClass::Minor) == cell.atController(AlarmHistoryClass::Minor));
    }

    void aHundredAndMoreAreKept()
    {
        Cell cell;
        QList<AlarmWithTexts> all;
        QVERIFY(cell.live());
        for (int i = 0; i < 150; ++i) {
            const auto clock = values::utc({2026, 1, 12}, {8, 0}).addSecs(20 * i);
            all.prepend(entry(4100 + i % 3, clock.toString(QStringLiteral("yyyy/MM/dd HH:mm")).toLatin1()));
            if (i % 50 != 49)
                continue;
            const auto newest = all.first(std::min<qsizetype>(all.size(), 100));
            cell.server->memory().histories[AlarmHistoryClass::Minor] = {newest.begin(), newest.end()};
            QVERIFY(cell.read());
        }
        QVERIFY(cell.kept(AlarmHistoryClass::Minor) == all);
    }

    void aSilentControllerEndsTheReading()
    {
        Cell cell;
        QVERIFY(cell.live());
        cell.server->stop();
        QVERIFY(cell.read());
        QVERIFY(cell.log->readingError().has_value());
        QVERIFY(cell.log->readingError()->kind == values::ErrorKind::NoAnswer);
    }

    void aReadingCanBeCancelled()
    {
        Cell cell;
        QVERIFY(cell.live());
        cell.log->readHistory();
        QTRY_VERIFY(cell.log->entriesRead() > 0);
        cell.log->cancelReading();
        QVERIFY(!cell.log->isReading());
        QVERIFY(cell.log->readingError()->kind == values::ErrorKind::Cancelled);
        QVERIFY(cell.read());
        QCOMPARE(cell.kept(AlarmHistoryClass::Major).size(), 2);
    }

    void withoutAnAlarmNothingIsRead()
    {
        Cell cell;
        QVERIFY(cell.live());
        QTRY_VERIFY(cell.server->arrived(0x72) > 5);
        QCOMPARE(cell.server->arrived(0x30A), 0);
        QCOMPARE(cell.server->arrived(0x30B), 0);
    }

    void anAlarmIsFollowedFromTheEdgeToTheEnd()
    {
        Cell cell;
        QVERIFY(cell.live());
        QSignalSpy came {cell.log.get(), &AlarmLog::alarmsCame};
        virtualcontroller::raiseAlarm(cell.server->memory(), 4107, "OVERRUN");
        QTRY_COMPARE(came.size(), 1);
        QCOMPARE(cell.activeCodes(), QList<quint32> {4107});
        QTRY_COMPARE(cell.kept(AlarmHistoryClass::Minor).size(), 3); // the edge led to a reading

        cell.log->acknowledge({cell.log->alarms().first().sighting.alarm});
        QVERIFY(cell.log->alarms().first().sighting.state == AlarmState::Acknowledged);
        QCOMPARE(cell.server->arrived(0x82), 0); // the robot does not hear of it

        cell.startLog(); // the program again
        QTRY_COMPARE(cell.activeCodes(), QList<quint32> {4107});
        QTRY_VERIFY(cell.log->alarms().first().sighting.state == AlarmState::Acknowledged);
        QTRY_VERIFY(cell.log->alarms().first().isInSlot);
        QCOMPARE(cell.log->alarms().first().sighting.count, 1u);

        virtualcontroller::resetAlarms(cell.server->memory());
        QTRY_VERIFY(cell.log->alarms().isEmpty());
        const int before = cell.server->arrived(0x30A);
        const int status = cell.server->arrived(0x72);
        QTRY_VERIFY(cell.server->arrived(0x72) > status + 12); // more than a second
        QVERIFY(cell.server->arrived(0x30A) - before <= 4); // a round that was under way
    }

    /// Four alarms that change all the time, faster than they are read.
    void aFloodIsBounded()
    {
        Cell cell;
        QVERIFY(cell.live());
        quint32 code = 4000;
        QTimer flood;
        connect(&flood, &QTimer::timeout, this, [&] {
            virtualcontroller::resetAlarms(cell.server->memory());
            for (int slot = 0; slot < values::activeAlarmCount; ++slot)
                virtualcontroller::raiseAlarm(cell.server->memory(), 4000 + ++code % 900, "FLOOD");
        });
        flood.start(5ms);
        QTRY_VERIFY_WITH_TIMEOUT(cell.activeCodes().size() > 12, 30'000);
        QVERIFY(cell.log->alarms().size() <= journal::ActiveAlarms::mostListed);
        flood.stop();
        virtualcontroller::resetAlarms(cell.server->memory());
        QTRY_VERIFY(!cell.log->isReading());
        QTRY_COMPARE(cell.store->waitingCount(), 0);
        QVERIFY(cell.store->trouble().isEmpty());
    }
};

QTEST_GUILESS_MAIN(TestAlarmLog)
#include "tst_alarmlog.moc"
