// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "trend/flightrecorder.h"
#include "trend/toolpath.h"
#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>

using namespace trend;
using namespace std::chrono_literals;
using robot::Kind;

namespace {

constexpr Moment zero {1'800'000'000'000ms};
constexpr Signal torque {{Kind::Torque, 1}, 0};
constexpr Signal servo {{Kind::Status, 1}, 14};

/// Records one number a second from `from` to `to` seconds, its value the second.
void record(FlightRecorder &recorder, const Signal &signal, int from, int to)
{
    for (int second = from; second <= to; ++second)
        recorder.take(signal, {double(second), Unit::Plain}, zero + std::chrono::seconds {second});
}

Incident incident()
{
    FlightRecorder recorder;
    record(recorder, torque, 0, 254);
    record(recorder, servo, 0, 254);
    recorder.note(zero + 230s, QStringLiteral("job WELD_A12"));
    recorder.trigger(zero + 250s, QStringLiteral("4315 collision detected"));
    recorder.breakOff({Kind::Status, 1}, zero + 255s);
    record(recorder, torque, 255, 300);
    record(recorder, servo, 260, 300);
    auto kept = recorder.tick(zero + 270s);
    kept->controller = QStringLiteral("CELL 4 · Weld");
    return *kept;
}

} // namespace

/// What is kept around an alarm, and the file of it; and the way of the tool point.
class FlightRecorderTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void keepsAMinuteBefore();
    void keepsWhatThereIs();
    void aValueThatStaysIsALine();
    void tellsOnce();
    void isBounded();
    void edges_data();
    void edges();
    void finishesEarly();
    void survivesAFile();
    void badFiles_data();
    void badFiles();
    void skipsUnknownSignals();
    void pathPoints();
    void pathStandsStill();
    void pathIsBounded();
    void pathForeignPositions_data();
    void pathForeignPositions();
};

void FlightRecorderTest::keepsAMinuteBefore()
{
    const Incident kept = incident();
    QVERIFY(kept.at == zero + 250s);
    QVERIFY((kept.range == Range {zero + 190s, zero + 270s}));
    QCOMPARE(kept.title, QStringLiteral("4315 collision detected"));
    QCOMPARE(kept.notes.size(), 2);
    QCOMPARE(kept.tracks.size(), std::size_t(2));
    const Series &series = kept.tracks[1].series; // status comes before torque
    QCOMPARE(series.samples().front().value, 190.0);
    QCOMPARE(series.back().value, 270.0);
    QCOMPARE(series.count(), std::size_t(81));
    const auto &samples = kept.tracks[0].series.samples();
    QCOMPARE(samples.size(), std::size_t(65 + 1 + 11)); // 190 to 254, the gap, 260 to 270
    QCOMPARE(std::ranges::count_if(samples, &Sample::isGap), 1);
}

/// Read all the time and never another: one sample at each end, though the recording goes on behind the incident.
void FlightRecorderTest::aValueThatStaysIsALine()
{
    FlightRecorder recorder;
    for (int second = 0; second <= 300; ++second)
        recorder.take(servo, {1, Unit::Bit}, zero + std::chrono::seconds {second});
    recorder.trigger(zero + 250s, QStringLiteral("4315 collision detected"));
    recorder.take(servo, {1, Unit::Bit}, zero + 301s);
    const auto kept = recorder.tick(zero + 270s);
    QVERIFY(kept && kept->tracks.size() == 1);
    const Series &series = kept->tracks[0].series;
    QCOMPARE(series.count(), std::size_t(2));
    QVERIFY((series.samples()[0] == Sample {zero + 190s, 1}));
    QVERIFY((series.samples()[1] == Sample {zero + 270s, 1}));
}

void FlightRecorderTest::keepsWhatThereIs()
{
    FlightRecorder recorder;
    record(recorder, torque, 0, 5);
    recorder.trigger(zero + 5s, QStringLiteral("alarm"));
    const auto kept = recorder.tick(zero + 25s);
    QVERIFY(kept);
    QCOMPARE(kept->tracks.front().series.count(), std::size_t(6));
    QVERIFY(kept->range.from == zero - 55s);
}

void FlightRecorderTest::tellsOnce()
{
    FlightRecorder recorder;
    QVERIFY(!recorder.tick(zero));
    recorder.trigger(zero, QStringLiteral("alarm"));
    QVERIFY(recorder.isKeeping());
    QVERIFY(!recorder.tick(zero + 19999ms));
    QVERIFY(recorder.tick(zero + 20s));
    QVERIFY(!recorder.tick(zero + 21s));
    QVERIFY(!recorder.isKeeping());
}

