// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/jog.h"

#include "protocol/codes.h"
#include "support/cell.h"
#include "virtualcontroller/alarms.h"
#include "virtualcontroller/machine.h"

using namespace std::chrono_literals;
using motion::JogChoice;
using motion::JogFrame;
using motion::Speeds;
using motion::StepEngine;
using robot::Jog;
using values::AxisWords;
using values::ControlGroup;
using values::Status;
using virtualcontroller::Direction;
using virtualcontroller::FaultKind;
using virtualcontroller::FaultRule;
using virtualcontroller::Faults;

namespace {

constexpr quint16 moveCartesian = 0x8A;
constexpr quint16 movePulse = 0x8B;

/// A person with a finger on a button, and an arm.
struct Desk {
    explicit Desk(const motion::Wishes &wishes = {}) : limits {motion::limits(wishes)} { }

    [[nodiscard]] bool open()
    {
        if (!cell.armed())
            return false;
        jog = std::make_unique<Jog>(*cell.orders, limits);
        jog->setWindowActive(true);
        return true;
    }
    [[nodiscard]] virtualcontroller::Memory &memory() const { return cell.server->memory(); }
    [[nodiscard]] virtualcontroller::Group &arm() const { return *memory().findGroup(ControlGroup::robotPulse(1)); }
    [[nodiscard]] AxisWords place() const { return arm().poseAt(memory().now); }
    [[nodiscard]] AxisWords pulses() const { return arm().pulsesAt(memory().now); }
    [[nodiscard]] int arrived() const { return cell.server->arrived(moveCartesian) + cell.server->arrived(movePulse); }
    /// For a test that fails.
    [[nodiscard]] QString report() const
    {
        const auto &reply = jog->lastReply();
        return QStringLiteral("%1 steps, %2; %3")
            .arg(jog->stepsSent())
            .arg(jog->pressed() ? QStringLiteral("pressed") : QStringLiteral("let go"),
                reply && !*reply ? protocol::explain(reply->error()) : jog->complaint());
    }
    [[nodiscard]] bool isAtRest() const
    {
        return !jog->pressed() && jog->progress() == StepEngine::Progress::Idle && !memory().status.isRunning();
    }
    void choose(JogFrame frame, double length, Speeds speeds)
    {
        JogChoice choice;
        choice.frame = frame;
        choice.length = length;
        choice.speeds = speeds;
        jog->setChoice(choice);
    }

    Cell cell;
    values::Result<motion::Limits> limits;
    std::unique_ptr<Jog> jog;
};

/// The longest way along one axis, in the words of the wire.
qint64 way(const AxisWords &from, const AxisWords &to)
{
    qint64 longest = 0;
    for (int axis = 0; axis < from.count(); ++axis)
        longest = std::max(longest, std::abs(qint64(to[axis]) - from[axis]));
    return longest;
}

AxisWords plus(AxisWords words, int axis, qint32 more)
{
    words[axis] += more;
    return words;
}

} // namespace

Q_DECLARE_METATYPE(std::function<void(Desk &)>)
using Event = std::function<void(Desk &)>;

/// Jogging a virtual controller over sockets.
class TestJog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void fiftyStepsOfEachAxis();
    void releaseHoldsTheStep();
    void lostLinkEndsAfterOneStep_data();
    void lostLinkEndsAfterOneStep();
    void whatDropsTheButton_data();
    void whatDropsTheButton();
    void closedWays_data();
    void closedWays();
    void boxIsKept();
    void twoButtonsStop();
    void journal();
};

/// Twelve desks at once: six axes in the base frame and six in pulses, forward and backward in turn.
void TestJog::fiftyStepsOfEachAxis()
{
    constexpr int steps = 50;
    struct One {
        Desk desk;
        AxisWords begin;
        std::optional<AxisWords> end;
    };
    std::vector<std::unique_ptr<One>> all;
    for (const JogFrame frame : {JogFrame::Base, JogFrame::Axes}) {
        for (int axis = 0; axis < 6; ++axis) {
            all.push_back(std::make_unique<One>());
            One *one = all.back().get();
            QVERIFY(one->desk.open());
            one->desk.choose(frame, 1, {10, 10, 5});
            const auto look = [one, frame] { return frame == JogFrame::Axes ? one->desk.pulses() : one->desk.place(); };
            one->begin = look();
            // The next step is ordered when the ones before have ended; it has not arrived yet.
            connect(one->desk.jog.get(), &Jog::changed, one->desk.jog.get(), [one, look] {
                if (one->desk.jog->stepsSent() <= steps || one->end)
                    return;
                one->end = look();
                one->desk.jog->release();
            });
            one->desk.jog->press({axis, axis % 2 == 0});
        }
    }
    for (const auto &one : all)
        QTRY_VERIFY2_WITH_TIMEOUT(one->end, qPrintable(one->desk.report()), 30000);
    for (int index = 0; index < 12; ++index) {
        const int axis = index % 6;
        const qint32 step = index >= 6 ? 100 : axis < 3 ? 1000 : 10000; // pulses, 0.001 mm, 0.0001 degree
        const qint32 sum = axis % 2 == 0 ? steps * step : -steps * step;
        QCOMPARE(QList<qint32>(all[index]->end->begin(), all[index]->end->end()), ([&] {
            const AxisWords expected = plus(all[index]->begin, axis, sum);
            return QList<qint32>(expected.begin(), expected.end());
        })());
    }
}

