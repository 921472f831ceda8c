// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/edits.h"
#include "robot/iowrite.h"
#include "virtualcontroller/server.h"
#include <QSignalSpy>
#include <QTest>

using namespace std::chrono_literals;
using namespace robot;
using protocol::Numbering;
using values::ErrorKind;
using variables::Edit;
using variables::EditState;
using variables::Reference;
using variables::Value;
using virtualcontroller::Direction;
using virtualcontroller::FaultKind;
using virtualcontroller::Faults;
using virtualcontroller::Server;
using VariableKind = variables::Kind;

Q_DECLARE_METATYPE(protocol::Numbering)
Q_DECLARE_METATYPE(protocol::Model)

namespace {

constexpr int perKind = 100;

/// QTest::qWaitFor() sleeps between two looks, which makes hundreds of requests slow.
bool waitFor(const std::function<bool()> &isTrue)
{
    QElapsedTimer clock;
    clock.start();
    while (!isTrue() && clock.elapsed() < 20'000)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    return isTrue();
}

/// A controller on real sockets, the door to it, and edits.
struct Desk {
    explicit Desk(Numbering numbering = Numbering::FromZero, protocol::Model model = protocol::Model::YRC1000)
    {
        options.port = 0;
        options.filePort = 0;
        options.settings.numbering = numbering;
        options.settings.model = model;
        isUp = start();
        settings::Profile profile;
        profile.name = QStringLiteral("CELL 4");
        profile.host = QStringLiteral("127.0.0.1");
        profile.port = server->port();
        profile.filePort = server->filePort();
        profile.readTimeout = 200ms;
        profile.requestsPerSecond = 2000;
        profile.numbering = numbering;
        profile.model = model;
        controller = std::make_unique<Controller>(profile);
        orders = std::make_unique<Orders>(*controller, access, arming);
        QObject::connect(orders.get(), &Orders::recorded, orders.get(),
            [this](const journal::OrderRecord &record) { records << record; });
        variables::Format format;
        format.stringSize = protocol::dialect(model).stringSize;
        edits = std::make_unique<Edits>(*orders, format);
        controller->open();
    }

    /// A new controller at the same place.
    [[nodiscard]] bool start()
    {
        server = std::make_unique<Server>(options);
        const bool isStarted = server->start().has_value();
        options.port = server->port();
        options.filePort = server->filePort();
        return isStarted;
    }

    [[nodiscard]] bool live(bool isVerified = true)
    {
        access.enter(Level::Engineer);
        orders->setNumberingVerified(isVerified);
        return isUp && waitFor([this] { return orders->situation().isLinkUp && orders->situation().status; });
    }

    [[nodiscard]] bool watch(const QList<TopicRange> &topics)
    {
        interest = controller->poller().want(topics);
        return waitFor([&] {
            return std::ranges::all_of(topics, [this](const TopicRange &range) {
                return controller->state().freshness({range.kind, range.last}) != Freshness::Unknown;
            });
        });
    }

    /// Applies, and waits for the end.
    [[nodiscard]] bool apply()
    {
        QSignalSpy applied {edits.get(), &Edits::applied};
        edits->apply();
        return waitFor([&] { return applied.count() == 1; });
    }

    [[nodiscard]] int writes() const
    {
        int count = 0;
        for (const auto &record : records)
            count += record.action.startsWith(QStringLiteral("write-"));
        return count;
    }

    virtualcontroller::Options options;
    Access access;
    Arming arming;
    std::unique_ptr<Server> server;
    std::unique_ptr<Controller> controller;
    std::unique_ptr<Orders> orders;
    std::unique_ptr<Edits> edits;
    Poller::Interest interest;
    QList<journal::OrderRecord> records;
    bool isUp = false;
};

/// A value that differs for each number and kind, and is never the default.
Value sample(VariableKind kind, int number)
{
    values::Position position;
    position.type = kind == VariableKind::P ? values::PositionType::Base : values::PositionType::Pulse;
    position.tool = kind == VariableKind::P ? 1 : 0;
    position.form = kind == VariableKind::P ? 4 : 0;
    position.axes = {1000 + number, -number, 3, 4, 5, 6, 0, 0};
    switch (kind) {
    case VariableKind::B: return values::ByteVariable {quint8(number + 1)};
    case VariableKind::I: return values::IntegerVariable {qint16(-number - 1)};
    case VariableKind::D: return values::DoubleVariable {1'000'000 + number};
    case VariableKind::R: return values::RealVariable {float(number) + 0.1F};
    case VariableKind::S:
        return values::StringVariable32 {values::FixedText<32> {"PART " + QByteArray::number(number)}};
    case VariableKind::M: return values::Register {quint16(60'000 + number)};
    default: return variables::valueWith(kind, position);
    }
}

QList<TopicRange> everything()
{
    QList<TopicRange> ranges;
    for (const VariableKind kind : variables::allKinds)
        ranges << TopicRange {topicOf({kind, 0}).kind, 0, perKind - 1};
    return ranges;
}

} // namespace

class TestEdits : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyKindIsWrittenVerifiedAndUndone_data();
    void everyKindIsWrittenVerifiedAndUndone();
    void numbersAreTheRightOnes();
    void nothingLeavesWhileUnverified_data();
    void nothingLeavesWhileUnverified();
    void aRefusalInTheMiddleLeavesTheRest();
    void aMismatchStaysAndCanBeTriedAgain();
    void anUnansweredWriteIsUnknown();
    void aLostLinkLosesNothingStaged();
    void sixteenByteStrings();
    void neighboursAreLeftAlone();
    void networkInputs();
    void networkInputsThatChangeMeanwhile();
    void networkInputsThatAreRefused();
};

void TestEdits::everyKindIsWrittenVerifiedAndUndone_data()
{
    QTest::addColumn<Numbering>("numbering");
    QTest::newRow("from zero") << Numbering::FromZero;
    QTest::newRow("from one") << Numbering::FromOne;
}

void TestEdits::everyKindIsWrittenVerifiedAndUndone()
{
    QFETCH(Numbering, numbering);
    Desk desk {numbering};
    QVERIFY(desk.live());
    QVERIFY(desk.watch(everything()));
    std::map<Reference, Value> before;
    for (const VariableKind kind : variables::allKinds) {
        for (int number = 0; number < perKind; ++number) {
            const Reference variable {kind, number};
            if (const auto reading = readingOf(desk.controller->state(), variable); reading.value)
                before.insert({variable, *reading.value});
            desk.edits->stage(variable, sample(kind, number));
        }
    }
    const int staged = int(desk.edits->staged().edits().size());
    QVERIFY(staged > 8 * perKind);
    QCOMPARE(desk.records.size(), 0);
    QVERIFY(desk.apply());
    QVERIFY(desk.edits->staged().isEmpty());
    QCOMPARE(desk.writes(), staged);
    for (const VariableKind kind : variables::allKinds) {
        for (int number = 0; number < perKind; ++number)
            QVERIFY(readingOf(desk.controller->state(), {kind, number}).value == sample(kind, number));
    }
    auto &memory = desk.server->memory();
    QCOMPARE(memory.b[7].value, 8);
    QCOMPARE(memory.i[99].value, -100);
    QCOMPARE(memory.d[0].value, 1'000'000);
    QCOMPARE(memory.registers[99].value, 60'099);
    QCOMPARE(memory.s[5].value.bytes().toByteArray(), QByteArray("PART 5"));
    QCOMPARE(memory.p[99]->position.axes[0], 1099);
    // What was undefined before cannot be undone; the rest can.
    QCOMPARE(int(desk.edits->staged().undoable().size()), int(before.size()) - (perKind * 9 - staged));
    desk.edits->undo();
    QCOMPARE(desk.writes(), staged); // staged, not sent
    QVERIFY(desk.apply());
    QVERIFY(desk.edits->staged().isEmpty());
    for (const auto &[variable, value] : before)
        QVERIFY2(readingOf(desk.controller->state(), variable).value == value, qPrintable(toString(variable)));
    QVERIFY(desk.server->arrived(0x302) < 100);
}

/// The instance on the wire is the number, or the number plus one: the memory of the controller is the judge.
void TestEdits::numbersAreTheRightOnes()
{
    for (const Numbering numbering : {Numbering::FromZero, Numbering::FromOne}) {
        Desk desk {numbering};
        QVERIFY(desk.live());
        desk.edits->stage({VariableKind::B, 42}, values::ByteVariable {17});
        desk.edits->stage({VariableKind::M, 42}, values::Register {18});
        QVERIFY(desk.apply());
        QCOMPARE(desk.server->memory().b[42].value, 17);
        QCOMPARE(desk.server->memory().registers[42].value, 18);
        const auto &record = desk.records.constFirst();
        QCOMPARE(record.subject, QStringLiteral("B042"));
        QCOMPARE(record.newValue, QStringLiteral("17"));
    }
}

void TestEdits::nothingLeavesWhileUnverified_data()
{
    QTest::addColumn<Numbering>("profile");
    QTest::addColumn<Numbering>("controller");
    QTest::newRow("as it is") << Numbering::FromZero << Numbering::FromZero;
    QTest::newRow("shifted") << Numbering::FromOne << Numbering::FromOne;
}

void TestEdits::nothingLeavesWhileUnverified()
{
    QFETCH(Numbering, controller);
    Desk desk {controller};
    QVERIFY(desk.live(false));
    for (const VariableKind kind : variables::allKinds) {
        if (kind != VariableKind::M)
            desk.edits->stage({kind, 3}, sample(kind, 3));
    }
    QVERIFY(desk.apply());
    QCOMPARE(desk.edits->staged().edits().size(), 8);
    const Edit first = desk.edits->staged().edits().constFirst();
    QVERIFY(first.state == EditState::Staged);
    QVERIFY(first.error && first.error->kind == ErrorKind::NotSent);
    for (const int command : {0x7A, 0x7B, 0x7C, 0x7D, 0x8C, 0x7F, 0x80, 0x81})
        QCOMPARE(desk.server->arrived(quint16(command)), 0);
    // Registers have no such numbering.
    desk.edits->clear();
    desk.edits->stage({VariableKind::M, 3}, values::Register {5});
    QVERIFY(desk.apply());
    QCOMPARE(desk.server->memory().registers[3].value, 5);
}

void TestEdits::aRefusalInTheMiddleLeavesTheRest()
{
    Desk desk;
    QVERIFY(desk.live());
    for (int number = 0; number < 50; ++number)
        desk.edits->stage({VariableKind::D, number}, values::DoubleVariable {number + 1});
    // Write and read back take turns: the 26th write is the 51st request.
    desk.server->setFaults(Faults {{{0x7C, Direction::Request, FaultKind::Refuse, 1, 50, 1, {}, 0x2110}}});
    QVERIFY(desk.apply());
    const auto left = desk.edits->staged().edits();
    QCOMPARE(left.size(), 1);
    QVERIFY(left.first().variable == (Reference {VariableKind::D, 25}));
    QVERIFY(left.first().state == EditState::Refused);
    QCOMPARE(left.first().error->addedStatus, 0x2110);
    QCOMPARE(desk.server->memory().d[49].value, 50);
    QCOMPARE(desk.server->arrived(0x7C), 99);
    QVERIFY(desk.apply());
    QVERIFY(desk.edits->staged().isEmpty());
}

void TestEdits::aMismatchStaysAndCanBeTriedAgain()
{
    Desk desk;
    QVERIFY(desk.live());
    const Reference b7 {VariableKind::B, 7};
    // A job of the controller writes it as well.
    const auto meddler = QObject::connect(
        desk.orders.get(), &Orders::recorded, desk.orders.get(), [&desk] { desk.server->memory().b[7].value = 40; });
    desk.edits->stage(b7, values::ByteVariable {41});
    QVERIFY(desk.apply());
    const Edit *edit = desk.edits->staged().find(b7);
    QVERIFY(edit && edit->state == EditState::Mismatch);
    QVERIFY(edit->readBack == Value {values::ByteVariable {40}});
    QObject::disconnect(meddler);
    QVERIFY(desk.apply());
    QVERIFY(desk.edits->staged().isEmpty());
    QCOMPARE(desk.server->memory().b[7].value, 41);
}

void TestEdits::anUnansweredWriteIsUnknown()
{
    Desk desk;
    QVERIFY(desk.live());
    desk.server->setFaults(Faults {{{0x7A, Direction::Reply, FaultKind::Lose, 1, 0, 1}}});
    desk.edits->stage({VariableKind::B, 7}, values::ByteVariable {41});
    desk.edits->stage({VariableKind::B, 8}, values::ByteVariable {42});
    QVERIFY(desk.apply());
    const auto left = desk.edits->staged().edits();
    QCOMPARE(left.size(), 1);
    QVERIFY(left.first().state == EditState::Unknown);
    QVERIFY(left.first().error->kind == ErrorKind::UnknownOutcome);
    QCOMPARE(desk.server->memory().b[8].value, 42);
    QCOMPARE(desk.server->arrived(0x7A), 3); // one write, and a write with its read: nothing twice
}

void TestEdits::aLostLinkLosesNothingStaged()
{
    Desk desk;
    QVERIFY(desk.live());
    for (int number = 0; number < 5; ++number)
        desk.edits->stage({VariableKind::I, number}, values::IntegerVariable {7});
    desk.server.reset();
    QVERIFY(waitFor([&] { return desk.controller->linkState() == LinkState::Lost; }));
    QVERIFY(desk.apply());
    QCOMPARE(desk.edits->staged().edits().size(), 5);
    for (const Edit &edit : desk.edits->staged().edits())
        QVERIFY(edit.state == EditState::Staged);
    QVERIFY(desk.start());
    QVERIFY(waitFor([&] { return desk.controller->linkState() == LinkState::Monitoring; }));
    QCOMPARE(desk.server->arrived(0x7B), 0); // reconnecting resumes reading only
}

void TestEdits::sixteenByteStrings()
{
    Desk desk {Numbering::FromZero, protocol::Model::DX200};
    QVERIFY(desk.live());
    desk.edits->stage({VariableKind::S, 4}, values::StringVariable32 {values::FixedText<32> {"sixteen bytes ok"}});
    QVERIFY(desk.apply());
    QVERIFY(desk.edits->staged().isEmpty());
    QCOMPARE(desk.server->arrived(0x7E), 2);
    QCOMPARE(desk.server->memory().s[4].value.bytes().toByteArray(), QByteArray("sixteen bytes ok"));
}

void TestEdits::neighboursAreLeftAlone()
{
    Desk desk;
    QVERIFY(desk.live());
    for (auto &variable : desk.server->memory().b)
        variable.value = 99;
    desk.edits->stage({VariableKind::B, 10}, values::ByteVariable {1});
    desk.edits->stage({VariableKind::B, 11}, values::ByteVariable {2});
    desk.edits->stage({VariableKind::B, 12}, values::ByteVariable {3});
    QVERIFY(desk.apply());
    QCOMPARE(desk.server->memory().b[9].value, 99);
    QCOMPARE(desk.server->memory().b[13].value, 99);
    QCOMPARE(desk.server->arrived(0x302), 0);
}

void TestEdits::networkInputs()
{
    Desk desk;
    QVERIFY(desk.live());
    desk.server->memory().io[2701] = 0b1000'0001;
    IoWrite write {*desk.orders, {2701, 3}};
    write.read();
    QTRY_VERIFY(write.step() == IoWrite::Step::Ready);
    QCOMPARE(write.before()->bits, 0b1000'0001);
    QCOMPARE(write.after()->bits, 0b1000'1001);
    write.write();
    QTRY_VERIFY(write.step() == IoWrite::Step::Done);
    QCOMPARE(desk.server->memory().io[2701], 0b1000'1001);
    QCOMPARE(desk.writes(), 1);
    QCOMPARE(desk.records.constLast().subject, QStringLiteral("#27013"));
    write.write(); // done is done
    QVERIFY(write.step() == IoWrite::Step::Done);
}

void TestEdits::networkInputsThatChangeMeanwhile()
{
    Desk desk;
    QVERIFY(desk.live());
    IoWrite write {*desk.orders, {2701, 3}};
    write.read();
    QTRY_VERIFY(write.step() == IoWrite::Step::Ready);
    desk.server->memory().io[2701] = 0b0000'0100;
    write.write();
    QTRY_VERIFY(write.step() == IoWrite::Step::Changed);
    QCOMPARE(desk.writes(), 0);
    QCOMPARE(write.after()->bits, 0b0000'1100);
    write.write();
    QTRY_VERIFY(write.step() == IoWrite::Step::Done);
    QCOMPARE(desk.server->memory().io[2701], 0b0000'1100);
}

void TestEdits::networkInputsThatAreRefused()
{
    Desk desk;
    QVERIFY(desk.live());
    // An output: the page never asks for it, the controller would refuse.
    IoWrite output {*desk.orders, {1001, 0}};
    output.read();
    QTRY_VERIFY(output.step() == IoWrite::Step::Ready);
    output.write();
    QTRY_VERIFY(output.step() == IoWrite::Step::Refused);
    QVERIFY(output.error().kind == ErrorKind::Refused);
    // Without an answer nobody knows.
    IoWrite lost {*desk.orders, {2701, 0}};
    lost.read();
    QTRY_VERIFY(lost.step() == IoWrite::Step::Ready);
    desk.server->setFaults(Faults {{{0x78, Direction::Reply, FaultKind::Lose, 1, 1, 1}}});
    lost.write();
    QTRY_VERIFY(lost.step() == IoWrite::Step::Unknown);
    // Monitor may not.
    desk.access.enter(Level::Monitor);
    IoWrite monitor {*desk.orders, {2701, 0}};
    monitor.read();
    QTRY_VERIFY(monitor.step() == IoWrite::Step::Ready);
    monitor.write();
    QTRY_VERIFY(monitor.step() == IoWrite::Step::Failed);
    QVERIFY(monitor.error().kind == ErrorKind::NotSent);
}

QTEST_GUILESS_MAIN(TestEdits)
#include "tst_edits.moc"
