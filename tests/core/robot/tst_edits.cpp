// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "core/robot/desk.h"
#include <array>

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
using VariableKind = variables::Kind;

Q_DECLARE_METATYPE(protocol::Numbering)
Q_DECLARE_METATYPE(protocol::Model)

namespace {

/// The first ones, which another numbering would shift, one in the middle, and the last ones.
constexpr std::array numbers {0, 1, 2, 42, 98, 99};
constexpr int perKind = int(numbers.size());

constexpr int old = 100;
constexpr int fresh = 0;

/// A value that differs for each number, kind and of the two states.
Value sample(const Reference &variable, int state)
{
    const auto [kind, plain] = variable;
    const int number = plain + state;
    const bool isRobot = kind == VariableKind::P;
    values::Position position;
    position.type = isRobot ? values::PositionType::Base : values::PositionType::Pulse;
    position.tool = isRobot ? 1 : 0;
    position.form = isRobot ? 4 : 0;
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

/// What really stands in the controller.
Value valueIn(const virtualcontroller::Memory &memory, const Reference &variable)
{
    const auto number = std::size_t(variable.number);
    switch (variable.kind) {
    case VariableKind::B: return memory.b[number];
    case VariableKind::I: return memory.i[number];
    case VariableKind::D: return memory.d[number];
    case VariableKind::R: return memory.r[number];
    case VariableKind::S: return memory.s[number];
    case VariableKind::P: return memory.p[number].value();
    case VariableKind::BP: return memory.bp[number].value();
    case VariableKind::EX: return memory.ex[number].value();
    case VariableKind::M: break;
    }
    return memory.registers[number];
}

template <typename Item> void put(auto &list, VariableKind kind)
{
    for (const int number : numbers)
        list[std::size_t(number)] = std::get<Item>(sample({kind, number}, old));
}

void fill(virtualcontroller::Memory &memory)
{
    put<values::ByteVariable>(memory.b, VariableKind::B);
    put<values::IntegerVariable>(memory.i, VariableKind::I);
    put<values::DoubleVariable>(memory.d, VariableKind::D);
    put<values::RealVariable>(memory.r, VariableKind::R);
    put<values::StringVariable32>(memory.s, VariableKind::S);
    put<values::PositionVariable>(memory.p, VariableKind::P);
    put<values::BasePosition>(memory.bp, VariableKind::BP);
    put<values::ExternalPosition>(memory.ex, VariableKind::EX);
    put<values::Register>(memory.registers, VariableKind::M);
}

QList<Reference> all()
{
    QList<Reference> result;
    for (const VariableKind kind : variables::allKinds) {
        for (const int number : numbers)
            result << Reference {kind, number};
    }
    return result;
}

QList<TopicRange> everything()
{
    QList<TopicRange> ranges;
    for (const Reference &variable : all())
        ranges << TopicRange {topicOf(variable)};
    return ranges;
}

} // namespace

class TestEdits : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyKindIsWrittenVerifiedAndUndone_data();
    void everyKindIsWrittenVerifiedAndUndone();
    void whatWasUndefinedIsNotUndone();
    void numbersAreTheRightOnes();
    void nothingLeavesWhileUnverified_data();
    void nothingLeavesWhileUnverified();
    void aRefusalInTheMiddleLeavesTheRest();
    void aMismatchStaysAndCanBeTriedAgain();
    void anUnansweredWriteIsUnknown();
    void aLostLinkLosesNothingStaged();
    void sixteenByteStrings();
    void neighboursAreLeftAlone();
};

void TestEdits::everyKindIsWrittenVerifiedAndUndone_data()
{
    QTest::addColumn<Numbering>("numbering");
    QTest::addColumn<protocol::Model>("model");
    QTest::newRow("YRC1000 from zero") << Numbering::FromZero << protocol::Model::YRC1000;
    QTest::newRow("YRC1000 from one") << Numbering::FromOne << protocol::Model::YRC1000;
    QTest::newRow("DX200 from zero") << Numbering::FromZero << protocol::Model::DX200; // strings of 16 bytes
    QTest::newRow("DX200 from one") << Numbering::FromOne << protocol::Model::DX200;
}