/// An hour at 10 Hz under a flood of notes and edges ends in incidents of five minutes at most.
void FlightRecorderTest::isBounded()
{
    FlightRecorder recorder;
    int told = 0;
    for (int i = 0; i < 36000; ++i) {
        const Moment at = zero + i * 100ms;
        recorder.take(torque, {double(i), Unit::Plain}, at);
        recorder.trigger(at, QString::number(i));
        if (const auto kept = recorder.tick(at)) {
            ++told;
            QVERIFY(kept->range.to - kept->range.from <= FlightRecorder::span);
            QVERIFY(kept->tracks.front().series.count() <= FlightRecorder::capacity);
            QVERIFY(kept->notes.size() <= 1000);
        }
    }
    QVERIFY(told >= 3600 / 300 && told <= 3600 / 240 + 1);
}

void FlightRecorderTest::edges_data()
{
    QTest::addColumn<QList<int>>("edges"); // seconds
    QTest::addColumn<QList<int>>("ends");
    QTest::newRow("one") << QList<int> {100} << QList<int> {120};
    QTest::newRow("second within twenty seconds") << QList<int> {100, 110} << QList<int> {130};
    QTest::newRow("second after them") << QList<int> {100, 121} << QList<int> {120, 141};
    QTest::newRow("third extends again") << QList<int> {100, 115, 130} << QList<int> {150};
}

void FlightRecorderTest::edges()
{
    QFETCH(QList<int>, edges);
    QList<int> ended;
    FlightRecorder recorder;
    for (int second = 0; second < 200; ++second) {
        record(recorder, torque, second, second);
        if (edges.contains(second))
            recorder.trigger(zero + std::chrono::seconds {second}, QStringLiteral("alarm"));
        if (const auto kept = recorder.tick(zero + std::chrono::seconds {second})) {
            ended << second;
            QVERIFY(kept->range.to == zero + std::chrono::seconds {second});
        }
    }
    QTEST(ended, "ends");
}

void FlightRecorderTest::finishesEarly()
{
    FlightRecorder recorder;
    QVERIFY(!recorder.finish(zero));
    record(recorder, torque, 0, 5);
    recorder.trigger(zero + 5s, QStringLiteral("alarm"));
    const auto kept = recorder.finish(zero + 7s);
    QVERIFY(kept);
    QVERIFY(kept->range.to == zero + 7s);
}

void FlightRecorderTest::survivesAFile()
{
    const Incident kept = incident();
    const QByteArray file = QJsonDocument(toJson(kept)).toJson();
    const auto read = incidentFromJson(QJsonDocument::fromJson(file).object());
    QVERIFY(read);
    QCOMPARE(read->controller, kept.controller);
    QCOMPARE(read->title, kept.title);
    QVERIFY(read->at == kept.at && read->range == kept.range && read->notes == kept.notes);
    QCOMPARE(read->tracks.size(), kept.tracks.size());
    for (std::size_t i = 0; i < kept.tracks.size(); ++i) {
        QVERIFY(read->tracks[i].signal == kept.tracks[i].signal);
        QVERIFY(read->tracks[i].unit == kept.tracks[i].unit);
        QCOMPARE(read->tracks[i].label, kept.tracks[i].label);
        QVERIFY(read->tracks[i].series.samples() == kept.tracks[i].series.samples());
    }
}

void FlightRecorderTest::badFiles_data()
{
    QTest::addColumn<QByteArray>("json");
    const QByteArray head = R"("version":1,"at":"2027-01-15T08:00:00.000Z","from":"2027-01-15T07:59:00.000Z",)"
                            R"("to":"2027-01-15T08:00:20.000Z")";
    const auto track = [&](const char *body) {
        return QByteArray("{" + head + R"(,"tracks":[{"signal":"torque.1.0",)" + body + "}]}");
    };
    QTest::newRow("nothing") << QByteArray("{}");
    QTest::newRow("later version") << QByteArray("{" + QByteArray(head).replace(":1,", ":2,") + "}");
    QTest::newRow("no time") << QByteArray(R"({"version":1})");
    QTest::newRow("bad time") << QByteArray("{" + QByteArray(head).replace("07:59", "77:59") + "}");
    QTest::newRow("alarm outside") << QByteArray("{" + QByteArray(head).replace("07:59", "08:01") + "}");
    QTest::newRow("bad note") << QByteArray("{" + head + R"(,"notes":[{"text":"when?"}]})");
    QTest::newRow("no unit known") << track(R"("unit":"furlong","samples":[])");
    QTest::newRow("sample alone") << track(R"("unit":"mm","samples":[5])");
    QTest::newRow("sample of three") << track(R"("unit":"mm","samples":[[0,1,2]])");
    QTest::newRow("sample of words") << track(R"("unit":"mm","samples":[["a","b"]])");
    QTest::newRow("time goes back") << track(R"("unit":"mm","samples":[[100,1],[0,2]])");
    QTest::newRow("same time twice") << track(R"("unit":"mm","samples":[[0,1],[0,2]])");
}

