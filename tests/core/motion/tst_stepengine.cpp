// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "motion/stepengine.h"
#include <QTest>
#include <random>

using namespace std::chrono_literals;
using motion::StepEngine;
using motion::Time;
using Act = StepEngine::Act;
using Progress = StepEngine::Progress;
using Reply = StepEngine::Reply;

namespace {

constexpr StepEngine::Status resting {false, true};
constexpr StepEngine::Status running {true, true};
constexpr StepEngine::Status forbidding {false, false};

/// An engine that is armed, in front and has a fresh status, and a clock.
struct Desk {
    Desk()
    {
        (void)engine.setArmed(true, now);
        (void)engine.setWindowActive(true, now);
        (void)engine.takeStatus(resting, now);
    }
    void pass(std::chrono::milliseconds time) { now += time; }
    /// A whole step from its sending on, with the button held; returns what comes after it.
    Act finishStep()
    {
        (void)engine.takeReply(Reply::Accepted, now);
        pass(100ms);
        (void)engine.takeStatus(running, now);
        pass(100ms);
        return engine.takeStatus(resting, now);
    }

    StepEngine engine;
    Time now {1h};
};

/// A person, a network and a robot that do anything at any time; and what is known of them without the engine.
class World
{
public:
    explicit World(unsigned seed) : m_random {seed} { }

    /// One event; false if a rule was broken.
    bool happen();
    [[nodiscard]] const QString &complaint() const { return m_complaint; }
    [[nodiscard]] int steps() const { return m_steps; }

private:
    [[nodiscard]] int any(int count) { return int(m_random() % unsigned(count)); }
    void pass();
    void lose() { m_isDown = false; }
    Act event();
    Act press();
    Act status();
    Act reply();
    void startRobot();
    bool judge(Act act, bool wasUnderWay, bool wasLost);
    bool fail(const char *why)
    {
        m_complaint = QLatin1String(why);
        return false;
    }

    std::mt19937 m_random;
    StepEngine m_engine;
    Time m_now {1h};
    Time m_lastEvent {1h};
    bool m_isDown = false; ///< Pressed while armed and in front, and nothing lost since.
    bool m_isArmed = false;
    bool m_isActive = false;
    bool m_allows = true;
    bool m_isLost = false; ///< By the present event.
    std::optional<Time> m_statusAt;
    bool m_statusAllows = false;
    bool m_statusRuns = false;
    bool m_isReplyDue = false;
    std::optional<Time> m_begins; ///< The robot moves from here…
    Time m_ends {}; ///< …to here.
    bool m_isHeld = false;
    int m_steps = 0;
    QString m_complaint;
};

void World::pass()
{
    const int kind = any(60);
    m_now += kind == 0 ? std::chrono::milliseconds {2000} : std::chrono::milliseconds {any(kind < 6 ? 350 : 90)};
    m_isLost = m_now - m_lastEvent > StepEngine::pauseLimit;
    m_lastEvent = m_now;
}

bool World::happen()
{
    pass();
    const bool wasUnderWay = m_isReplyDue || (m_begins && m_now < m_ends);
    const Act act = event();
    return judge(act, wasUnderWay, m_isLost);
}

Act World::event()
{
    switch (any(12)) {
    case 0: return press();
    case 1: m_isLost = true; return m_engine.release(m_now);
    case 2:
        m_isArmed = any(4) > 0;
        m_isLost |= !m_isArmed;
        return m_engine.setArmed(m_isArmed, m_now);
    case 3:
        m_isActive = any(4) > 0;
        m_isLost |= !m_isActive;
        return m_engine.setWindowActive(m_isActive, m_now);
    case 4:
        if (any(5) > 0)
            return m_engine.tick(m_now);
        m_isLost = true;
        m_statusAt.reset();
        if (std::exchange(m_isReplyDue, false) && any(2) > 0)
            startRobot();
        return m_engine.loseLink(m_now);
    case 5:
    case 6:
    case 7: return reply();
    case 8: return m_engine.tick(m_now);
    default: return status();
    }
}

Act World::press()
{
    const bool wasDown = m_isDown;
    m_isLost = wasDown; // a second button, or the first one was never seen to come up
    const Act act = m_engine.press(any(6), m_now);
    if (!wasDown)
        m_isDown = m_isArmed && m_isActive;
    return act;
}

Act World::status()
{
    m_allows = any(20) > 0;
    const bool runs = m_begins && m_now >= *m_begins && m_now < m_ends;
    m_statusAt = m_now;
    m_statusAllows = m_allows;
    m_statusRuns = runs;
    m_isLost |= !m_allows;
    return m_engine.takeStatus({runs, m_allows}, m_now);
}

Act World::reply()
{
    if (!std::exchange(m_isReplyDue, false))
        return m_engine.takeReply(Reply::Accepted, m_now); // late: nobody waits for it
    const int kind = any(10);
    if (kind == 0) {
        m_isLost = true;
        return m_engine.takeReply(Reply::Refused, m_now);
    }
    startRobot();
    if (kind == 1) {
        m_isLost = true;
        return m_engine.takeReply(Reply::Unknown, m_now);
    }
    return m_engine.takeReply(Reply::Accepted, m_now);
}

void World::startRobot()
{
    m_begins = m_now + std::chrono::milliseconds {any(200)};
    m_ends = *m_begins + std::chrono::milliseconds {any(600)};
}

bool World::judge(Act act, bool wasUnderWay, bool wasLost)
{
    if (wasLost)
        lose();
    m_isHeld |= act == Act::Hold;
    if (wasLost && wasUnderWay && !m_isHeld && m_engine.progress() != Progress::Idle)
        return fail("a loss in motion without HOLD");
    if (act != Act::Step)
        return true;
    ++m_steps;
    if (wasLost || !m_isDown)
        return fail("a step without the button");
    if (!m_isArmed || !m_isActive)
        return fail("a step disarmed or behind another window");
    if (!m_statusAt || m_now - *m_statusAt >= StepEngine::statusLimit || !m_statusAllows || m_statusRuns)
        return fail("a step without a fresh status that allows it");
    if (m_isReplyDue || (m_begins && m_now < m_ends))
        return fail("a step before the last one was finished");
    m_isReplyDue = true;
    m_isHeld = false;
    return true;
}

} // namespace

