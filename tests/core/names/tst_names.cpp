// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "names/names.h"
#include <QTest>

using namespace names;
using variables::Kind;
using variables::Reference;

class NamesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void localNamesComeFirst();
    void localNamesAreKept();
    void finds();
};

namespace {

const protocol::Dialect &yrc() { return protocol::dialect(protocol::Model::YRC1000); }

} // namespace

void NamesTest::localNamesComeFirst()
{
    Names names;
    names.takeSignalNames({{{1, 0}, QStringLiteral("FIXTURE")}});
    names.takeVariableNames({{{Kind::B, 0}, QStringLiteral("PARTS")}});
    const Signal input {1, 0};
    QVERIFY((names.of(input) == Name {QStringLiteral("FIXTURE"), false}));
    names.setLocal(input, QStringLiteral(" Clamp "));
    QVERIFY((names.of(input) == Name {QStringLiteral("Clamp"), true}));
    QCOMPARE(names.own(input), QStringLiteral("FIXTURE"));
    names.setLocal(input, QStringLiteral("  "));
    QVERIFY((names.of(input) == Name {QStringLiteral("FIXTURE"), false}));
    QVERIFY((names.of(Reference {Kind::B, 0}) == Name {QStringLiteral("PARTS"), false}));
    QVERIFY((names.of(Reference {Kind::B, 1}) == Name {}));
    // Another file of the controller takes nothing local away.
    names.setLocal(Reference {Kind::B, 1}, QStringLiteral("mine"));
    names.takeVariableNames({});
    QVERIFY((names.of(Reference {Kind::B, 0}) == Name {}));
    QVERIFY(names.of(Reference {Kind::B, 1}).isLocal);
    QVERIFY((names.of(input) == Name {QStringLiteral("FIXTURE"), false}));
}

void NamesTest::localNamesAreKept()
{
    Names names;
    names.setLocal(Signal {2701, 3}, QStringLiteral("Request 溶接"));
    names.setLocal(Reference {Kind::EX, 12}, QStringLiteral("Track"));
    const QJsonObject json = names.localNames();
    QCOMPARE(json.keys(), (QStringList {QStringLiteral("#27013"), QStringLiteral("EX012")}));
    Names again;
    again.setLocalNames(json, yrc());
    QCOMPARE(again.localNames(), json);
    QVERIFY(again.of(Signal {2701, 3}).isLocal);
    // What does not belong there is left out.
    again.setLocalNames({{QStringLiteral("#99999"), QStringLiteral("A")}, {QStringLiteral("B100"), QStringLiteral("B")},
                            {QStringLiteral("B001"), 17}, {QStringLiteral("B002"), QStringLiteral("C")}},
        yrc());
    QCOMPARE(again.localNames().keys(), QStringList {QStringLiteral("B002")});
}

void NamesTest::finds()
{
    Names names;
    names.takeSignalNames({{{1, 0}, QStringLiteral("DOOR CLOSED")}, {{1, 1}, QStringLiteral("PART")},
        {{1001, 0}, QStringLiteral("OPEN DOOR")}});
    names.setLocal(Signal {1, 1}, QStringLiteral("Back door"));
    QCOMPARE(names.findSignals(QStringLiteral("door"), 10).size(), 3);
    QCOMPARE(names.findSignals(QStringLiteral("door"), 2).size(), 2);
    QCOMPARE(names.findSignals(QStringLiteral("part"), 10).size(), 0); // it has another name here
    QCOMPARE(names.findSignals(QStringLiteral("DOOR open"), 10).first().number(), 10010);
    QVERIFY(names.findVariables(QStringLiteral("door"), 10).isEmpty());
}

QTEST_APPLESS_MAIN(NamesTest)
#include "tst_names.moc"
