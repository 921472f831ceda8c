// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "trend/signal.h"
#include <QTest>

using namespace trend;
using robot::Kind;

/// Names of numbers, and the numbers themselves.
class SignalTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void keys_data();
    void keys();
    void everyUsedSignalHasAKey();
    void badKeys_data();
    void badKeys();
    void drags();
    void labels_data();
    void labels();
    void quantities_data();
    void quantities();
    void groups_data();
    void groups();
};

Q_DECLARE_METATYPE(trend::Signal)
Q_DECLARE_METATYPE(std::optional<trend::Quantity>)

void SignalTest::keys_data()
{
    QTest::addColumn<Signal>("signal");
    QTest::addColumn<QString>("key");
    QTest::newRow("torque") << Signal {{Kind::Torque, 1}, 0} << "torque.1.0";
    QTest::newRow("cartesian") << Signal {{Kind::Position, 101}, 2} << "position.101.2";
    QTest::newRow("servo on") << Signal {{Kind::Status, 1}, 14} << "status.1.14";
    QTest::newRow("input") << Signal {{Kind::IoGroup, 2701}, 7} << "io.2701.7";
    QTest::newRow("register") << Signal {{Kind::Register, 0}, 0} << "m.0.0";
    QTest::newRow("position variable") << Signal {{Kind::PositionVariable, 12}, 5} << "p.12.5";
}

void SignalTest::keys()
{
    QFETCH(Signal, signal);
    QTEST(key(signal), "key");
    QVERIFY(fromKey(key(signal)) == signal);
}

void SignalTest::everyUsedSignalHasAKey()
{
    for (int kind = 0; kind < robot::kindCount; ++kind) {
        for (int element = 0; element < elementCount(Kind(kind)); ++element) {
            const Signal signal {{Kind(kind), 3}, quint16(element)};
            QCOMPARE(fromKey(key(signal)).has_value(), isUsed(signal));
            QCOMPARE(label(signal).isEmpty(), !isUsed(signal));
        }
    }
}

void SignalTest::badKeys_data()
{
    QTest::addColumn<QString>("key");
    for (const char *key : {"", ".", "..", "torque", "torque.1", "torque.1.8", "torque.1.-1", "torque.1.0.0",
             "torque.01.0", "torque.70000.0", "torque.x.0", "Torque.1.0", " torque.1.0", "torque.+1.0", "names.1.0",
             "s.1.0", "status.1.8", "status.1.16", "power.1.0"})
        QTest::newRow(*key ? key : "empty") << QString::fromLatin1(key);
}

void SignalTest::badKeys()
{
    QFETCH(QString, key);
    QVERIFY(!fromKey(key));
}

void SignalTest::drags()
{
    const QList<Signal> list {{{Kind::Torque, 1}, 0}, {{Kind::ByteVariable, 5}, 0}};
    QCOMPARE(toMime(list), QByteArray("torque.1.0\nb.5.0\n"));
    QVERIFY(fromMime(toMime(list)) == list);
    QVERIFY(fromMime("torque.1.0\nrubbish\xff\n\nb.5.0") == list);
    QVERIFY(fromMime({}).isEmpty());
}

void SignalTest::labels_data()
{
    QTest::addColumn<Signal>("signal");
    QTest::addColumn<QString>("axis");
    QTest::addColumn<QString>("label");
    QTest::newRow("named axis") << Signal {{Kind::Position, 101}, 0} << "X"
                                << "R1 X";
    QTest::newRow("unnamed axis") << Signal {{Kind::Position, 21}, 0} << ""
                                  << "S1 1";
    QTest::newRow("torque") << Signal {{Kind::Torque, 1}, 0} << "S"
                            << "R1 S torque";
    QTest::newRow("status") << Signal {{Kind::Status, 1}, 11} << ""
                            << "Held by command";
    QTest::newRow("job") << Signal {{Kind::Job, 0}, 0} << ""
                         << "Job line";
    QTest::newRow("sub task") << Signal {{Kind::Job, 2}, 1} << ""
                              << "Job step, sub task 2";
    QTest::newRow("io") << Signal {{Kind::IoGroup, 2701}, 3} << ""
                        << "#27013";
    QTest::newRow("low io") << Signal {{Kind::IoGroup, 1}, 0} << ""
                            << "#00010";
    QTest::newRow("register") << Signal {{Kind::Register, 5}, 0} << ""
                              << "M005";
    QTest::newRow("variable") << Signal {{Kind::RealVariable, 99}, 0} << ""
                              << "R099";
    QTest::newRow("position variable") << Signal {{Kind::PositionVariable, 7}, 2} << "Z"
                                       << "P007 Z";
}