/// When a jog step may be sent.
class StepEngineTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void oneStepAfterAnother();
    void shortStepIsSeenInTime();
    void needsEverything_data();
    void needsEverything();
    void losses_data();
    void losses();
    void losingTwiceHoldsOnce();
    void standingStill();
    void stepThatNeverEnds();
    void secondButton();
    void anythingInAnyOrder();
};

void StepEngineTest::oneStepAfterAnother()
{
    Desk desk;
    QVERIFY(desk.engine.press(3, desk.now) == Act::Step);
    QCOMPARE(desk.engine.button(), std::optional(3));
    for (int step = 0; step < 50; ++step) {
        QVERIFY(desk.engine.takeStatus(resting, desk.now) == Act::Nothing); // not answered yet
        QVERIFY(desk.finishStep() == Act::Step);
    }
}

/// A step that nobody saw running is over when it must have begun.
void StepEngineTest::shortStepIsSeenInTime()
{
    Desk desk;
    QVERIFY(desk.engine.press(0, desk.now) == Act::Step);
    QVERIFY(desk.engine.takeReply(Reply::Accepted, desk.now) == Act::Nothing);
    desk.pass(100ms);
    QVERIFY(desk.engine.takeStatus(resting, desk.now) == Act::Nothing);
    desk.pass(100ms);
    QVERIFY(desk.engine.takeStatus(resting, desk.now) == Act::Nothing);
    desk.pass(50ms);
    QVERIFY(desk.engine.takeStatus(resting, desk.now) == Act::Step);
}

void StepEngineTest::needsEverything_data()
{
    QTest::addColumn<bool>("isArmed");
    QTest::addColumn<bool>("isActive");
    QTest::addColumn<int>("statusAge"); // milliseconds
    QTest::addColumn<bool>("isRunning");
    QTest::addColumn<bool>("allows");
    QTest::addColumn<bool>("isSent");
    QTest::newRow("everything") << true << true << 0 << false << true << true;
    QTest::newRow("status just fresh") << true << true << 299 << false << true << true;
    QTest::newRow("status just old") << true << true << 300 << false << true << false;
    QTest::newRow("disarmed") << false << true << 0 << false << true << false;
    QTest::newRow("window behind") << true << false << 0 << false << true << false;
    QTest::newRow("running") << true << true << 0 << true << true << false;
    QTest::newRow("not allowed") << true << true << 0 << false << false << false;
}

void StepEngineTest::needsEverything()
{
    QFETCH(bool, isArmed);
    QFETCH(bool, isActive);
    QFETCH(int, statusAge);
    QFETCH(bool, isRunning);
    QFETCH(bool, allows);
    StepEngine engine;
    Time now {1h};
    (void)engine.setArmed(isArmed, now);
    (void)engine.setWindowActive(isActive, now);
    (void)engine.takeStatus({isRunning, allows}, now);
    now += std::chrono::milliseconds {statusAge};
    QTEST(engine.press(0, now) == Act::Step, "isSent");
}