void FlightRecorderTest::badFiles()
{
    QFETCH(QByteArray, json);
    const QJsonDocument document = QJsonDocument::fromJson(json);
    QVERIFY(document.isObject());
    const auto read = incidentFromJson(document.object());
    QVERIFY(!read);
    QVERIFY(read.error().kind == values::ErrorKind::BadInput);
    QVERIFY(!read.error().detail.isEmpty());
}

void FlightRecorderTest::skipsUnknownSignals()
{
    QJsonObject json = toJson(incident());
    QJsonArray tracks = json[QStringLiteral("tracks")].toArray();
    QJsonObject track = tracks[0].toObject();
    track[QStringLiteral("signal")] = QStringLiteral("power.1.0");
    tracks[0] = track;
    json[QStringLiteral("tracks")] = tracks;
    const auto read = incidentFromJson(json);
    QVERIFY(read);
    QCOMPARE(read->tracks.size(), std::size_t(1));
}

namespace {

values::Position place(int x, int y, int z) { return {values::PositionType::Base, 0, 0, 0, 0, {x, y, z, 0, 0, 0}}; }

} // namespace

void FlightRecorderTest::pathPoints()
{
    ToolPath path;
    path.append(place(0, 0, 0));
    path.append(place(1000, 0, -500));
    path.breakOff();
    path.append(place(2000, 0, 0));
    QCOMPARE(path.points().size(), std::size_t(3));
    QVERIFY((path.points()[0] == PathPoint {{0, 0, 0}, true}));
    QVERIFY((path.points()[1] == PathPoint {{1, 0, -0.5}, false}));
    QVERIFY((path.points()[2] == PathPoint {{2, 0, 0}, true}));
    path.clear();
    QVERIFY(path.isEmpty());
}

/// The tremble of a standing robot leaves its present place and no more.
void FlightRecorderTest::pathStandsStill()
{
    ToolPath path;
    path.append(place(0, 0, 0));
    for (int i = 0; i < 1000; ++i)
        path.append(place(i % 3 * 10, 0, 0)); // 0, 0.01 and 0.02 mm
    QVERIFY(path.points().size() <= 2);
    path.append(place(20, 0, 0));
    QCOMPARE(path.points().back().mm[0], 0.02);
    path.append(place(0, 0, 0));
    QCOMPARE(path.points().size(), std::size_t(1));
    // Slow steps add up.
    for (int i = 1; i <= 100; ++i)
        path.append(place(i * 10, 0, 0)); // to 1 mm
    QCOMPARE(path.points().back().mm[0], 1.0);
    QVERIFY(path.points().size() >= 18 && path.points().size() <= 22);
}

void FlightRecorderTest::pathIsBounded()
{
    ToolPath path;
    for (int i = 0; i < 10000; ++i)
        path.append(place(i * 1000, 0, 0));
    QCOMPARE(path.points().size(), ToolPath::capacity);
    QCOMPARE(path.points().back().mm[0], 9999.0);
}

void FlightRecorderTest::pathForeignPositions_data()
{
    QTest::addColumn<int>("type");
    QTest::addColumn<int>("axes");
    QTest::newRow("pulses") << int(values::PositionType::Pulse) << 6;
    QTest::newRow("user frame") << int(values::PositionType::User) << 6;
    QTest::newRow("no axes") << int(values::PositionType::Base) << 0;
    QTest::newRow("two axes") << int(values::PositionType::Base) << 2;
}

void FlightRecorderTest::pathForeignPositions()
{
    QFETCH(int, type);
    QFETCH(int, axes);
    values::Position position;
    position.type = values::PositionType(type);
    position.axes.resize(axes);
    ToolPath path;
    path.append(position);
    QVERIFY(path.isEmpty());
}

QTEST_GUILESS_MAIN(FlightRecorderTest)

#include "tst_flightrecorder.moc"
