// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "settings/settingsfile.h"
#include "ui/models/iomodel.h"
#include "ui/models/variablemodel.h"
#include "ui/models/watchmodel.h"
#include "ui/widgets/table.h"
#include <QAbstractItemModelTester>
#include <QApplication>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace std::chrono_literals;
using models::IoModel;
using models::VariableModel;
using robot::Freshness;
using robot::Kind;
using variables::Reference;
using VariableKind = variables::Kind;
using Tester = QAbstractItemModelTester;

namespace {

robot::Time now() { return values::now(); }

values::Error refusal() { return {values::ErrorKind::Refused, 0x1F, 0xA001, {}}; }

/// Models on a state that the test fills; nothing is connected.
struct Desk {
    Desk()
        : file {folder.filePath(QStringLiteral("settings.json"))},
          controller {settings::Profile {}},
          orders {controller, access, arming},
          book {controller.profile(), settings::Notes {file, QStringLiteral("CELL 4")}},
          history {controller.state()},
          edits {orders, format},
          desk {controller.state(), history, edits, book, format, dialect}
    {
        state().setLinkUp(true, now());
    }
    [[nodiscard]] robot::RobotState &state() { return const_cast<robot::RobotState &>(controller.state()); }
    void take(int number, int value)
    {
        state().take<Kind::ByteVariable>(number, values::ByteVariable {quint8(value)}, now());
    }

    QTemporaryDir folder;
    settings::SettingsFile file;
    protocol::Dialect dialect = protocol::dialect(protocol::Model::YRC1000);
    robot::AccessRules rules;
    robot::Access access {rules};
    robot::Arming arming {std::chrono::hours {1}}; ///< However busy the computer is.
    robot::Controller controller;
    robot::Orders orders;
    robot::NameBook book;
    variables::Format format;
    robot::VariableHistory history;
    robot::Edits edits;
    models::VariableDesk desk;
};

QList<Reference> bytes(int count)
{
    QList<Reference> result;
    for (int number = 0; number < count; ++number)
        result << Reference {VariableKind::B, number};
    return result;
}

QString text(const QAbstractItemModel &model, int row, int column)
{
    return model.index(row, column).data().toString();
}

} // namespace

class TestModels : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { QLocale::setDefault(QLocale::c()); }
    void variablesInEveryState();
    void variablesAreStaged();
    void variablesChangeInPlace();
    void watchPages();
    void namesAndRemarksAreEdited();
    void registersInFourBases();
    void lampsInEveryState();
    void lampsAreNamed();
    void manyLampsAreCheap();
    void watchedSignals();
};

void TestModels::variablesInEveryState()
{
    Desk desk;
    VariableModel model {desk.desk, bytes(100)};
    const Tester tester {&model, Tester::FailureReportingMode::QtTest};
    QCOMPARE(text(model, 7, VariableModel::Number), QStringLiteral("B007"));
    QCOMPARE(text(model, 7, VariableModel::Value), QStringLiteral("—")); // unknown is never 0
    desk.take(7, 17);
    QCOMPARE(text(model, 7, VariableModel::Value), QStringLiteral("17"));
    QCOMPARE(text(model, 7, VariableModel::Previous), QStringLiteral("—"));
    desk.take(7, 18);
    QCOMPARE(text(model, 7, VariableModel::Previous), QStringLiteral("17"));
    const QModelIndex value = model.index(7, VariableModel::Value);
    QVERIFY(!value.data(widgets::HatchedRole).toBool());
    desk.state().setLinkUp(false, now());
    QVERIFY(value.data(widgets::HatchedRole).toBool());
    QVERIFY(value.data(Qt::ToolTipRole).toString().startsWith(QStringLiteral("Last seen")));
    QVERIFY(value.data(Qt::AccessibleTextRole).toString().contains(QStringLiteral("B007, Value: 18")));
    desk.state().setLinkUp(true, now());
    desk.state().refuse({Kind::ByteVariable, 8, 8}, refusal(), now());
    QCOMPARE(text(model, 8, VariableModel::Value), QStringLiteral("—"));
    QVERIFY(text(model, 8, VariableModel::Note).contains(QStringLiteral("0xA001")));
}

