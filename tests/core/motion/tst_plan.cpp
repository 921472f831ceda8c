// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "motion/jogstep.h"
#include <QTest>
#include <cmath>

using motion::CartesianOrder;
using motion::JogChoice;
using motion::JogFrame;
using motion::Limits;
using motion::Plan;
using motion::Present;
using motion::PulseOrder;
using motion::Wish;
using values::AxisWords;
using values::CartesianMove;
using values::ControlGroup;
using values::Position;
using values::PositionType;
using values::SpeedClass;

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

/// 1000, 0, 500 mm, the tool pointing along the base frame.
Present present()
{
    return {Position {PositionType::Base, 0x04, 2, 0, 0, {1'000'000, 0, 500'000, 0, 0, 0}},
        Position {PositionType::Pulse, 0, 2, 0, 0, {100, 200, 300, 400, 500, 600}}, {}, false};
}

Wish wish(Wish::How how, PositionType frame, AxisWords axes)
{
    Wish wish;
    wish.how = how;
    wish.frame = frame;
    wish.axes = axes;
    return wish;
}

Limits boxed()
{
    Limits limits;
    limits.box = motion::Box {{900, -100, 400}, {1100, 100, 600}};
    return limits;
}

const values::CartesianTarget &cartesian(const Plan &plan) { return std::get<CartesianOrder>(plan.order).target; }

} // namespace

using Change = std::function<void(Wish &, Present &, Limits &)>;
Q_DECLARE_METATYPE(Change)

/// What is told about a move before it is sent, and what is never sent.
class TestPlan : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void straight_data();
    void straight();
    void goesOut();
    void pulses();
    void station();
    void withheld_data();
    void withheld();
    void isLong_data();
    void isLong();
    void steps_data();
    void steps();
};

