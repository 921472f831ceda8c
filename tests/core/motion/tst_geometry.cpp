// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "motion/geometry.h"
#include "motion/limits.h"
#include <QTest>
#include <cmath>
#include <limits>
#include <random>

using namespace motion;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

bool isNear(const Vector &a, const Vector &b, double tolerance = 1e-9)
{
    for (std::size_t i = 0; i < 3; ++i) {
        if (!(std::abs(a[i] - b[i]) <= tolerance))
            return false;
    }
    return true;
}

} // namespace

Q_DECLARE_METATYPE(motion::Vector)
Q_DECLARE_METATYPE(motion::Pose)
Q_DECLARE_METATYPE(motion::Wishes)

/// Places, orientations and limits.
class GeometryTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void turns_data();
    void turns();
    void anglesComeBack();
    void distances_data();
    void distances();
    void toolMoves_data();
    void toolMoves();
    void toolWaysComeBack();
    void poses_data();
    void poses();
    void boxes_data();
    void boxes();
    void limits_data();
    void limits();
};

void GeometryTest::turns_data()
{
    QTest::addColumn<Vector>("angles");
    QTest::addColumn<Vector>("from");
    QTest::addColumn<Vector>("to");
    const auto row = [](const char *name, Vector angles, Vector from, Vector to) {
        QTest::newRow(name) << angles << from << to;
    };
    row("none", {0, 0, 0}, {1, 2, 3}, {1, 2, 3});
    row("X: Y to Z", {90, 0, 0}, {0, 1, 0}, {0, 0, 1});
    row("Y: Z to X", {0, 90, 0}, {0, 0, 1}, {1, 0, 0});
    row("Z: X to Y", {0, 0, 90}, {1, 0, 0}, {0, 1, 0});
    // About the fixed axes, X first: Y goes to Z by Rx, and Rz leaves it there. About moving axes it would go to -X.
    row("X, then the fixed Z", {90, 0, 90}, {0, 1, 0}, {0, 0, 1});
    row("X, then the fixed Y", {90, 90, 0}, {0, 1, 0}, {1, 0, 0});
    row("tool down", {180, 0, 0}, {0, 0, 1}, {0, 0, -1});
}

void GeometryTest::turns()
{
    QFETCH(Vector, angles);
    QFETCH(Vector, from);
    QFETCH(Vector, to);
    QVERIFY(isNear(Rotation::fromFixedAngles(angles) * from, to));
}

void GeometryTest::anglesComeBack()
{
    std::mt19937 random {11};
    std::uniform_real_distribution<double> turn {-179.9, 179.9};
    std::uniform_real_distribution<double> half {-89.9, 89.9};
    for (int i = 0; i < 10000; ++i) {
        const Vector angles {turn(random), half(random), turn(random)};
        QVERIFY(isNear(Rotation::fromFixedAngles(angles).toFixedAngles(), angles, 1e-6));
    }
    // Upright: another triple, the same orientation.
    for (const double ry : {90.0, -90.0}) {
        const Rotation given = Rotation::fromFixedAngles({30, ry, 50});
        const Vector angles = given.toFixedAngles();
        QCOMPARE(angles[2], 0.0);
        QVERIFY((given.inverted() * Rotation::fromFixedAngles(angles)).angle() < 1e-6);
    }
    QVERIFY(isNear(Rotation::fromFixedAngles({-180, 0, -180}).toFixedAngles(), {180, 0, 180}));
}

void GeometryTest::distances_data()
{
    QTest::addColumn<Pose>("from");
    QTest::addColumn<Pose>("to");
    QTest::addColumn<double>("length");
    QTest::addColumn<double>("angle");
    const auto row = [](const char *name, Pose from, Pose to, double length, double angle) {
        QTest::newRow(name) << from << to << length << angle;
    };
    row("nowhere", {{1, 2, 3}, {10, 20, 30}}, {{1, 2, 3}, {10, 20, 30}}, 0, 0);
    row("3 4 12", {}, {{3, 4, 12}, {}}, 13, 0);
    row("a quarter about Z", {}, {{}, {0, 0, 90}}, 0, 90);
    row("over 180, the short way", {{}, {0, 0, 170}}, {{}, {0, 0, -170}}, 0, 20);
    row("half a turn", {}, {{}, {180, 0, 0}}, 0, 180);
    row("two triples of one orientation", {{}, {180, 0, 180}}, {{}, {0, 180, 0}}, 0, 0);
    row("a small one", {{}, {0, 0, 0}}, {{}, {0, 0.0001, 0}}, 0, 0.0001);
}

void GeometryTest::distances()
{
    QFETCH(Pose, from);
    QFETCH(Pose, to);
    QFETCH(double, length);
    QFETCH(double, angle);
    QVERIFY(std::abs(distance(from, to) - length) < 1e-9);
    QVERIFY(std::abs(rotationDistance(from, to) - angle) < 1e-6);
    QVERIFY(std::abs(rotationDistance(to, from) - angle) < 1e-6);
}

void GeometryTest::toolMoves_data()
{
    QTest::addColumn<Pose>("from");
    QTest::addColumn<Pose>("delta");
    QTest::addColumn<Pose>("to");
    const auto row = [](const char *name, Pose from, Pose delta, Pose to) {
        QTest::newRow(name) << from << delta << to;
    };
    row("upright", {{100, 0, 0}, {}}, {{1, 2, 3}, {}}, {{101, 2, 3}, {}});
    row("tool down: its Z is down", {{0, 0, 500}, {180, 0, 0}}, {{0, 0, 10}, {}}, {{0, 0, 490}, {180, 0, 0}});
    row("turned about Z: its X is Y", {{}, {0, 0, 90}}, {{10, 0, 0}, {}}, {{0, 10, 0}, {0, 0, 90}});
    row("turning on", {{}, {0, 0, 90}}, {{}, {0, 0, 45}}, {{}, {0, 0, 135}});
}