void TestModels::variablesAreStaged()
{
    Desk desk;
    VariableModel model {desk.desk, bytes(100)};
    const Tester tester {&model, Tester::FailureReportingMode::QtTest};
    desk.take(2, 2);
    const QModelIndex value = model.index(2, VariableModel::Value);
    QVERIFY(!model.setData(value, QStringLiteral("256"), Qt::EditRole));
    QVERIFY(model.complaint(value, QStringLiteral("256")).contains(QStringLiteral("from 0 to 255")));
    QVERIFY(desk.edits.staged().isEmpty());
    QVERIFY(model.setData(value, QStringLiteral("5"), Qt::EditRole));
    QCOMPARE(value.data().toString(), QStringLiteral("2 → 5"));
    QCOMPARE(value.data(widgets::GroundRole).toInt(), int(ui::Role::AmberGround));
    QCOMPARE(text(model, 2, VariableModel::Note), QStringLiteral("not sent yet"));
    QCOMPARE(value.data(Qt::EditRole).toString(), QStringLiteral("5"));
    QCOMPARE(value.data(VariableModel::LiveTextRole).toString(), QStringLiteral("2"));
    desk.take(2, 3);
    QCOMPARE(value.data().toString(), QStringLiteral("3 → 5"));
    desk.edits.discard({VariableKind::B, 2});
    QCOMPARE(value.data().toString(), QStringLiteral("3"));
}

void TestModels::variablesChangeInPlace()
{
    Desk desk;
    VariableModel model {desk.desk, bytes(100)};
    QSignalSpy changed {&model, &VariableModel::dataChanged};
    QSignalSpy reset {&model, &VariableModel::modelReset};
    const QPersistentModelIndex kept {model.index(42, VariableModel::Value)};
    QList<values::ByteVariable> values(100);
    values[42].value = 9;
    desk.state().takeAll<Kind::ByteVariable>(0, values, now());
    QCOMPARE(changed.count(), 1); // all that one packet brought, at once
    QCOMPARE(reset.count(), 0);
    QCOMPARE(kept.data().toString(), QStringLiteral("9"));
    desk.state().take<Kind::IntegerVariable>(1, {}, now());
    QCOMPARE(changed.count(), 1);
}

void TestModels::watchPages()
{
    Desk desk;
    VariableModel model {desk.desk, {}};
    const Tester tester {&model, Tester::FailureReportingMode::QtTest};
    model.append({VariableKind::B, 7});
    model.append({VariableKind::M, 560});
    model.append({VariableKind::P, 0});
    model.append({VariableKind::B, 7});
    QCOMPARE(model.rowCount(), 3);
    QVERIFY(model.isWritable(0));
    QVERIFY(!model.isWritable(1));
    QVERIFY(!(model.flags(model.index(2, VariableModel::Value)) & Qt::ItemIsEditable)); // it has its dialog
    desk.take(7, 5);
    QCOMPARE(text(model, 0, VariableModel::Value), QStringLiteral("5"));
    model.removeAt(0);
    QCOMPARE(model.rowOf({VariableKind::B, 7}), -1);
    QCOMPARE(model.rowOf({VariableKind::P, 0}), 1);
}

void TestModels::namesAndRemarksAreEdited()
{
    Desk desk;
    VariableModel model {desk.desk, bytes(10)};
    const Tester tester {&model, Tester::FailureReportingMode::QtTest};
    const QModelIndex name = model.index(1, VariableModel::Name);
    QCOMPARE(name.data().toString(), QStringLiteral("—"));
    QVERIFY(model.setData(name, QStringLiteral("Recipe"), Qt::EditRole));
    QCOMPARE(name.data().toString(), QStringLiteral("Recipe (local)"));
    QCOMPARE(name.data(Qt::EditRole).toString(), QStringLiteral("Recipe"));
    QVERIFY(model.setData(model.index(1, VariableModel::Note), QStringLiteral("1 to 6"), Qt::EditRole));
    QCOMPARE(text(model, 1, VariableModel::Note), QStringLiteral("1 to 6"));
}

void TestModels::registersInFourBases()
{
    Desk desk;
    VariableModel model {desk.desk, {{VariableKind::M, 0}, {VariableKind::M, 560}}};
    desk.state().take<Kind::Register>(0, values::Register {0xFFFE}, now());
    const QModelIndex value = model.index(0, VariableModel::Value);
    const std::pair<variables::Base, const char *> rows[] {{variables::Base::Decimal, "65534"},
        {variables::Base::Signed, "-2"}, {variables::Base::Hex, "0xFFFE"},
        {variables::Base::Binary, "0b1111111111111110"}};
    for (const auto &[base, expected] : rows) {
        desk.format.registerBase = base;
        model.formatChanged();
        QCOMPARE(value.data().toString(), QLatin1String(expected));
    }
    QVERIFY(!(model.flags(model.index(1, VariableModel::Value)) & Qt::ItemIsEditable));
}

