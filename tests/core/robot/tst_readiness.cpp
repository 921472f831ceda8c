// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/readiness.h"

#include <QTest>

using namespace robot;
using values::Status;

namespace {

Status idle()
{
    return {Status::Data1 {Status::Play} | Status::Remote | Status::OneCycle, Status::Data2 {Status::ServoOn}};
}

/// A YRC1000 in REMOTE and PLAY with servo on, of which everything was read and answered.
ReadinessFacts good()
{
    ReadinessFacts facts;
    facts.link = LinkState::Monitoring;
    facts.situation.isLinkUp = true;
    facts.situation.status = idle();
    facts.situation.job = values::ExecutingJob {};
    facts.situation.job->name = values::FixedText<32>("WELD");
    facts.situation.isNumberingVerified = true;
    facts.system = values::SystemInformation {};
    facts.system->software = values::FixedText<24>("YAS2.02.11A(JP/EN)-97");
    facts.signal.outcome = facts.variable.outcome = facts.files.outcome = Probe::Outcome::Answered;
    return facts;
}

values::Error refusal(quint16 code) { return {values::ErrorKind::Refused, 0x1F, code, {}}; }

using Change = void (*)(ReadinessFacts &);

ReadinessRow rowOf(Subject subject, const ReadinessFacts &facts) { return readiness(facts)[int(subject)]; }

} // namespace

Q_DECLARE_METATYPE(Subject)
Q_DECLARE_METATYPE(Allowance)
Q_DECLARE_METATYPE(Evidence)
Q_DECLARE_METATYPE(Change)

/// Reference §10.1 and §10.2: what may be told of a controller, and what not.
class TestReadiness : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void rows_data();
    void rows();
    void everySubjectInOrder();
    void nothingIsMeasuredThatWasNotRead_data();
    void nothingIsMeasuredThatWasNotRead();
    void obstaclesInTheOrderOfRefusal();
    void levelAndArmingAreNotTheControllers();
};

