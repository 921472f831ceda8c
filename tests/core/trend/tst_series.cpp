// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "trend/csv.h"
#include "trend/decimate.h"
#include "trend/moment.h"
#include "trend/scale.h"
#include <QTest>
#include <random>

using namespace trend;
using namespace std::chrono_literals;

namespace {

constexpr Moment zero {1'800'000'000'000ms}; // 2027-01-15T08:00:00Z

/// Samples as a row can hold them: milliseconds after zero and value; a value that is no number is a gap.
using Row = QList<QPair<int, double>>;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

Series series(const Row &row, std::size_t capacity = 1000)
{
    Series result {capacity};
    for (const auto &[at, value] : row) {
        if (std::isnan(value))
            result.breakOff(zero + std::chrono::milliseconds {at});
        else
            result.append(zero + std::chrono::milliseconds {at}, value);
    }
    return result;
}

template <typename Samples> QString text(const Samples &samples)
{
    QStringList parts;
    for (const Sample &sample : samples)
        parts << QString::number((sample.at - zero).count()) + u':'
                + (sample.isGap() ? QStringLiteral("-") : QString::number(sample.value));
    return parts.join(u' ');
}

Range range(int from, int to)
{
    return {zero + std::chrono::milliseconds {from}, zero + std::chrono::milliseconds {to}};
}

} // namespace

/// Samples over time: order, room, gaps, pictures and files of them.
class SeriesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void keeps_data();
    void keeps();
    void extends_data();
    void extends();
    void finds_data();
    void finds();
    void decimates_data();
    void decimates();
    void decimatedKeepsPeaksAndGaps();
    void decimatedStandsStill();
    void writesCsv();
    void quotesHeadings_data();
    void quotesHeadings();
    void roundLengths_data();
    void roundLengths();
    void scales_data();
    void scales();
    void keepsScale_data();
    void keepsScale();
    void moments_data();
    void moments();
};

void SeriesTest::keeps_data()
{
    QTest::addColumn<Row>("said");
    QTest::addColumn<int>("capacity");
    QTest::addColumn<QString>("kept");
    const auto row = [](const char *name, const Row &said, int capacity, const char *kept) {
        QTest::newRow(name) << said << capacity << QString::fromLatin1(kept);
    };
    row("nothing", {}, 9, "");
    row("in order", {{0, 1}, {100, 2}}, 9, "0:1 100:2");
    row("full", {{0, 1}, {100, 2}, {200, 3}}, 2, "100:2 200:3");
    row("same moment", {{0, 1}, {0, 2}}, 9, "0:2");
    row("clock set back", {{0, 1}, {100, 2}, {200, 3}, {50, 4}}, 9, "0:1 50:4");
    row("gap", {{0, 1}, {100, none}, {200, 2}}, 9, "0:1 100:- 200:2");
    row("gap told again", {{0, 1}, {100, none}, {150, none}, {200, 2}}, 9, "0:1 100:- 200:2");
    row("gap before anything", {{0, none}, {200, 2}}, 9, "200:2");
    row("gap at the moment of a sample", {{100, 1}, {100, none}}, 9, "100:1 101:-");
    row("gap in the past", {{100, 1}, {50, none}}, 9, "100:1 101:-");
}

void SeriesTest::keeps()
{
    QFETCH(Row, said);
    QFETCH(int, capacity);
    QTEST(text(series(said, std::size_t(capacity)).samples()), "kept");
}

void SeriesTest::extends_data()
{
    QTest::addColumn<Row>("said");
    QTest::addColumn<QString>("kept");
    QTest::addColumn<double>("heldAt150"); // no number: nothing is held there
    QTest::newRow("two") << Row {{0, 1}, {100, 1}} << "0:1 100:1" << none;
    QTest::newRow("three") << Row {{0, 1}, {100, 1}, {200, 1}} << "0:1 200:1" << 1.0;
    QTest::newRow("change") << Row {{0, 1}, {100, 1}, {200, 1}, {300, 2}} << "0:1 200:1 300:2" << 1.0;
    QTest::newRow("there and back") << Row {{0, 1}, {100, 2}, {200, 1}} << "0:1 100:2 200:1" << none;
    QTest::newRow("gap") << Row {{0, 1}, {100, none}, {200, 1}} << "0:1 100:- 200:1" << none;
}

void SeriesTest::extends()
{
    QFETCH(Row, said);
    QFETCH(double, heldAt150);
    Series given {100};
    for (const auto &[at, value] : said) {
        if (std::isnan(value))
            given.breakOff(zero + std::chrono::milliseconds {at});
        else
            given.extend(zero + std::chrono::milliseconds {at}, value);
    }
    QTEST(text(given.samples()), "kept");
    QVERIFY(given.heldAt(zero + 150ms) == (std::isnan(heldAt150) ? std::nullopt : std::optional(heldAt150)));
}

