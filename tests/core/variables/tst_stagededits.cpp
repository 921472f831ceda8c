// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "variables/stagededits.h"
#include <QTest>

using namespace variables;
using values::ByteVariable;

class StagedEditsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void stagesInOrder();
    void anEditBackIsNone();
    void aVerifiedWriteIsDoneAndUndoable();
    void aMismatchStays();
    void refusalAndUnknownStay();
    void whatIsOnItsWayIsLeftAlone();
    void undoesByBatches();
    void whatWasNeverReadIsNotUndone();
};

namespace {

const Reference b2 {Kind::B, 2};
const Reference b7 {Kind::B, 7};
const Reference d0 {Kind::D, 0};

void write(StagedEdits &edits, const Reference &variable, const std::optional<Value> &now, const Value &readBack)
{
    edits.setWriting(variable, now);
    edits.setReadBack(variable, readBack);
}

} // namespace

void StagedEditsTest::stagesInOrder()
{
    StagedEdits edits;
    QVERIFY(edits.isEmpty());
    edits.stage(d0, values::DoubleVariable {5}, values::DoubleVariable {4});
    edits.stage(b7, ByteVariable {41}, ByteVariable {40});
    edits.stage(b2, ByteVariable {5}, std::nullopt);
    const auto list = edits.edits();
    QCOMPARE(list.size(), 3);
    QVERIFY(list[0].variable == b2 && list[1].variable == b7 && list[2].variable == d0);
    QVERIFY(!list[0].was);
    QVERIFY(list[1].was == Value {ByteVariable {40}});
    edits.stage(b7, ByteVariable {42}, ByteVariable {40});
    QVERIFY(edits.find(b7)->value == Value {ByteVariable {42}});
    edits.discard(b7);
    QVERIFY(!edits.find(b7));
    edits.clear();
    QVERIFY(edits.isEmpty());
}

void StagedEditsTest::anEditBackIsNone()
{
    StagedEdits edits;
    edits.stage(b2, ByteVariable {5}, ByteVariable {5});
    QVERIFY(edits.isEmpty());
    edits.stage(b2, ByteVariable {6}, ByteVariable {5});
    edits.stage(b2, ByteVariable {5}, ByteVariable {5});
    QVERIFY(edits.isEmpty());
}

void StagedEditsTest::aVerifiedWriteIsDoneAndUndoable()
{
    StagedEdits edits;
    edits.stage(b2, ByteVariable {5}, ByteVariable {2});
    edits.setWriting(b2, ByteVariable {3}); // it changed meanwhile
    QVERIFY(edits.find(b2)->state == EditState::Writing);
    edits.setReadBack(b2, ByteVariable {5});
    QVERIFY(edits.isEmpty());
    QCOMPARE(edits.undoable().size(), 1);
    QVERIFY(edits.undoable().first().value == Value {ByteVariable {3}});
    QVERIFY(edits.undoable().first().was == Value {ByteVariable {5}});
}

void StagedEditsTest::aMismatchStays()
{
    StagedEdits edits;
    edits.stage(b7, ByteVariable {41}, ByteVariable {40});
    write(edits, b7, ByteVariable {40}, ByteVariable {40});
    const Edit *edit = edits.find(b7);
    QVERIFY(edit && edit->state == EditState::Mismatch);
    QVERIFY(edit->readBack == Value {ByteVariable {40}});
    QVERIFY(edits.undoable().isEmpty());
    QCOMPARE(edits.toApply().size(), 1);
    write(edits, b7, ByteVariable {40}, ByteVariable {41});
    QVERIFY(edits.isEmpty());
}

void StagedEditsTest::refusalAndUnknownStay()
{
    StagedEdits edits;
    const values::Error refusal {values::ErrorKind::Refused, 0x1F, 0x2110, {}};
    edits.stage(b2, ByteVariable {1}, ByteVariable {0});
    edits.stage(b7, ByteVariable {1}, ByteVariable {0});
    edits.setWriting(b2, ByteVariable {0});
    edits.setWriting(b7, ByteVariable {0});
    QVERIFY(edits.toApply().isEmpty());
    edits.setRefused(b2, refusal);
    edits.setUnknown(b7, {values::ErrorKind::UnknownOutcome, 0, 0, {}});
    QVERIFY(edits.find(b2)->state == EditState::Refused);
    QVERIFY(edits.find(b2)->error == refusal);
    QVERIFY(edits.find(b7)->state == EditState::Unknown);
    QCOMPARE(edits.toApply().size(), 2);
    edits.setWriting(b2, ByteVariable {0});
    QVERIFY(!edits.find(b2)->error);
}

void StagedEditsTest::whatIsOnItsWayIsLeftAlone()
{
    StagedEdits edits;
    edits.stage(b2, ByteVariable {1}, ByteVariable {0});
    edits.setWriting(b2, ByteVariable {0});
    edits.stage(b2, ByteVariable {9}, ByteVariable {0});
    edits.discard(b2);
    edits.clear();
    QVERIFY(edits.find(b2)->value == Value {ByteVariable {1}});
    // What is not on its way takes no news.
    edits.setReadBack(b7, ByteVariable {1});
    edits.setRefused(d0, {});
    QCOMPARE(edits.edits().size(), 1);
}

void StagedEditsTest::undoesByBatches()
{
    StagedEdits edits;
    edits.beginBatch();
    edits.stage(b2, ByteVariable {1}, ByteVariable {0});
    edits.stage(b7, ByteVariable {8}, ByteVariable {7});
    write(edits, b2, ByteVariable {0}, ByteVariable {1});
    write(edits, b7, ByteVariable {7}, ByteVariable {8});
    edits.beginBatch();
    edits.beginBatch(); // one in which nothing was written is none
    edits.stage(b2, ByteVariable {2}, ByteVariable {1});
    write(edits, b2, ByteVariable {1}, ByteVariable {2});
    QCOMPARE(edits.undoable().size(), 1);
    edits.undo();
    QVERIFY(edits.find(b2)->value == Value {ByteVariable {1}});
    QVERIFY(edits.find(b2)->state == EditState::Staged);
    edits.clear();
    QCOMPARE(edits.undoable().size(), 2);
    edits.undo();
    QVERIFY(edits.find(b2)->value == Value {ByteVariable {0}});
    QVERIFY(edits.find(b7)->value == Value {ByteVariable {7}});
    QVERIFY(edits.undoable().isEmpty());
    // Writing them is a batch of its own, which can be undone.
    write(edits, b7, ByteVariable {8}, ByteVariable {7});
    QVERIFY(edits.undoable().first().value == Value {ByteVariable {8}});
}

void StagedEditsTest::whatWasNeverReadIsNotUndone()
{
    StagedEdits edits;
    edits.stage(b2, ByteVariable {1}, std::nullopt);
    write(edits, b2, std::nullopt, ByteVariable {1});
    QVERIFY(edits.undoable().isEmpty());
    QVERIFY(edits.isEmpty());
}

QTEST_APPLESS_MAIN(StagedEditsTest)
#include "tst_stagededits.moc"
