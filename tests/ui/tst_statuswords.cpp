// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/words.h"
#include <QLocale>
#include <QTest>

using values::Status;
using widgets::Lamp;
using widgets::Word;

namespace {

Status status(quint32 data1, quint32 data2) { return {Status::Data1::fromInt(data1), Status::Data2::fromInt(data2)}; }

} // namespace

/// The bits are those of reference §3.4, as numbers.
class TestStatusWords : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void words_data();
    void words();
    void text_data();
    void text();
    void numbers();
    void job();
};

void TestStatusWords::words_data()
{
    using Function = Word (*)(const Status &);
    QTest::addColumn<Function>("function");
    QTest::addColumn<quint32>("data1");
    QTest::addColumn<quint32>("data2");
    QTest::addColumn<QString>("text");
    QTest::addColumn<Lamp>("lamp");
    const auto row = [](const char *name, Function function, quint32 data1, quint32 data2, const char *text,
                         Lamp lamp) {
        QTest::addRow("%s %02X %02X", name, data1, data2)
            << function << data1 << data2 << QString::fromUtf8(text) << lamp;
    };
    row("mode", ui::modeWord, 0xC2, 0, "REMOTE PLAY", Lamp::None); // as recorded from an idle YRC1000
    row("mode", ui::modeWord, 0x40, 0, "PLAY", Lamp::None);
    row("mode", ui::modeWord, 0x20, 0, "TEACH", Lamp::None);
    row("mode", ui::modeWord, 0xA0, 0, "REMOTE TEACH", Lamp::None);
    row("mode", ui::modeWord, 0x60, 0, "TEACH + PLAY", Lamp::Warning);
    row("mode", ui::modeWord, 0xE0, 0, "REMOTE TEACH + PLAY", Lamp::Warning);
    row("mode", ui::modeWord, 0x00, 0, "NO MODE", Lamp::Warning);
    row("cycle", ui::cycleWord, 0x01, 0, "STEP", Lamp::None);
    row("cycle", ui::cycleWord, 0x02, 0, "1 CYCLE", Lamp::None);
    row("cycle", ui::cycleWord, 0x04, 0, "CONTINUOUS", Lamp::None);
    row("cycle", ui::cycleWord, 0x05, 0, "STEP + CONTINUOUS", Lamp::Warning);
    row("cycle", ui::cycleWord, 0x07, 0, "STEP + 1 CYCLE + CONTINUOUS", Lamp::Warning);
    row("cycle", ui::cycleWord, 0x40, 0, "NO CYCLE", Lamp::Warning);
    row("run", ui::runWord, 0x08, 0, "RUNNING", Lamp::Filled);
    row("run", ui::runWord, 0xF7, 0xFF, "stopped", Lamp::Hollow);
    row("servo", ui::servoWord, 0, 0x40, "ON", Lamp::Filled);
    row("servo", ui::servoWord, 0xFF, 0xBF, "OFF", Lamp::Hollow);
    row("hold", ui::holdWord, 0, 0x00, "none", Lamp::Hollow);
    row("hold", ui::holdWord, 0, 0x02, "PENDANT", Lamp::Warning);
    row("hold", ui::holdWord, 0, 0x04, "EXTERNAL", Lamp::Warning);
    row("hold", ui::holdWord, 0, 0x08, "COMMAND", Lamp::Warning);
    row("hold", ui::holdWord, 0, 0x0A, "PENDANT + COMMAND", Lamp::Warning);
    row("hold", ui::holdWord, 0, 0x0E, "PENDANT + EXTERNAL + COMMAND", Lamp::Warning);
    row("hold", ui::holdWord, 0xFF, 0xF1, "none", Lamp::Hollow);
    row("pendant", ui::heldByPendantWord, 0, 0x02, "HELD", Lamp::Warning);
    row("pendant", ui::heldByPendantWord, 0, 0x0C, "no", Lamp::Hollow);
    row("external", ui::heldExternallyWord, 0, 0x04, "HELD", Lamp::Warning);
    row("external", ui::heldExternallyWord, 0, 0x0A, "no", Lamp::Hollow);
    row("command", ui::heldByCommandWord, 0, 0x08, "HELD", Lamp::Warning);
    row("command", ui::heldByCommandWord, 0, 0x06, "no", Lamp::Hollow);
    row("speed limit", ui::speedLimitWord, 0x10, 0, "ON", Lamp::Filled);
    row("speed limit", ui::speedLimitWord, 0xEF, 0, "off", Lamp::Hollow);
    row("alarm", ui::alarmWord, 0, 0x10, "ALARM", Lamp::Alarm);
    row("alarm", ui::alarmWord, 0, 0xEF, "none", Lamp::Hollow);
    row("error", ui::errorWord, 0, 0x20, "ERROR", Lamp::Warning);
    row("error", ui::errorWord, 0, 0xDF, "none", Lamp::Hollow);
    row("summary", ui::summaryWord, 0xCC, 0x40, "REMOTE PLAY · running", Lamp::Filled);
    row("summary", ui::summaryWord, 0xC4, 0x40, "REMOTE PLAY · idle", Lamp::Hollow);
    row("summary", ui::summaryWord, 0xC4, 0x48, "REMOTE PLAY · held", Lamp::Warning);
    row("summary", ui::summaryWord, 0xC4, 0x28, "REMOTE PLAY · error", Lamp::Warning);
    row("summary", ui::summaryWord, 0xCC, 0x38, "REMOTE PLAY · alarm", Lamp::Diamond);
    row("summary", ui::summaryWord, 0x68, 0x00, "TEACH + PLAY · contradictory", Lamp::Warning);
}

