// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/requests.h"
#include "virtualcontroller/faults.h"
#include <QTest>

using namespace virtualcontroller;

namespace {

const QByteArray request =
    protocol::encode(protocol::ReadStatus {}.request(), {protocol::Division::Robot, false, 7, 0});

Faults parsed(const char *text)
{
    const auto faults = Faults::parse(QString::fromLatin1(text));
    Q_ASSERT(faults);
    return *faults;
}

/// What arrives of a hundred numbered packets.
QList<QByteArray> arrivals(Faults faults)
{
    QList<QByteArray> result;
    for (int number = 0; number < 100; ++number) {
        for (const auto &[delay, bytes] : faults.plan(Direction::Reply, 0x72, QByteArray::number(number)).deliveries)
            result += bytes + '@' + QByteArray::number(qint64(delay.count()));
    }
    return result;
}

} // namespace

class FaultsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void passesEverythingByDefault();
    void repeatsExactlyWithTheSameSeed();
    void strikesWhatItNames();
    void doesWhatItSays();
    void damagesNoticeably();
    void explainsMistakes_data();
    void explainsMistakes();
};

void FaultsTest::passesEverythingByDefault()
{
    Faults faults;
    const auto plan = faults.plan(Direction::Request, 0x72, request);
    QCOMPARE(plan.deliveries, (std::vector<Faults::Delivery> {{0ms, request}}));
    QVERIFY(!plan.refusal && !plan.silence && !plan.isRestart);
}

void FaultsTest::repeatsExactlyWithTheSameSeed()
{
    const char *text =
        "seed=%1; any reply lose p=0.2; any reply delay p=0.2 ms=50; any reply duplicate p=0.1; any reply "
        "corrupt-anywhere p=0.1; any reply reorder p=0.1";
    const QByteArray one = QByteArray(text).replace("%1", "42");
    const QByteArray other = QByteArray(text).replace("%1", "43");
    QCOMPARE(arrivals(parsed(one)), arrivals(parsed(one)));
    QVERIFY(arrivals(parsed(one)) != arrivals(parsed(other)));
}

void FaultsTest::strikesWhatItNames()
{
    Faults faults = parsed("0x86 reply lose after=1 times=2");
    const auto isLost = [&](Direction direction, quint16 command) {
        return faults.plan(direction, command, request).deliveries.empty();
    };
    QVERIFY(!isLost(Direction::Reply, 0x72));
    QVERIFY(!isLost(Direction::Request, 0x86));
    QVERIFY(!isLost(Direction::Reply, 0x86)); // the first one is spared
    QVERIFY(isLost(Direction::Reply, 0x86));
    QVERIFY(isLost(Direction::Reply, 0x86));
    QVERIFY(!isLost(Direction::Reply, 0x86)); // twice was enough
    QVERIFY(parsed("files request lose").plan(Direction::Request, 0, request).deliveries.empty());
    QVERIFY(parsed("any request lose").plan(Direction::Request, 0x411, request).deliveries.empty());
}

void FaultsTest::doesWhatItSays()
{
    using Deliveries = std::vector<Faults::Delivery>;
    const auto plan = [](const char *text) { return parsed(text).plan(Direction::Request, 0x72, request); };
    QCOMPARE(plan("any request delay ms=250").deliveries, (Deliveries {{250ms, request}}));
    QCOMPARE(plan("any request duplicate ms=30").deliveries, (Deliveries {{0ms, request}, {30ms, request}}));
    QCOMPARE(plan("any request refuse code=0x2080").refusal, std::optional<quint16> {0x2080});
    QCOMPARE(plan("any request silence ms=3000").silence, std::optional {Time {3s}});
    QVERIFY(plan("any request silence").deliveries.empty());
    QVERIFY(plan("any request restart").isRestart);
    const auto cut = plan("any request truncate").deliveries.front().bytes;
    QVERIFY(cut.size() < request.size() && request.startsWith(cut));
    QByteArray next = request;
    next[11] = 8; // the request ID (reference §1.1)
    QCOMPARE(plan("any request wrong-id").deliveries.front().bytes, next);

    Faults swap = parsed("any reply reorder times=1");
    QVERIFY(swap.plan(Direction::Reply, 0x72, "a").deliveries.empty());
    QCOMPARE(swap.plan(Direction::Reply, 0x72, "b").deliveries, (Deliveries {{0ms, "b"}, {0ms, "a"}}));
}

void FaultsTest::damagesNoticeably()
{
    Faults faults = parsed("any request corrupt");
    for (int round = 0; round < 200; ++round) {
        const QByteArray damaged = faults.plan(Direction::Request, 0x72, request).deliveries.front().bytes;
        QVERIFY(protocol::checkFrame(damaged) != protocol::FrameFault::None);
    }
}

void FaultsTest::explainsMistakes_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("word");
    const auto row = [](const char *text, const char *word) {
        QTest::newRow(text) << QString::fromLatin1(text) << QString::fromLatin1(word);
    };
    row("seed=x", "seed=x");
    row("0x72 reply", "0x72 reply");
    row("72z reply lose", "72z");
    row("any answer lose", "answer");
    row("any reply explode", "explode");
    row("any reply lose p=2", "p=2");
    row("any reply lose p=", "p=");
    row("any reply delay ms=-1", "ms=-1");
    row("any reply delay s=1", "s=1");
    row("any reply refuse", "reply");
}

void FaultsTest::explainsMistakes()
{
    QFETCH(QString, text);
    QFETCH(QString, word);
    const auto faults = Faults::parse(text);
    QVERIFY(!faults);
    QCOMPARE(faults.error().kind, values::ErrorKind::BadInput);
    QVERIFY2(faults.error().detail.startsWith(u'"' + word + u'"'), qPrintable(faults.error().detail));
}

QTEST_GUILESS_MAIN(FaultsTest)
#include "tst_faults.moc"