void StepEngineTest::losses_data()
{
    QTest::addColumn<int>("loss");
    const char *const names[] {
        "released", "disarmed", "window behind", "link lost", "alarm or mode", "refused", "unknown"};
    for (int loss = 0; loss < 7; ++loss)
        QTest::newRow(names[loss]) << loss;
}

/// Whatever is lost while a step is on its way: it is held, and no other follows until the button is pressed anew.
void StepEngineTest::losses()
{
    QFETCH(int, loss);
    Desk desk;
    QVERIFY(desk.engine.press(0, desk.now) == Act::Step);
    desk.pass(10ms);
    Act act = Act::Nothing;
    switch (loss) {
    case 0: act = desk.engine.release(desk.now); break;
    case 1: act = desk.engine.setArmed(false, desk.now); break;
    case 2: act = desk.engine.setWindowActive(false, desk.now); break;
    case 3: act = desk.engine.loseLink(desk.now); break;
    case 4: act = desk.engine.takeStatus(forbidding, desk.now); break;
    case 5: act = desk.engine.takeReply(Reply::Refused, desk.now); break;
    default: act = desk.engine.takeReply(Reply::Unknown, desk.now); break;
    }
    QVERIFY(act == (loss == 5 ? Act::Nothing : Act::Hold)); // what was refused does not move
    (void)desk.engine.setArmed(true, desk.now);
    (void)desk.engine.setWindowActive(true, desk.now);
    QVERIFY(desk.finishStep() == Act::Nothing);
    for (int i = 0; i < 10; ++i) {
        desk.pass(100ms);
        QVERIFY(desk.engine.takeStatus(resting, desk.now) == Act::Nothing);
    }
    QVERIFY(desk.engine.press(0, desk.now) == Act::Step);
}

void StepEngineTest::losingTwiceHoldsOnce()
{
    Desk desk;
    (void)desk.engine.press(0, desk.now);
    QVERIFY(desk.engine.release(desk.now) == Act::Hold);
    QVERIFY(desk.engine.takeStatus(forbidding, desk.now) == Act::Nothing);
    QVERIFY(desk.engine.setArmed(false, desk.now) == Act::Nothing);
}

/// The program was stopped for two seconds with the button down; the release never came.
void StepEngineTest::standingStill()
{
    Desk desk;
    (void)desk.engine.press(0, desk.now);
    QVERIFY(desk.finishStep() == Act::Step);
    desk.pass(2s);
    QVERIFY(desk.engine.takeReply(Reply::Accepted, desk.now) == Act::Hold);
    QVERIFY(!desk.engine.button());
    Desk idle;
    (void)idle.engine.press(0, idle.now);
    (void)idle.engine.takeReply(Reply::Accepted, idle.now);
    idle.pass(100ms);
    (void)idle.engine.takeStatus(running, idle.now);
    idle.pass(2s);
    QVERIFY(idle.engine.takeStatus(resting, idle.now) == Act::Nothing); // over meanwhile, but no other
    QVERIFY(!idle.engine.button());
}

void StepEngineTest::stepThatNeverEnds()
{
    Desk desk;
    (void)desk.engine.press(0, desk.now);
    (void)desk.engine.takeReply(Reply::Accepted, desk.now);
    for (int i = 0; i < 150; ++i) {
        QVERIFY(desk.engine.takeStatus(running, desk.now) == Act::Nothing);
        desk.pass(100ms);
    }
    desk.pass(1ms);
    QVERIFY(desk.engine.takeStatus(running, desk.now) == Act::Hold);
    QVERIFY(desk.engine.progress() == Progress::Idle);
    QVERIFY(!desk.engine.button());
}

void StepEngineTest::secondButton()
{
    Desk desk;
    (void)desk.engine.press(0, desk.now);
    QVERIFY(desk.engine.press(1, desk.now) == Act::Hold);
    QVERIFY(!desk.engine.button());
}

void StepEngineTest::anythingInAnyOrder()
{
    constexpr int sequences = 100'000;
    constexpr int events = 60;
    int steps = 0;
    for (int sequence = 0; sequence < sequences; ++sequence) {
        World world {unsigned(sequence)};
        for (int i = 0; i < events; ++i) {
            if (!world.happen())
                QFAIL(qPrintable(
                    QStringLiteral("sequence %1, event %2: %3").arg(sequence).arg(i).arg(world.complaint())));
        }
        steps += world.steps();
    }
    QVERIFY(steps > sequences / 4); // it was not simply always still
}

QTEST_GUILESS_MAIN(StepEngineTest)

#include "tst_stepengine.moc"