void TestStatusWords::words()
{
    using Function = Word (*)(const Status &);
    QFETCH(Function, function);
    QFETCH(quint32, data1);
    QFETCH(quint32, data2);
    QFETCH(QString, text);
    QFETCH(Lamp, lamp);
    const Word word = function(status(data1, data2));
    QCOMPARE(word.text, text);
    QVERIFY(word.lamp == lamp);
}

void TestStatusWords::text_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("text");
    QTest::newRow("empty") << QByteArray() << QString();
    QTest::newRow("ascii") << QByteArray("WELD_A12") << QStringLiteral("WELD_A12");
    QTest::newRow("latin-1") << QByteArray("GR\xD6SSE") << QStringLiteral("GRÖSSE");
    QTest::newRow("a byte that is no letter") << QByteArray("A\x8A"
                                                            "B")
                                              << QStringLiteral("A⟨8A⟩B");
    QTest::newRow("shift-jis") << QByteArray("\x8D\xC4") << QStringLiteral("⟨8D⟩Ä");
    QTest::newRow("control") << QByteArray("A\x1B\x7F") << QStringLiteral("A⟨1B⟩⟨7F⟩");
    QTest::newRow("line feed") << QByteArray("A\nB") << QStringLiteral("A⟨0A⟩B");
}

void TestStatusWords::text()
{
    QFETCH(QByteArray, bytes);
    QFETCH(QString, text);
    QCOMPARE(ui::controllerText(bytes), text);
}

void TestStatusWords::numbers()
{
    QCOMPARE(ui::millimetres(1277751), QStringLiteral("1277.751"));
    QCOMPARE(ui::millimetres(-1), QStringLiteral("-0.001"));
    QCOMPARE(ui::millimetres(std::numeric_limits<qint32>::min()), QStringLiteral("-2147483.648"));
    QCOMPARE(ui::degrees(1799984), QStringLiteral("179.9984"));
    QCOMPARE(ui::degrees(-120), QStringLiteral("-0.0120"));
    QCOMPARE(ui::roundTripText({}), QStringLiteral("—"));
    QCOMPARE(ui::roundTripText(std::chrono::microseconds {2140}), QStringLiteral("2.1 ms"));
    QCOMPARE(ui::percent(0.024), QStringLiteral("2.4 %"));
    QCOMPARE(ui::ageText({}), QStringLiteral("—"));
    QCOMPARE(ui::ageText(std::chrono::milliseconds {430}), QStringLiteral("0.4 s"));
    QCOMPARE(ui::ageText(std::chrono::minutes {5}), QStringLiteral("5 min"));
}

void TestStatusWords::job()
{
    values::ExecutingJob job;
    QCOMPARE(ui::jobName(job, protocol::Encoding::Latin1), QStringLiteral("—"));
    job = {values::JobName {"WELD_A12"}, 47, 12, 8000};
    QCOMPARE(ui::jobName(job, protocol::Encoding::Latin1), QStringLiteral("WELD_A12"));
    QCOMPARE(ui::jobPlace(job), QStringLiteral("line 47 · step 12 · 80 %"));
    job.speedOverride = 1250;
    QCOMPARE(ui::overrideText(job), QStringLiteral("12.5 %"));
}

QTEST_GUILESS_MAIN(TestStatusWords)
#include "tst_statuswords.moc"