void TestModels::lampsInEveryState()
{
    Desk desk;
    IoModel model {desk.state(), desk.book, desk.dialect, {1, 64}};
    const Tester tester {&model, Tester::FailureReportingMode::QtTest};
    QCOMPARE(model.rowCount(), 64);
    QCOMPARE(text(model, 0, 0), QStringLiteral("—"));
    desk.state().take<Kind::IoGroup>(1, values::IoGroup {0b0000'0101}, now());
    QCOMPARE(text(model, 0, 0), QStringLiteral("1"));
    QCOMPARE(text(model, 0, 1), QStringLiteral("0"));
    QVERIFY(!model.lamp(model.index(0, 0)).isRecent); // the first reading is no change
    desk.state().take<Kind::IoGroup>(1, values::IoGroup {0b0000'0100}, now());
    QVERIFY(model.lamp(model.index(0, 0)).isRecent);
    QVERIFY(!model.lamp(model.index(0, 2)).isRecent);
    model.tick(now() + 1s);
    QVERIFY(model.lamp(model.index(0, 0)).isRecent);
    model.tick(now() + 2s);
    QVERIFY(!model.lamp(model.index(0, 0)).isRecent);
    desk.state().setLinkUp(false, now());
    QVERIFY(model.lamp(model.index(0, 2)).freshness == Freshness::Stale);
    QVERIFY(
        model.index(0, 2).data(Qt::AccessibleTextRole).toString().contains(QStringLiteral("#00012 IN#(3): 1. Last")));
    QSignalSpy refused {&model, &IoModel::refusedRowsChanged};
    desk.state().setLinkUp(true, now());
    desk.state().refuse({Kind::IoGroup, 2, 3}, refusal(), now());
    QCOMPARE(model.refusedRows(), (QList<int> {1, 2}));
    QCOMPARE(refused.count(), 1);
    QCOMPARE(text(model, 1, 0), QStringLiteral("refused"));
    QVERIFY(model.indexOf({64, 7}).isValid());
    QVERIFY(!model.indexOf({65, 0}).isValid());
}

void TestModels::lampsAreNamed()
{
    Desk desk;
    IoModel model {desk.state(), desk.book, desk.dialect, {2701, 2956}};
    const Tester tester {&model, Tester::FailureReportingMode::QtTest};
    const QModelIndex index = model.indexOf({2701, 3});
    QCOMPARE(model.lamp(index).address, QStringLiteral("#27013"));
    QVERIFY(model.setData(index, QStringLiteral("Request"), Qt::EditRole));
    QVERIFY(model.lamp(index).name.isLocal);
    QVERIFY(index.data(Qt::AccessibleTextRole).toString().contains(QStringLiteral("Request")));
}

/// One packet of 64 groups in which nothing changed repaints nothing.
void TestModels::manyLampsAreCheap()
{
    Desk desk;
    IoModel model {desk.state(), desk.book, desk.dialect, {1, 512}};
    QList<values::IoGroup> groups(64);
    desk.state().takeAll<Kind::IoGroup>(1, groups, now());
    QSignalSpy changed {&model, &IoModel::dataChanged};
    desk.state().takeAll<Kind::IoGroup>(1, groups, now());
    QCOMPARE(changed.count(), 0);
    groups[5].bits = 1;
    desk.state().takeAll<Kind::IoGroup>(1, groups, now());
    QCOMPARE(changed.count(), 1);
}

void TestModels::watchedSignals()
{
    Desk desk;
    robot::SignalWatch watch {desk.state()};
    watch.add({1, 0});
    models::WatchModel model {desk.state(), watch, desk.book, desk.dialect};
    const Tester tester {&model, Tester::FailureReportingMode::QtTest};
    QCOMPARE(text(model, 0, models::WatchModel::Value), QStringLiteral("—"));
    watch.add({2701, 0});
    QCOMPARE(model.rowCount(), 2);
    for (const int bits : {0, 1, 0})
        desk.state().take<Kind::IoGroup>(1, values::IoGroup {quint8(bits)}, now());
    QCOMPARE(text(model, 0, models::WatchModel::Rises), QStringLiteral("1"));
    QCOMPARE(text(model, 0, models::WatchModel::Falls), QStringLiteral("1"));
    QCOMPARE(text(model, 0, models::WatchModel::Value), QStringLiteral("□ 0"));
    watch.remove({1, 0});
    QCOMPARE(model.rowCount(), 1);
    QCOMPARE(text(model, 0, models::WatchModel::Address), QStringLiteral("#27010"));
}

QTEST_MAIN(TestModels)
#include "tst_models.moc"