void SeriesTest::finds_data()
{
    QTest::addColumn<int>("from");
    QTest::addColumn<int>("to");
    QTest::addColumn<QString>("within");
    QTest::addColumn<QString>("around");
    QTest::newRow("all") << 0 << 400 << "0:1 100:2 200:- 300:4 400:5"
                         << "0:1 100:2 200:- 300:4 400:5";
    QTest::newRow("middle") << 50 << 150 << "100:2"
                            << "0:1 100:2 200:-";
    QTest::newRow("between two") << 110 << 120 << ""
                                 << "100:2 200:-";
    QTest::newRow("before") << -50 << -10 << ""
                            << "0:1";
    QTest::newRow("after") << 500 << 600 << ""
                           << "400:5";
}

void SeriesTest::finds()
{
    QFETCH(int, from);
    QFETCH(int, to);
    const Series given = series({{0, 1}, {100, 2}, {200, none}, {300, 4}, {400, 5}});
    QTEST(text(given.within(range(from, to))), "within");
    QTEST(text(given.around(range(from, to))), "around");
}

void SeriesTest::decimates_data()
{
    QTest::addColumn<Row>("given");
    QTest::addColumn<int>("columns");
    QTest::addColumn<QString>("drawn"); // over 0..1000 ms
    const auto row = [](const char *name, const Row &given, int columns, const char *drawn) {
        QTest::newRow(name) << given << columns << QString::fromLatin1(drawn);
    };
    row("nothing", {}, 10, "");
    row("one a column", {{0, 1}, {100, 5}, {200, 3}}, 10, "0:1 100:5 200:3");
    row("lowest then highest", {{0, 3}, {20, 1}, {40, 2}, {60, 9}, {80, 4}}, 10, "20:1 60:9");
    row("highest then lowest", {{0, 3}, {20, 9}, {40, 1}}, 10, "20:9 40:1");
    row("all the same", {{0, 3}, {20, 3}, {40, 3}, {100, 3}}, 10, "0:3 100:3");
    row("gap inside a column", {{0, 1}, {20, 2}, {40, none}, {60, 4}, {80, 3}}, 10, "0:1 20:2 40:- 60:4 80:3");
    row("gap at its end", {{0, 1}, {90, none}, {100, 2}}, 10, "0:1 90:- 100:2");
    row("from before to after", {{-100, 1}, {1100, 2}}, 10, "-100:1 1100:2");
    row("no columns", {{0, 1}, {500, 2}, {900, 3}}, 0, "0:1 900:3");
}

void SeriesTest::decimates()
{
    QFETCH(Row, given);
    QFETCH(int, columns);
    QTEST(text(decimate(series(given), range(0, 1000), columns)), "drawn");
}

void SeriesTest::decimatedKeepsPeaksAndGaps()
{
    std::mt19937 random {7};
    std::normal_distribution<double> noise;
    Series given {4000};
    for (int i = 0; i < 3000; ++i) {
        if (i % 500 == 499)
            given.breakOff(zero + i * 100ms);
        else
            given.append(zero + i * 100ms, i == 1234 ? 1000.0 : noise(random));
    }
    const auto drawn = decimate(given, {zero, zero + 300s}, 200);
    const std::vector<Sample> all {given.samples().begin(), given.samples().end()};
    QVERIFY(extentOf(drawn) == extentOf(all));
    QCOMPARE(extentOf(drawn).highest, 1000.0);
    QCOMPARE(std::ranges::count_if(drawn, &Sample::isGap), 6);
    QVERIFY(drawn.size() <= 201 * 2 + 6 * 3);
    QVERIFY(std::ranges::is_sorted(drawn, {}, &Sample::at));
}

/// A range that wanders by less than a column draws the same inner points.
void SeriesTest::decimatedStandsStill()
{
    Series given {4000};
    for (int i = 0; i < 3000; ++i)
        given.append(zero + i * 100ms, i * 37 % 101);
    const auto first = decimate(given, {zero + 1000ms, zero + 201s}, 100);
    const auto second = decimate(given, {zero + 1300ms, zero + 201300ms}, 100);
    const std::vector inner(first.begin() + 4, first.end() - 4);
    QVERIFY(std::search(second.begin(), second.end(), inner.begin(), inner.end()) != second.end());
}

void SeriesTest::writesCsv()
{
    const Track one {{}, QStringLiteral("R1 X"), Unit::Millimetre, series({{0, 1024.318}, {100, none}, {250, -1}})};
    const Track two {{}, QStringLiteral("Servo on"), Unit::Bit, series({{100, 0}, {200, 1}, {900, 1}})};
    const Track *const tracks[] {&one, &two};
    QCOMPARE(toCsv(tracks, range(0, 300)),
        QByteArray("time_utc,R1 X (mm),Servo on\r\n"
                   "2027-01-15T08:00:00.000Z,1024.318,\r\n"
                   "2027-01-15T08:00:00.100Z,NaN,0\r\n"
                   "2027-01-15T08:00:00.200Z,,1\r\n"
                   "2027-01-15T08:00:00.250Z,-1,\r\n"));
    QCOMPARE(toCsv({}, range(0, 300)), QByteArray("time_utc\r\n"));
}

