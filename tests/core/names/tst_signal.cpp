// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "names/signal.h"
#include <QTest>

using namespace names;
using protocol::Model;

Q_DECLARE_METATYPE(names::Signal)
Q_DECLARE_METATYPE(protocol::Model)

/// Signals in both notations; the areas are those of reference §4.1.
class SignalTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void reads_data();
    void reads();
    void refuses_data();
    void refuses();
    void prints_data();
    void prints();
    void everySignalComesBack();
};

void SignalTest::reads_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<Signal>("signal");
    const auto row = [](const char *text, const Signal &signal) {
        QTest::newRow(text) << QString::fromUtf8(text) << signal;
    };
    row("#00010", {1, 0});
    row("#00017", {1, 7});
    row("10010", {1001, 0});
    row("00010", {1, 0}); // ten, never eight
    row("10", {1, 0});
    row("#27010", {2701, 0});
    row("# 87207", {8720, 7});
    row("IN#(1)", {1, 0});
    row("IN#(8)", {1, 7});
    row("IN#(9)", {2, 0});
    row("in#(0010)", {2, 1}); // the tenth
    row("OT#(1)", {1001, 0});
    row("OUT#(12)", {1002, 3});
    row("ot#( 12 )", {1002, 3});
    row("OT# 12", {1002, 3});
    row("IN1", {1, 0});
    row("IN#(4096)", {512, 7});
    row("＃０００１０", {1, 0});
}

void SignalTest::reads()
{
    QFETCH(QString, text);
    QFETCH(Signal, signal);
    const auto read = signalFromText(text, protocol::dialect(Model::YRC1000));
    QVERIFY2(read, read ? "" : qPrintable(read.error().detail));
    QCOMPARE(read->number(), signal.number());
}

void SignalTest::refuses_data()
{
    QTest::addColumn<Model>("model");
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("part");
    const auto row = [](Model model, const char *text, const char *part) {
        QTest::addRow("%s %d", text, int(model)) << model << QString::fromUtf8(text) << QString::fromUtf8(part);
    };
    row(Model::YRC1000, "", "is not a signal");
    row(Model::YRC1000, "#", "is not a signal");
    row(Model::YRC1000, "IN#()", "is not a signal");
    row(Model::YRC1000, "IN#(1", "is not a signal");
    row(Model::YRC1000, "IN#1)", "is not a signal");
    row(Model::YRC1000, "OTX#(1)", "is not a signal");
    row(Model::YRC1000, "#0x10", "is not a signal");
    row(Model::YRC1000, "-10", "is not a signal");
    row(Model::YRC1000, "#10.0", "is not a signal");
    row(Model::YRC1000, "#00018", "the last digit of a signal is 0 to 7");
    row(Model::YRC1000, "#00019", "the last digit of a signal is 0 to 7");
    row(Model::YRC1000, "#00000", "has no signal");
    row(Model::YRC1000, "#05130", "has no signal");
    row(Model::YRC1000, "#99999999999999999", "has no signal");
    row(Model::FS100, "#25010", "has no signal"); // a network input of a DX100
    row(Model::DX100, "#27570", "has no signal");
    row(Model::YRC1000, "IN#(0)", "IN#(1) to IN#(4096)");
    row(Model::YRC1000, "IN#(4097)", "IN#(1) to IN#(4096)");
    row(Model::DX100, "OT#(2049)", "OT#(1) to OT#(2048)");
}

void SignalTest::refuses()
{
    QFETCH(Model, model);
    QFETCH(QString, text);
    QFETCH(QString, part);
    const auto read = signalFromText(text, protocol::dialect(model));
    QVERIFY(!read);
    QVERIFY2(read.error().detail.contains(part), qPrintable(read.error().detail));
    QVERIFY(read.error().detail.endsWith(u'.'));
}

void SignalTest::prints_data()
{
    QTest::addColumn<Signal>("signal");
    QTest::addColumn<QString>("number");
    QTest::addColumn<QString>("inform");
    QTest::newRow("first input") << Signal {1, 0} << QStringLiteral("#00010") << QStringLiteral("IN#(1)");
    QTest::newRow("second group") << Signal {2, 3} << QStringLiteral("#00023") << QStringLiteral("IN#(12)");
    QTest::newRow("output") << Signal {1001, 7} << QStringLiteral("#10017") << QStringLiteral("OT#(8)");
    QTest::newRow("network input") << Signal {2701, 0} << QStringLiteral("#27010") << QString();
}

void SignalTest::prints()
{
    QFETCH(Signal, signal);
    QTEST(toString(signal), "number");
    QTEST(informName(signal, protocol::dialect(Model::YRC1000)), "inform");
}

void SignalTest::everySignalComesBack()
{
    for (const Model model : protocol::allModels) {
        const auto &dialect = protocol::dialect(model);
        for (const auto &[area, groups] : dialect.io) {
            for (int number = 1; number <= groups.count() * signalsPerGroup; ++number) {
                const auto signal = signalOf(area, number, dialect);
                QVERIFY(signal && dialect.ioArea(quint32(signal->group)) == area);
                QVERIFY(signalFromText(toString(*signal), dialect) == *signal);
                const QString inform = informName(*signal, dialect);
                QVERIFY(inform.isEmpty() || signalFromText(inform, dialect) == *signal);
            }
            QVERIFY(!signalOf(area, 0, dialect));
        }
    }
}

QTEST_APPLESS_MAIN(SignalTest)
#include "tst_signal.moc"