void SignalTest::labels()
{
    QFETCH(Signal, signal);
    QFETCH(QString, axis);
    QTEST(label(signal, axis), "label");
}

void SignalTest::quantities_data()
{
    QTest::addColumn<std::optional<Quantity>>("found");
    QTest::addColumn<double>("value");
    QTest::addColumn<int>("unit");
    const auto row = [](const char *name, const std::optional<Quantity> &found, double value, Unit unit) {
        QTest::newRow(name) << found << value << int(unit);
    };
    // Units: reference §5.1, §3.5, §3.8, §3.9, §3.11.
    const values::Position base {values::PositionType::Base, 0, 0, 0, 0, {1024318, 0, 0, 1799984, 0, 0}};
    const values::Position pulse {values::PositionType::Pulse, 0, 0, 0, 0, {-12408, 5}};
    const auto none = [](const char *name, const std::optional<Quantity> &found) {
        QTest::newRow(name) << found << std::nan("") << 0;
    };
    row("length", quantity(base, 0), 1024.318, Unit::Millimetre);
    row("angle", quantity(base, 3), 179.9984, Unit::Degree);
    row("pulses", quantity(pulse, 0), -12408, Unit::Pulse);
    none("axis that the arm lacks", quantity(pulse, 2));
    none("negative axis", quantity(pulse, -1));
    row("following error", quantity(values::FollowingError {{-3}}, 0), -3, Unit::Pulse);
    row("torque is raw", quantity(values::Torque {{250}}, 0), 250, Unit::Plain);
    row("encoder", quantity(values::EncoderTemperatures {{41, 42}}, 1), 42, Unit::Celsius);
    row("converter", quantity(values::ConverterTemperature {{39}}, 0), 39, Unit::Celsius);
    none("converter has one", quantity(values::ConverterTemperature {{39}}, 1));
    row("override", quantity(values::ExecutingJob {{}, 47, 12, 8050}, 2), 80.5, Unit::Percent);
    row("line", quantity(values::ExecutingJob {{}, 47, 12, 8050}, 0), 47, Unit::Plain);
    const values::Status status {values::Status::Running, values::Status::ServoOn};
    row("running", quantity(status, 3), 1, Unit::Bit);
    row("not held", quantity(status, 11), 0, Unit::Bit);
    row("servo", quantity(status, 14), 1, Unit::Bit);
    none("no such bit", quantity(status, 16));
    row("input off", quantity(values::IoGroup {0x08}, 2), 0, Unit::Bit);
    row("input on", quantity(values::IoGroup {0x08}, 3), 1, Unit::Bit);
    row("register is unsigned", quantity(values::Register {65535}, 0), 65535, Unit::Plain);
    row("integer", quantity(values::IntegerVariable {-32767}, 0), -32767, Unit::Plain);
    row("hours", quantity(values::ManagementTime {{}, values::FixedText<12> {"18:30'00"}}, 0), 18.5, Unit::Hour);
    none("text that is no time", quantity(values::ManagementTime {{}, values::FixedText<12> {"soon"}}, 0));
    none("a string", quantity(values::StringVariable32 {}, 0));
}

void SignalTest::quantities()
{
    QFETCH(std::optional<Quantity>, found);
    QFETCH(double, value);
    QFETCH(int, unit);
    if (std::isnan(value)) {
        QVERIFY(!found);
    } else {
        QVERIFY(found);
        QCOMPARE(found->value, value);
        QCOMPARE(int(found->unit), unit);
    }
}

void SignalTest::groups_data()
{
    QTest::addColumn<int>("instance");
    QTest::addColumn<QString>("name");
    // Reference §2.1.
    QTest::newRow("R1") << 1 << "R1";
    QTest::newRow("R8") << 8 << "R8";
    QTest::newRow("B1") << 11 << "B1";
    QTest::newRow("S1") << 21 << "S1";
    QTest::newRow("S24") << 44 << "S24";
    QTest::newRow("R2, cartesian") << 102 << "R2";
    QTest::newRow("B8, cartesian") << 118 << "B8";
    QTest::newRow("none") << 0 << "group 0";
    QTest::newRow("9") << 9 << "group 9";
    QTest::newRow("S25") << 45 << "group 45";
    QTest::newRow("a station has no frame") << 121 << "group 121";
    QTest::newRow("201") << 201 << "group 201";
}

void SignalTest::groups()
{
    QFETCH(int, instance);
    QTEST(values::toString(values::ControlGroup {quint16(instance)}), "name");
}

QTEST_GUILESS_MAIN(SignalTest)

#include "tst_trendsignal.moc"