void SeriesTest::quotesHeadings_data()
{
    QTest::addColumn<QString>("label");
    QTest::addColumn<QByteArray>("heading");
    QTest::newRow("plain") << "B005" << QByteArray("B005");
    QTest::newRow("comma") << "Job line, sub task 1" << QByteArray("\"Job line, sub task 1\"");
    QTest::newRow("quote") << "the \"tip\"" << QByteArray("\"the \"\"tip\"\"\"");
    QTest::newRow("new line") << "a\nb" << QByteArray("\"a\nb\"");
}

void SeriesTest::quotesHeadings()
{
    QFETCH(QString, label);
    QFETCH(QByteArray, heading);
    const Track track {{}, label, Unit::Plain, Series {2}};
    const Track *const tracks[] {&track};
    QCOMPARE(toCsv(tracks, range(0, 1)), "time_utc," + heading + "\r\n");
}

void SeriesTest::roundLengths_data()
{
    QTest::addColumn<double>("length");
    QTest::addColumn<double>("round");
    QTest::newRow("1") << 1.0 << 1.0;
    QTest::newRow("1.9") << 1.9 << 1.0;
    QTest::newRow("2") << 2.0 << 2.0;
    QTest::newRow("4.9") << 4.9 << 2.0;
    QTest::newRow("7") << 7.0 << 5.0;
    QTest::newRow("99") << 99.0 << 50.0;
    QTest::newRow("0.03") << 0.03 << 0.02;
    QTest::newRow("0") << 0.0 << 1.0;
    QTest::newRow("negative") << -5.0 << 1.0;
    QTest::newRow("no number") << none << 1.0;
    QTest::newRow("infinite") << std::numeric_limits<double>::infinity() << 1.0;
}

void SeriesTest::roundLengths()
{
    QFETCH(double, length);
    QTEST(roundLength(length), "round");
}

void SeriesTest::scales_data()
{
    QTest::addColumn<double>("lowest");
    QTest::addColumn<double>("highest");
    QTest::addColumn<double>("from");
    QTest::addColumn<double>("to");
    QTest::addColumn<int>("ticks");
    QTest::newRow("0 to 1") << 0.0 << 1.0 << 0.0 << 1.0 << 3;
    QTest::newRow("0 to 100") << 0.0 << 100.0 << 0.0 << 100.0 << 3;
    QTest::newRow("-3 to 97") << -3.0 << 97.0 << -50.0 << 100.0 << 4;
    QTest::newRow("constant") << 5.0 << 5.0 << 4.0 << 6.0 << 3;
    QTest::newRow("constant 0") << 0.0 << 0.0 << -1.0 << 1.0 << 3;
    QTest::newRow("large constant") << 1e12 << 1e12 << 1e12 - 1 << 1e12 + 1 << 3;
    QTest::newRow("nothing") << 1.0 << 0.0 << 0.0 << 1.0 << 3;
}

void SeriesTest::scales()
{
    QFETCH(double, lowest);
    QFETCH(double, highest);
    const Scale scale = scaleFor({lowest, highest});
    QTEST(scale.lowest, "from");
    QTEST(scale.highest, "to");
    QTEST(scale.ticks(), "ticks");
}

void SeriesTest::keepsScale_data()
{
    QTest::addColumn<double>("lowest");
    QTest::addColumn<double>("highest");
    QTest::addColumn<bool>("isKept"); // of 0 to 100
    QTest::newRow("the same") << 0.0 << 100.0 << true;
    QTest::newRow("half") << 20.0 << 70.0 << true;
    QTest::newRow("a little outside") << -1.0 << 70.0 << false;
    QTest::newRow("much less") << 40.0 << 45.0 << false;
    QTest::newRow("nothing") << 1.0 << 0.0 << true;
}

void SeriesTest::keepsScale()
{
    QFETCH(double, lowest);
    QFETCH(double, highest);
    const Scale current {0, 100, 50};
    QTEST(kept(current, {lowest, highest}) == current, "isKept");
}

void SeriesTest::moments_data()
{
    QTest::addColumn<QString>("iso");
    QTest::addColumn<bool>("isValid");
    QTest::newRow("utc") << "2027-01-15T08:00:00.000Z" << true;
    QTest::newRow("another zone") << "2027-01-15T09:00:00.000+01:00" << true;
    QTest::newRow("empty") << "" << false;
    QTest::newRow("words") << "yesterday" << false;
    QTest::newRow("thirteenth month") << "2027-13-15T08:00:00.000Z" << false;
}

void SeriesTest::moments()
{
    QFETCH(QString, iso);
    QFETCH(bool, isValid);
    QVERIFY(fromIso(iso) == (isValid ? std::optional(zero) : std::nullopt));
    QCOMPARE(toIso(zero), QStringLiteral("2027-01-15T08:00:00.000Z"));
}

QTEST_GUILESS_MAIN(SeriesTest)

#include "tst_series.moc"