void TestPlan::straight_data()
{
    QTest::addColumn<AxisWords>("target");
    QTest::addColumn<double>("length");
    QTest::addColumn<double>("angle");
    QTest::addColumn<int>("milliseconds");
    QTest::addColumn<int>("speedClass");
    QTest::addColumn<quint32>("speed");
    const auto row = [](const char *name, AxisWords target, double length, double angle, int milliseconds,
                         SpeedClass speedClass, quint32 speed) {
        QTest::newRow(name) << target << length << angle << milliseconds << int(speedClass) << speed;
    };
    // 10 mm/s is 100 on the wire, 3 °/s is 30 (reference §6.2).
    row("X 30 mm", {1'030'000, 0, 500'000, 0, 0, 0}, 30, 0, 3000, SpeedClass::ToolPoint, 100);
    row("3-4-5", {1'030'000, 40'000, 500'000, 0, 0, 0}, 50, 0, 5000, SpeedClass::ToolPoint, 100);
    row("Rz 9 degrees", {1'000'000, 0, 500'000, 0, 0, 90'000}, 0, 9, 3000, SpeedClass::Rotation, 30);
    row("turning takes longer", {1'010'000, 0, 500'000, 0, 0, 90'000}, 10, 9, 3000, SpeedClass::Rotation, 30);
    row("going takes longer", {1'050'000, 0, 500'000, 0, 0, 90'000}, 50, 9, 5000, SpeedClass::ToolPoint, 100);
    row("the short way round", {1'000'000, 0, 500'000, 0, 0, -3'570'000}, 0, 3, 1000, SpeedClass::Rotation, 30);
}

void TestPlan::straight()
{
    QFETCH(AxisWords, target);
    const auto plan = motion::plan(wish(Wish::How::Straight, PositionType::Base, target), present(), Limits {});
    QVERIFY2(plan, plan ? "" : qPrintable(plan.error().detail));
    QFETCH(double, length);
    QFETCH(double, angle);
    QFETCH(int, milliseconds);
    QVERIFY(std::abs(*plan->length - length) < 1e-6);
    QVERIFY(std::abs(*plan->angle - angle) < 1e-6);
    QVERIFY(std::abs(int(plan->time->count()) - milliseconds) <= 1);
    QTEST(int(cartesian(*plan).speed.kind), "speedClass");
    QTEST(cartesian(*plan).speed.value, "speed");
    QVERIFY(plan->target->axes == target);
}

/// Every word of the order (reference §6.2).
void TestPlan::goesOut()
{
    Wish asked = wish(Wish::How::Joint, PositionType::Base, {1'010'000, -20'000, 500'000, 1, -2, 3});
    asked.group = ControlGroup::robotPulse(2);
    asked.form = 0x25;
    asked.extendedForm = 0x12;
    asked.tool = 7;
    asked.speeds.joint = 2.5;
    const auto plan = motion::plan(asked, present(), Limits {});
    QVERIFY(plan);
    QVERIFY(std::get<CartesianOrder>(plan->order).how == CartesianMove::JointAbsolute);
    const auto &target = cartesian(*plan);
    QCOMPARE(target.robot, 2U);
    QCOMPARE(target.station, 0U);
    QVERIFY(target.speed.kind == SpeedClass::Percent);
    QCOMPARE(target.speed.value, 250U); // 0.01 %
    QVERIFY(target.frame == PositionType::Base);
    QVERIFY((target.xyz == std::array<qint32, 3> {1'010'000, -20'000, 500'000}));
    QVERIFY((target.rotation == std::array<qint32, 4> {1, -2, 3, 0}));
    QCOMPARE(target.form, 0x25U);
    QCOMPARE(target.extendedForm, 0x12U);
    QCOMPARE(target.tool, 7U);
    QCOMPARE(target.userFrame, 0U);
    QVERIFY(!plan->time); // nobody knows how fast a percent is
    QCOMPARE(plan->watched.instance, quint16(102));
}

void TestPlan::pulses()
{
    const auto plan =
        motion::plan(wish(Wish::How::Joint, PositionType::Pulse, {1, 2, 3, 4, 5, 6}), present(), Limits {});
    QVERIFY(plan);
    const auto &order = std::get<PulseOrder>(plan->order);
    QVERIFY(order.how == values::PulseMove::JointAbsolute);
    QVERIFY((order.target.axes == std::array<qint32, 8> {1, 2, 3, 4, 5, 6, 0, 0}));
    QCOMPARE(order.target.robot, 1U);
    QVERIFY((plan->target->axes == AxisWords {1, 2, 3, 4, 5, 6}));
    QVERIFY(!plan->length && !plan->angle && plan->isLong());
    QCOMPARE(plan->watched.instance, quint16(1));
}

void TestPlan::station()
{
    Wish asked = wish(Wish::How::Joint, PositionType::Pulse, {1000, -5});
    asked.group = ControlGroup::stationPulse(3);
    Present here;
    here.pulse = Position {PositionType::Pulse, 0, 0, 0, 0, {0, 0}};
    const auto plan = motion::plan(asked, here, Limits {});
    QVERIFY(plan);
    const auto &target = std::get<PulseOrder>(plan->order).target;
    QCOMPARE(target.robot, 0U); // together they are refused (reference §6.3)
    QCOMPARE(target.station, 3U);
    QVERIFY((target.stationAxes == std::array<qint32, 6> {1000, -5, 0, 0, 0, 0}));
    QVERIFY((target.axes == std::array<qint32, 8> {}));
}

void TestPlan::withheld_data()
{
    QTest::addColumn<Change>("change");
    QTest::addColumn<QString>("says");
    const auto row = [](const char *name, Change change, const char *says) {
        QTest::newRow(name) << std::move(change) << QString::fromUtf8(says);
    };
    row(
        "speed 0", [](auto &wish, auto &, auto &) { wish.speeds.tool = 0; }, "speed");
    row(
        "speed negative", [](auto &wish, auto &, auto &) { wish.speeds.tool = -1; }, "speed");
    row(
        "speed no number", [](auto &wish, auto &, auto &) { wish.speeds.tool = notANumber; }, "speed");
    row(
        "above the ceiling", [](auto &wish, auto &, auto &) { wish.speeds.tool = 250.1; }, "250 mm/s");
    row(
        "above the profile's limit",
        [](auto &wish, auto &, auto &limits) {
            limits.toolSpeed = 20;
            wish.speeds.tool = 21;
        },
        "20 mm/s");
    row(
        "rotation too fast", [](auto &wish, auto &, auto &) { wish.speeds.rotation = 31; }, "30 °/s");
    row(
        "joint too fast", [](auto &wish, auto &, auto &) { wish.speeds.joint = 6; }, "5 %");
    row(
        "nothing was read", [](auto &, auto &present, auto &) { present.base.reset(); }, "not read");
    row(
        "target outside the box",
        [](auto &wish, auto &, auto &limits) {
            limits = boxed();
            wish.axes[2] = 601'000;
        },
        "box");
    row(
        "begin outside the box",
        [](auto &, auto &present, auto &limits) {
            limits = boxed();
            present.base->axes[1] = 101'000;
        },
        "outside the box");
    row(
        "user frame, never checked", [](auto &wish, auto &, auto &) { wish.frame = PositionType::User; }, "checked");
    row(
        "tool frame, never checked", [](auto &wish, auto &, auto &) { wish.frame = PositionType::Tool; }, "checked");
    row(
        "user frame 0",
        [](auto &wish, auto &, auto &limits) {
            limits.areFramesChecked = true;
            wish.frame = PositionType::User;
        },
        "1 to 63");
    row(
        "absolute in a frame that cannot be read",
        [](auto &wish, auto &, auto &limits) {
            limits.areFramesChecked = true;
            wish.frame = PositionType::User;
            wish.userFrame = 1;
        },
        "how far");
    row(
        "robot frame on base axes",
        [](auto &wish, auto &present, auto &) {
            present.hasTrack = true;
            wish.frame = PositionType::Robot;
        },
        "how far");
    row(
        "base axes not given", [](auto &, auto &present, auto &) { present.hasTrack = true; }, "base axes");
    row(
        "tool 64", [](auto &wish, auto &, auto &) { wish.tool = 64; }, "0 to 63");
    row(
        "straight in pulses", [](auto &wish, auto &, auto &) { wish.frame = PositionType::Pulse; }, "joint move");
    row(
        "pulses with a box",
        [](auto &wish, auto &, auto &limits) {
            limits = boxed();
            wish.frame = PositionType::Pulse;
            wish.how = Wish::How::Joint;
        },
        "box");
    row(
        "a station in mm", [](auto &wish, auto &, auto &) { wish.group = ControlGroup::stationPulse(1); }, "pulses");
}

void TestPlan::withheld()
{
    QFETCH(Change, change);
    Wish asked = wish(Wish::How::Straight, PositionType::Base, {1'010'000, 0, 500'000, 0, 0, 0});
    Present here = present();
    Limits limits;
    QVERIFY(motion::plan(asked, here, limits)); // before the change
    change(asked, here, limits);
    const auto plan = motion::plan(asked, here, limits);
    QVERIFY(!plan);
    QVERIFY(plan.error().kind == values::ErrorKind::BadInput);
    QFETCH(QString, says);
    QVERIFY2(plan.error().detail.contains(says), qPrintable(plan.error().detail));
}

void TestPlan::isLong_data()
{
    QTest::addColumn<AxisWords>("way");
    QTest::addColumn<bool>("isLong");
    QTest::newRow("100 mm") << AxisWords {100'000, 0, 0, 0, 0, 0} << false;
    QTest::newRow("100.001 mm") << AxisWords {100'001, 0, 0, 0, 0, 0} << true;
    QTest::newRow("29.99 degrees") << AxisWords {0, 0, 0, 0, 299'900, 0} << false;
    QTest::newRow("30.01 degrees") << AxisWords {0, 0, 0, 0, 300'100, 0} << true;
    QTest::newRow("two axes") << AxisWords {80'000, 80'000, 0, 0, 0, 0} << true;
}

void TestPlan::isLong()
{
    QFETCH(AxisWords, way);
    const auto plan = motion::plan(wish(Wish::How::Increment, PositionType::Base, way), present(), Limits {});
    QVERIFY(plan);
    QTEST(plan->isLong(), "isLong");
}

void TestPlan::steps_data()
{
    QTest::addColumn<JogFrame>("frame");
    QTest::addColumn<int>("axis");
    QTest::addColumn<double>("length");
    QTest::addColumn<double>("angle");
    QTest::addColumn<int>("pulses");
    QTest::addColumn<bool>("isSent");
    const auto row = [](const char *name, JogFrame frame, int axis, double length, double angle, int pulses,
                         bool isSent) { QTest::newRow(name) << frame << axis << length << angle << pulses << isSent; };
    row("10 mm", JogFrame::Base, 0, 10, 1, 1, true);
    row("more than 10 mm", JogFrame::Base, 0, 10.1, 1, 1, false);
    row("0 mm", JogFrame::Base, 1, 0, 1, 1, false);
    row("no number of mm", JogFrame::Robot, 2, notANumber, 1, 1, false);
    row("5 degrees", JogFrame::Base, 3, 1, 5, 1, true);
    row("more than 5 degrees", JogFrame::Robot, 5, 1, 5.1, 1, false);
    row("1000 pulses", JogFrame::Axes, 5, 1, 1, 1000, true);
    row("1001 pulses", JogFrame::Axes, 5, 1, 1, 1001, false);
    row("negative pulses", JogFrame::Axes, 0, 1, 1, -1, false);
    row("no seventh axis", JogFrame::Base, 6, 1, 1, 1, false);
    row("no seventh axis in pulses", JogFrame::Axes, 6, 1, 1, 1, false);
    row("no axis", JogFrame::Axes, -1, 1, 1, 1, false);
}

void TestPlan::steps()
{
    QFETCH(JogFrame, frame);
    QFETCH(int, axis);
    QFETCH(double, length);
    QFETCH(double, angle);
    QFETCH(int, pulses);
    JogChoice choice;
    choice.frame = frame;
    choice.length = length;
    choice.angle = angle;
    choice.pulses = pulses;
    const auto plan = motion::planStep(choice, {axis, false}, present(), Limits {});
    QTEST(plan.has_value(), "isSent");
    if (!plan)
        return;
    if (const auto *order = std::get_if<PulseOrder>(&plan->order)) {
        QCOMPARE(order->target.axes[std::size_t(axis)], present().pulse->axes[axis] - pulses);
        return;
    }
    const auto &target = cartesian(*plan);
    QVERIFY(std::get<CartesianOrder>(plan->order).how == CartesianMove::StraightIncremental);
    if (axis < 3)
        QCOMPARE(target.xyz[std::size_t(axis)], qint32(-length * 1000));
    else
        QCOMPARE(target.rotation[std::size_t(axis - 3)], qint32(-angle * 10000));
}

QTEST_APPLESS_MAIN(TestPlan)
#include "tst_plan.moc"