void GeometryTest::toolMoves()
{
    QFETCH(Pose, from);
    QFETCH(Pose, delta);
    QFETCH(Pose, to);
    const Pose moved = movedInTool(from, delta);
    QVERIFY(isNear(moved.mm, to.mm) && isNear(moved.degrees, to.degrees));
}

void GeometryTest::toolWaysComeBack()
{
    std::mt19937 random {12};
    std::uniform_real_distribution<double> place {-2000, 2000};
    std::uniform_real_distribution<double> turn {-89, 89};
    const auto pose = [&] {
        return Pose {{place(random), place(random), place(random)}, {turn(random), turn(random), turn(random)}};
    };
    for (int i = 0; i < 1000; ++i) {
        const Pose from = pose();
        const Pose to = pose();
        const Pose delta = deltaInTool(from, to);
        const Pose back = movedInTool(from, delta);
        QVERIFY(isNear(back.mm, to.mm, 1e-6) && rotationDistance(back, to) < 1e-6);
        QVERIFY(std::abs(distance({}, delta) - distance(from, to)) < 1e-6);
    }
}

void GeometryTest::poses_data()
{
    QTest::addColumn<int>("type");
    QTest::addColumn<int>("axes");
    QTest::addColumn<bool>("isPose");
    QTest::newRow("base frame") << int(values::PositionType::Base) << 6 << true;
    QTest::newRow("seven axes") << int(values::PositionType::Base) << 7 << true;
    QTest::newRow("pulses") << int(values::PositionType::Pulse) << 6 << false;
    QTest::newRow("four axes") << int(values::PositionType::Base) << 4 << false;
    QTest::newRow("nothing") << int(values::PositionType::Base) << 0 << false;
}

void GeometryTest::poses()
{
    QFETCH(int, type);
    QFETCH(int, axes);
    QFETCH(bool, isPose);
    values::Position position {
        values::PositionType(type), 0, 0, 0, 0, {1024318, -311902, 688004, 1799984, -120, 124410}};
    position.axes.resize(axes);
    const auto pose = poseOf(position);
    QCOMPARE(pose.has_value(), isPose);
    if (pose)
        QVERIFY((*pose == Pose {{1024.318, -311.902, 688.004}, {179.9984, -0.012, 12.441}}));
}

void GeometryTest::boxes_data()
{
    QTest::addColumn<Vector>("place");
    QTest::addColumn<bool>("isInside");
    QTest::newRow("middle") << Vector {0, 0, 0} << true;
    QTest::newRow("corner") << Vector {100, 200, 300} << true;
    QTest::newRow("a little out in X") << Vector {100.001, 0, 0} << false;
    QTest::newRow("out in Z") << Vector {0, 0, -300.1} << false;
    QTest::newRow("no number") << Vector {0, none, 0} << false;
    QTest::newRow("infinite") << Vector {0, 0, infinite} << false;
}

void GeometryTest::boxes()
{
    QFETCH(Vector, place);
    const Box box {{-100, -200, -300}, {100, 200, 300}};
    QTEST(box.contains(place), "isInside");
}

void GeometryTest::limits_data()
{
    QTest::addColumn<Wishes>("wishes");
    QTest::addColumn<double>("toolSpeed"); // no number: nothing may be moved
    QTest::addColumn<double>("stepAngle");
    const auto row = [](const char *name, const Wishes &wishes, double toolSpeed, double stepAngle) {
        QTest::newRow(name) << wishes << toolSpeed << stepAngle;
    };
    row("nothing wished", {}, 250, 5);
    row("lower", {.toolSpeed = 50, .stepAngle = 0.1}, 50, 0.1);
    row("at the ceiling", {.toolSpeed = 250}, 250, 5);
    row("above it", {.toolSpeed = 250.001, .stepAngle = 90}, 250, 5);
    row("infinite", {.toolSpeed = infinite}, 250, 5);
    row("zero", {.toolSpeed = 0}, none, none);
    row("negative", {.stepAngle = -1}, none, none);
    row("no number", {.toolSpeed = none}, none, none);
    row("box", {.box = Box {{0, 0, 0}, {1, 1, 1}}}, 250, 5);
    row("box without inside", {.box = Box {{0, 0, 0}, {1, 0, 1}}}, none, none);
    row("box turned round", {.box = Box {{1, 1, 1}, {0, 0, 0}}}, none, none);
    row("box of no numbers", {.box = Box {{none, 0, 0}, {1, 1, 1}}}, none, none);
}

void GeometryTest::limits()
{
    QFETCH(Wishes, wishes);
    QFETCH(double, toolSpeed);
    QFETCH(double, stepAngle);
    const auto found = motion::limits(wishes);
    QCOMPARE(found.has_value(), !std::isnan(toolSpeed));
    if (!found) {
        QVERIFY(found.error().kind == values::ErrorKind::BadInput);
        return;
    }
    QCOMPARE(found->toolSpeed, toolSpeed);
    QCOMPARE(found->stepAngle, stepAngle);
    QVERIFY(found->box == wishes.box);
}

QTEST_GUILESS_MAIN(GeometryTest)

#include "tst_geometry.moc"