void TestReadiness::rows_data()
{
    QTest::addColumn<Change>("change");
    QTest::addColumn<Subject>("subject");
    QTest::addColumn<Allowance>("allowance");
    QTest::addColumn<Evidence>("evidence");
    using enum Allowance;
    using enum Evidence;
    const auto row = [](const char *name, Change change, Subject subject, Allowance allowance, Evidence evidence) {
        QTest::newRow(name) << change << subject << allowance << evidence;
    };
    const Change nothing = [](ReadinessFacts &) {};
    const Change remoteOff = [](ReadinessFacts &f) { f.situation.status->data1 &= ~Status::Data1 {Status::Remote}; };
    const Change servoOff = [](ReadinessFacts &f) { f.situation.status->data2 = {}; };
    const Change running = [](ReadinessFacts &f) { f.situation.status->data1 |= Status::Running; };
    const Change unread = [](ReadinessFacts &f) { f.situation.status.reset(); };

    row("reading, live", nothing, Subject::Reading, Allowed, Measured);
    row(
        "reading, lost", [](ReadinessFacts &f) { f.link = LinkState::Lost; }, Subject::Reading, NotAllowed, Measured);
    row(
        "reading, checking", [](ReadinessFacts &f) { f.link = LinkState::Checking; }, Subject::Reading, NotKnown,
        Unread);
    row("reading without REMOTE", remoteOff, Subject::Reading, Allowed, Measured); // reads need none

    row("data answered", nothing, Subject::Data, Allowed, Measured);
    row("data without REMOTE", remoteOff, Subject::Data, Allowed, Measured);
    row(
        "signals not asked yet", [](ReadinessFacts &f) { f.signal = {}; }, Subject::Data, NotKnown, Unread);
    row(
        "variables not asked yet", [](ReadinessFacts &f) { f.variable = {}; }, Subject::Data, NotKnown, Unread);
    row(
        "variables refused",
        [](ReadinessFacts &f) {
            f.variable = {Probe::Outcome::Failed, refusal(0x2110)};
        },
        Subject::Data, NotAllowed, Measured);

    row("the software of the profile's model", nothing, Subject::Ranges, Allowed, Assumed);
    row(
        "the software of another model", [](ReadinessFacts &f) { f.profile.model = protocol::Model::FS100; },
        Subject::Ranges, NotAllowed, Measured);
    row(
        "a software that tells no model",
        [](ReadinessFacts &f) { f.system->software = values::FixedText<24>("DS3.53.01A"); }, Subject::Ranges, NotKnown,
        Assumed);
    row(
        "no software read", [](ReadinessFacts &f) { f.system.reset(); }, Subject::Ranges, NotKnown, Unread);

    row("REMOTE on", nothing, Subject::Remote, Allowed, Measured);
    row("REMOTE off", remoteOff, Subject::Remote, NotAllowed, Measured);
    row("REMOTE not read", unread, Subject::Remote, NotKnown, Unread);

    // "Job select when remote and play" is a setting that no command tells.
    row("select in REMOTE", nothing, Subject::JobSelect, NotKnown, Unreadable);
    row("select without REMOTE", remoteOff, Subject::JobSelect, NotAllowed, Measured);
    row("select while running", running, Subject::JobSelect, NotAllowed, Measured);

    // Home position and panel locks may still be in the way (0x3040, 0x3230).
    row("start", nothing, Subject::JobStart, Allowed, Assumed);
    row("start, servo off", servoOff, Subject::JobStart, NotAllowed, Measured);
    row("start while running", running, Subject::JobStart, NotAllowed, Measured);
    row(
        "start, no job set", [](ReadinessFacts &f) { f.situation.job->name = {}; }, Subject::JobStart, NotAllowed,
        Measured);
    row(
        "start, job not read", [](ReadinessFacts &f) { f.situation.job.reset(); }, Subject::JobStart, NotKnown, Unread);
    row(
        "start, job not read and servo off",
        [](ReadinessFacts &f) {
            f.situation.job.reset();
            f.situation.status->data2 = {};
        },
        Subject::JobStart, NotAllowed, Measured);

    row("servo on", servoOff, Subject::Servo, Allowed, Assumed); // the safety chain is not told
    row(
        "servo on in TEACH",
        [](ReadinessFacts &f) { f.situation.status->data1 = Status::Data1 {Status::Teach} | Status::Remote; },
        Subject::Servo, NotAllowed, Measured);
    row(
        "servo on with an alarm", [](ReadinessFacts &f) { f.situation.status->data2 = {Status::Alarm}; },
        Subject::Servo, NotAllowed, Measured);

    row("moves", nothing, Subject::Moves, Allowed, Assumed);
    row("moves, servo off", servoOff, Subject::Moves, NotAllowed, Measured);
    row(
        "moves of a model that has none", [](ReadinessFacts &f) { f.situation.canModelMove = false; }, Subject::Moves,
        NotAllowed, Assumed); // the profile says so

    row("HOLD never tried", nothing, Subject::Hold, Allowed, Assumed);
    row("HOLD without REMOTE", remoteOff, Subject::Hold, Allowed, Assumed);
    row(
        "HOLD sent", [](ReadinessFacts &f) { f.hold = HoldOrder {HoldOrder::Progress::UnderWay}; }, Subject::Hold,
        Allowed, Assumed);
    row(
        "HOLD confirmed", [](ReadinessFacts &f) { f.hold = HoldOrder {HoldOrder::Progress::Confirmed}; }, Subject::Hold,
        Allowed, Measured);
    row(
        "HOLD refused", [](ReadinessFacts &f) { f.hold = HoldOrder {HoldOrder::Progress::Refused}; }, Subject::Hold,
        NotAllowed, Measured);
    row(
        "HOLD unconfirmed", [](ReadinessFacts &f) { f.hold = HoldOrder {HoldOrder::Progress::Unconfirmed}; },
        Subject::Hold, NotKnown, Measured);

    row("files listed", nothing, Subject::Files, Allowed, Assumed); // none was transferred
    row("files without REMOTE", remoteOff, Subject::Files, NotAllowed, Measured); // 0xE2B2
    row(
        "file port not asked yet", [](ReadinessFacts &f) { f.files = {}; }, Subject::Files, NotKnown, Unread);
    row(
        "file port silent",
        [](ReadinessFacts &f) {
            f.files = {Probe::Outcome::Failed, values::Error {values::ErrorKind::NoAnswer, 0, 0, {}}};
        },
        Subject::Files, NotAllowed, Measured);

    row("RS029 and RS214 are not told", nothing, Subject::Overwrite, NotKnown, Unreadable);
    row("replacing without REMOTE", remoteOff, Subject::Overwrite, NotAllowed, Measured);

    row("numbering verified", nothing, Subject::Numbering, Allowed, Measured);
    row(
        "numbering unverified", [](ReadinessFacts &f) { f.situation.isNumberingVerified = false; }, Subject::Numbering,
        NotKnown, Unreadable);
    row(
        "numbering, software not read", [](ReadinessFacts &f) { f.system.reset(); }, Subject::Numbering, NotKnown,
        Unread);
    row(
        "numbering of a simulation", [](ReadinessFacts &f) { f.profile.isSimulation = true; }, Subject::Numbering,
        Allowed, Assumed);
}