void TestJog::releaseHoldsTheStep()
{
    Desk desk;
    QVERIFY(desk.open());
    desk.choose(JogFrame::Base, 10, {10, 3, 1}); // a second for a step
    const AxisWords begin = desk.place();
    desk.jog->press({0, true});
    QTRY_VERIFY(way(begin, desk.place()) > 1000);
    desk.jog->release();
    QTRY_VERIFY(desk.memory().status.data2 & Status::HeldByCommand);
    QTRY_VERIFY(desk.isAtRest());
    QCOMPARE(desk.arrived(), 1);
    QVERIFY(way(begin, desk.place()) < 10'000);
    // HOLD is left on: the next press moves nothing.
    const AxisWords held = desk.place();
    desk.jog->press({0, true});
    QTRY_VERIFY(!desk.jog->pressed());
    QCOMPARE(desk.arrived(), 1);
    QCOMPARE(way(held, desk.place()), 0);
}

void TestJog::lostLinkEndsAfterOneStep_data()
{
    QTest::addColumn<bool>("requestsToo");
    QTest::newRow("the line is cut") << true;
    QTest::newRow("replies do not come back") << false;
}

void TestJog::lostLinkEndsAfterOneStep()
{
    QFETCH(bool, requestsToo);
    Desk desk;
    QVERIFY(desk.open());
    desk.choose(JogFrame::Base, 1, {10, 3, 1});
    const AxisWords begin = desk.place();
    desk.jog->press({2, false});
    QTRY_VERIFY(desk.jog->stepsSent() >= 3);
    const int sent = desk.jog->stepsSent();
    const auto lost = [](Direction direction) {
        return FaultRule {.command = {}, .direction = direction, .kind = FaultKind::Lose};
    };
    desk.cell.server->setFaults(
        requestsToo ? Faults {{lost(Direction::Request), lost(Direction::Reply)}} : Faults {{lost(Direction::Reply)}});
    QTRY_VERIFY(!desk.jog->pressed());
    QTRY_VERIFY(!desk.memory().status.isRunning());
    QVERIFY(desk.jog->stepsSent() <= sent + 1);
    QVERIFY(way(begin, desk.place()) <= (sent + 1) * 1000);
    QVERIFY(desk.arrived() <= sent + 1);
    // Back again: nothing goes on by itself.
    const int before = desk.arrived();
    desk.cell.server->setFaults(Faults {});
    QTRY_VERIFY(desk.cell.orders->situation().isLinkUp && desk.cell.orders->situation().status);
    QCOMPARE(desk.arrived(), before);
    QVERIFY(!desk.cell.orders->isArmed());
    desk.jog->press({2, false});
    QVERIFY(!desk.jog->pressed()); // not armed
}

void TestJog::whatDropsTheButton_data()
{
    using robot::Arming;
    QTest::addColumn<Event>("event");
    const auto row = [](const char *name, Event event) { QTest::newRow(name) << std::move(event); };
    row("released", [](Desk &desk) { desk.jog->release(); });
    row("window not in front", [](Desk &desk) { desk.jog->setWindowActive(false); });
    row("disarmed", [](Desk &desk) { desk.cell.arming.drop(Arming::Drop::ByHand); });
    row("screen locked", [](Desk &desk) { desk.cell.arming.drop(Arming::Drop::ScreenLocked); });
    row("access dropped", [](Desk &desk) { desk.cell.access.enter(robot::Level::Monitor); });
    row("alarm", [](Desk &desk) { virtualcontroller::raiseAlarm(desk.memory(), 4315, "COLLISION DETECT"); });
    row("HOLD", [](Desk &desk) { desk.cell.orders->hold(); });
    row("TEACH", [](Desk &desk) { desk.memory().status.data1 = Status::Data1 {Status::Teach}; });
    row("servo off", [](Desk &desk) { desk.memory().status.data2.setFlag(Status::ServoOn, false); });
    row("another choice", [](Desk &desk) { desk.choose(JogFrame::Axes, 1, {}); });
    row("link closed", [](Desk &desk) { desk.cell.controller->close(); });
    row("step refused", [](Desk &desk) {
        desk.cell.server->setFaults(Faults {
            {{.command = moveCartesian, .direction = Direction::Request, .kind = FaultKind::Refuse, .code = 0x2010}}});
    });
    row("reply lost", [](Desk &desk) {
        desk.cell.server->setFaults(Faults {{{.command = moveCartesian, .kind = FaultKind::Lose}}});
    });
    row("program stood still", [](Desk &) { QTest::qSleep(2000); });
}

void TestJog::whatDropsTheButton()
{
    QFETCH(Event, event);
    Desk desk;
    QVERIFY(desk.open());
    desk.choose(JogFrame::Base, 1, {5, 3, 1});
    const AxisWords begin = desk.place();
    desk.jog->press({1, true});
    QTRY_VERIFY(desk.jog->stepsSent() >= 2);
    const int sent = desk.jog->stepsSent();
    event(desk);
    QTRY_VERIFY(!desk.jog->pressed());
    QTRY_VERIFY(!desk.arm().motion);
    QVERIFY(desk.jog->stepsSent() <= sent + 1);
    QVERIFY(desk.arrived() <= sent + 1);
    QVERIFY(way(begin, desk.place()) <= (sent + 1) * 1000);
}

void TestJog::closedWays_data()
{
    QTest::addColumn<Event>("event");
    const auto row = [](const char *name, Event event) { QTest::newRow(name) << std::move(event); };
    row("TEACH", [](Desk &desk) { desk.memory().status.data1 = Status::Data1 {Status::Teach}; });
    row("held", [](Desk &desk) { desk.memory().status.data2.setFlag(Status::HeldByCommand); });
    row("alarm", [](Desk &desk) { virtualcontroller::raiseAlarm(desk.memory(), 4315, "COLLISION DETECT"); });
    row("disarmed", [](Desk &desk) { desk.cell.arming.drop(robot::Arming::Drop::ByHand); });
    row("Monitor", [](Desk &desk) { desk.cell.access.enter(robot::Level::Monitor); });
    row("Operate", [](Desk &desk) { desk.cell.access.enter(robot::Level::Operate); });
    row("a job runs", [](Desk &desk) { desk.memory().status.data1.setFlag(Status::Running); });
}

/// Pressed at once, before the program has heard of it, and again when it has.
void TestJog::closedWays()
{
    QFETCH(Event, event);
    Desk desk;
    QVERIFY(desk.open());
    desk.choose(JogFrame::Base, 1, {10, 3, 1});
    const AxisWords begin = desk.place();
    event(desk);
    desk.jog->press({0, true});
    QTRY_VERIFY(desk.cell.orders->obstacle(robot::Act::Jog));
    desk.jog->release();
    desk.jog->press({0, true});
    desk.jog->release();
    QCOMPARE(desk.arrived(), 0);
    QCOMPARE(way(begin, desk.place()), 0);
}

void TestJog::boxIsKept()
{
    motion::Wishes wishes;
    Desk probe;
    QVERIFY(probe.open());
    const AxisWords begin = probe.place();
    motion::Box box {{-1e4, -1e4, -1e4}, {1e4, 1e4, 1e4}};
    box.most[0] = begin[0] / 1e3 + 2.5; // room for two steps
    wishes.box = box;
    Desk desk {wishes};
    QVERIFY(desk.open());
    desk.choose(JogFrame::Base, 1, {10, 3, 1});
    desk.jog->press({0, true});
    QTRY_VERIFY(!desk.jog->pressed());
    QVERIFY2(desk.jog->complaint().contains(u"box"), qPrintable(desk.jog->complaint()));
    QTRY_VERIFY(desk.isAtRest());
    QCOMPARE(desk.arrived(), 2);
    QCOMPARE(desk.place()[0] - begin[0], 2000);
    // Where an axis leads is not known.
    desk.choose(JogFrame::Axes, 1, {10, 3, 1});
    desk.jog->press({0, true});
    QTRY_VERIFY(!desk.jog->pressed());
    QCOMPARE(desk.arrived(), 2);
}

void TestJog::twoButtonsStop()
{
    Desk desk;
    QVERIFY(desk.open());
    desk.choose(JogFrame::Base, 10, {10, 3, 1});
    desk.jog->press({0, true});
    QTRY_COMPARE(desk.jog->stepsSent(), 1);
    desk.jog->press({1, true});
    QVERIFY(!desk.jog->pressed());
    QTRY_VERIFY(desk.memory().status.data2 & Status::HeldByCommand);
    QVERIFY(desk.arrived() <= 1);
}

void TestJog::journal()
{
    Desk desk;
    QVERIFY(desk.open());
    desk.choose(JogFrame::Base, 1, {10, 3, 1});
    desk.jog->press({2, false});
    QTRY_COMPARE(desk.jog->stepsSent(), 1);
    desk.jog->release();
    QTRY_VERIFY(std::ranges::any_of(desk.cell.records, [](const auto &record) { return record.action == u"jog"; }));
    const auto found = std::ranges::find_if(desk.cell.records, [](const auto &r) { return r.action == u"jog"; });
    QCOMPARE(found->subject, QStringLiteral("R1"));
    QVERIFY2(found->newValue.startsWith(u"base frame by X 0.000 Y 0.000 Z -1.000"), qPrintable(found->newValue));
    QVERIFY2(found->newValue.endsWith(u"10.0 mm/s"), qPrintable(found->newValue));
}

QTEST_GUILESS_MAIN(TestJog)
#include "tst_jog.moc"