/// Some of every kind; the memory of the controller is the judge.
void TestEdits::everyKindIsWrittenVerifiedAndUndone()
{
    QFETCH(Numbering, numbering);
    QFETCH(protocol::Model, model);
    Desk desk {numbering, model};
    auto &memory = desk.server->memory();
    fill(memory);
    QVERIFY(desk.live());
    QVERIFY(desk.watch(everything()));
    for (const Reference &variable : all())
        desk.edits->stage(variable, sample(variable, fresh));
    constexpr int staged = 9 * perKind;
    QCOMPARE(desk.edits->staged().edits().size(), staged);
    QCOMPARE(desk.records.size(), 0);
    QVERIFY(desk.apply());
    QVERIFY(desk.edits->staged().isEmpty());
    QCOMPARE(desk.writes(), staged);
    for (const Reference &variable : all()) {
        QVERIFY2(valueIn(memory, variable) == sample(variable, fresh), qPrintable(toString(variable)));
        QVERIFY(readingOf(desk.controller->state(), variable).value == sample(variable, fresh));
    }
    QCOMPARE(desk.edits->staged().undoable().size(), staged);
    desk.edits->undo();
    QCOMPARE(desk.writes(), staged); // staged, not sent
    QVERIFY(desk.apply());
    QVERIFY(desk.edits->staged().isEmpty());
    QCOMPARE(desk.writes(), 2 * staged);
    for (const Reference &variable : all())
        QVERIFY2(valueIn(memory, variable) == sample(variable, old), qPrintable(toString(variable)));
}

/// It can be written, but there is nothing to go back to.
void TestEdits::whatWasUndefinedIsNotUndone()
{
    Desk desk;
    QVERIFY(desk.live());
    const Reference p90 {VariableKind::P, 90};
    QVERIFY(!desk.server->memory().p[90]);
    desk.interest = desk.controller->poller().want({TopicRange {topicOf(p90)}});
    QVERIFY(waitFor([&] { return readingOf(desk.controller->state(), p90).refusal.has_value(); }));
    desk.edits->stage(p90, sample(p90, fresh));
    QVERIFY(desk.apply());
    QVERIFY(desk.edits->staged().isEmpty());
    QVERIFY(valueIn(desk.server->memory(), p90) == sample(p90, fresh));
    QVERIFY(desk.records.constLast().oldValue.isEmpty());
    QVERIFY(desk.edits->staged().undoable().isEmpty());
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
    QTest::addColumn<Numbering>("believed");
    QTest::addColumn<Numbering>("controller");
    QTest::newRow("as it is") << Numbering::FromZero << Numbering::FromZero;
    QTest::newRow("as it is, from one") << Numbering::FromOne << Numbering::FromOne;
    QTest::newRow("shifted") << Numbering::FromZero << Numbering::FromOne;
    QTest::newRow("shifted back") << Numbering::FromOne << Numbering::FromZero;
}

/// Counted where it would arrive; nothing is read here, so that every packet would be a write.
void TestEdits::nothingLeavesWhileUnverified()
{
    QFETCH(Numbering, believed);
    QFETCH(Numbering, controller);
    Desk desk {controller, protocol::Model::YRC1000, believed};
    fill(desk.server->memory());
    QVERIFY(desk.live(false));
    for (const Reference &variable : all()) {
        if (variable.kind != VariableKind::M)
            desk.edits->stage(variable, sample(variable, fresh));
    }
    QVERIFY(desk.apply());
    const auto left = desk.edits->staged().edits();
    QCOMPARE(left.size(), 8 * perKind);
    QVERIFY(std::ranges::all_of(left, [](const Edit &edit) { return edit.state == EditState::Staged; }));
    QVERIFY(left.first().error && left.first().error->kind == ErrorKind::NotSent);
    for (const int command : {0x7A, 0x7B, 0x7C, 0x7D, 0x7E, 0x8C, 0x7F, 0x80, 0x81, 0x302, 0x303, 0x304, 0x305, 0x306,
             0x307, 0x308, 0x309, 0x30C})
        QCOMPARE(desk.server->arrived(quint16(command)), 0);
    for (const Reference &variable : all())
        QVERIFY(valueIn(desk.server->memory(), variable) == sample(variable, old));
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
    for (int number = 0; number < 50; ++number)
        QCOMPARE(desk.server->memory().d[std::size_t(number)].value, number == 25 ? 0 : number + 1);
    QCOMPARE(desk.server->arrived(0x7C), 99);
    // Each was told by itself.
    QCOMPARE(desk.writes(), 50);
    QCOMPARE(desk.records[25].subject, QStringLiteral("D025"));
    QVERIFY(desk.records[25].outcome == journal::Outcome::Refused);
    QVERIFY(desk.records[26].outcome == journal::Outcome::Done);
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
    desk.edits->stage({VariableKind::I, 5}, values::IntegerVariable {7});
    QVERIFY(desk.apply());
    QCOMPARE(desk.edits->staged().edits().size(), 6);
    for (const Edit &edit : desk.edits->staged().edits())
        QVERIFY(edit.state == EditState::Staged);
    QVERIFY(desk.start());
    QVERIFY(waitFor([&] { return desk.controller->linkState() == LinkState::Monitoring; }));
    QCOMPARE(desk.server->arrived(0x7B), 0); // reconnecting resumes reading only
    QVERIFY(desk.apply());
    QVERIFY(desk.edits->staged().isEmpty());
    QCOMPARE(desk.server->memory().i[5].value, 7);
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

QTEST_GUILESS_MAIN(TestEdits)
#include "tst_edits.moc"