void TestReadiness::rows()
{
    QFETCH(Change, change);
    QFETCH(Subject, subject);
    QFETCH(Allowance, allowance);
    QFETCH(Evidence, evidence);
    ReadinessFacts facts = good();
    change(facts);
    const ReadinessRow row = rowOf(subject, facts);
    QVERIFY2(row.allowance == allowance, qPrintable(QString::number(int(row.allowance))));
    QVERIFY2(row.evidence == evidence, qPrintable(QString::number(int(row.evidence))));
}

void TestReadiness::everySubjectInOrder()
{
    const auto rows = readiness(good());
    QCOMPARE(rows.size(), subjectCount);
    for (int i = 0; i < subjectCount; ++i)
        QVERIFY(rows[i].subject == Subject(i));
}

void TestReadiness::nothingIsMeasuredThatWasNotRead_data()
{
    QTest::addColumn<int>("link");
    QTest::newRow("disconnected") << int(LinkState::Disconnected);
    QTest::newRow("checking") << int(LinkState::Checking);
    QTest::newRow("monitoring, nothing read") << int(LinkState::Monitoring);
}

void TestReadiness::nothingIsMeasuredThatWasNotRead()
{
    QFETCH(int, link);
    ReadinessFacts facts;
    facts.link = LinkState(link);
    for (const ReadinessRow &row : readiness(facts)) {
        const bool isByTheLink = row.subject == Subject::Reading && facts.link == LinkState::Monitoring;
        QVERIFY2(row.evidence != Evidence::Measured || isByTheLink, key(row.subject));
        QVERIFY2(row.allowance == Allowance::NotKnown || isByTheLink || row.subject == Subject::Hold, key(row.subject));
    }
}

void TestReadiness::obstaclesInTheOrderOfRefusal()
{
    ReadinessFacts facts = good();
    facts.situation.status = Status {{Status::Teach}, Status::Data2 {Status::Alarm} | Status::HeldByPendant};
    const auto obstacles = rowOf(Subject::JobStart, facts).obstacles;
    using enum Condition;
    QVERIFY(obstacles == (QList {Remote, Play, NotTeach, NoAlarm, NotHeldByPendant, ServoOn}));
}

void TestReadiness::levelAndArmingAreNotTheControllers()
{
    ReadinessFacts facts = good();
    const auto asMonitor = readiness(facts);
    facts.situation.level = Level::Engineer;
    facts.situation.isArmed = true;
    QVERIFY(readiness(facts) == asMonitor);
}

QTEST_GUILESS_MAIN(TestReadiness)

#include "tst_readiness.moc"
