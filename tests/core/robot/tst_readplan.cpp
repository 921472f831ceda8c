// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/readplan.h"

#include <QTest>

using namespace robot;

Q_DECLARE_METATYPE(robot::TopicRange)

namespace {

/// "Io 2701-2764/64 Io 3001/1": the range and how many items are asked for.
QString written(const QList<PlannedRead> &reads)
{
    QStringList words;
    for (const auto &[range, count] : reads)
        words << QStringLiteral("%1-%2/%3").arg(range.first).arg(range.last).arg(count);
    return words.join(u' ');
}

} // namespace

/// Limits and the even rule are reference §4.5, areas §4.1; all rows are worked out by hand.
class TestReadPlan : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void fewestRequests_data();
    void fewestRequests();
    void halvesCoverTheRange_data();
    void halvesCoverTheRange();
    void allVariablesTakeTheFewestPackets();
};

void TestReadPlan::fewestRequests_data()
{
    QTest::addColumn<QList<TopicRange>>("wanted");
    QTest::addColumn<QList<int>>("refused"); ///< Of the first range's kind.
    QTest::addColumn<QString>("expected");
    using List = QList<TopicRange>;
    using None = QList<int>;
    const auto io = Kind::IoGroup;
    const auto m = Kind::Register;

    QTest::newRow("nothing") << List {} << None {} << QString();
    QTest::newRow("status") << List {topics::status} << None {} << u"1-1/1"_qs;
    QTest::newRow("slots are asked for one by one") << List {{Kind::Alarm, 1, 3}} << None {} << u"1-1/1 2-2/1 3-3/1"_qs;
    QTest::newRow("64 groups in one") << List {{io, 1, 64}} << None {} << u"1-64/64"_qs;
    QTest::newRow("wanted twice, read once") << List {{io, 1, 64}, {io, 10, 12}} << None {} << u"1-64/64"_qs;
    QTest::newRow("a single group") << List {{io, 2701, 2701}} << None {} << u"2701-2701/1"_qs;
    QTest::newRow("an odd count asks for one more") << List {{io, 1, 3}} << None {} << u"1-3/4"_qs;
    QTest::newRow("odd at the end of the area") << List {{io, 510, 512}} << None {} << u"510-511/2 512-512/1"_qs;
    QTest::newRow("two areas, two packets")
        << List {{io, 512, 512}, {io, 1001, 1002}} << None {} << u"512-512/1 1001-1002/2"_qs;
    QTest::newRow("outside every area") << List {{io, 900, 901}} << None {} << u"900-900/1 901-901/1"_qs;
    QTest::newRow("gaps are read across") << List {{m, 0, 0}, {m, 200, 200}} << None {} << u"0-200/201"_qs;
    QTest::newRow("237 registers a packet")
        << List {{m, 0, 999}} << None {} << u"0-236/237 237-473/237 474-710/237 711-947/237 948-999/52"_qs;
    QTest::newRow("too far apart") << List {{m, 0, 0}, {m, 237, 237}} << None {} << u"0-0/1 237-237/1"_qs;
    QTest::newRow("refused stands alone") << List {{m, 0, 9}} << QList {4} << u"0-3/4 4-4/1 5-9/5"_qs;
    QTest::newRow("refused ends the even rule's room") << List {{io, 1, 3}} << QList {4} << u"1-2/2 3-3/1"_qs;
    QTest::newRow("refused in a gap") << List {{m, 0, 0}, {m, 9, 9}} << QList {4} << u"0-0/1 9-9/1"_qs;
    QTest::newRow("nine positions a packet") << List {{Kind::PositionVariable, 0, 9}} << None {} << u"0-8/9 9-9/1"_qs;
    QTest::newRow("last bytes") << List {{Kind::ByteVariable, 97, 99}} << None {} << u"97-98/2 99-99/1"_qs;
}

void TestReadPlan::fewestRequests()
{
    QFETCH(QList<TopicRange>, wanted);
    QFETCH(QList<int>, refused);
    QFETCH(QString, expected);
    std::set<Topic> topics;
    for (const int number : refused)
        topics.insert({wanted.first().kind, quint16(number)});
    QCOMPARE(written(planReads(wanted, topics, protocol::dialect(protocol::Model::YRC1000))), expected);
}

void TestReadPlan::halvesCoverTheRange_data()
{
    QTest::addColumn<TopicRange>("range");
    QTest::addColumn<QString>("expected");
    QTest::newRow("two") << TopicRange {Kind::Register, 0, 1} << u"0-0/1 1-1/1"_qs;
    QTest::newRow("three bytes") << TopicRange {Kind::ByteVariable, 0, 2} << u"0-0/1 1-2/2"_qs;
    QTest::newRow("nine positions") << TopicRange {Kind::PositionVariable, 0, 8} << u"0-3/4 4-8/5"_qs;
    QTest::newRow("64 groups") << TopicRange {Kind::IoGroup, 1, 64} << u"1-32/32 33-64/32"_qs;
}

void TestReadPlan::halvesCoverTheRange()
{
    QFETCH(TopicRange, range);
    QFETCH(QString, expected);
    QCOMPARE(written(halves(range, protocol::dialect(protocol::Model::YRC1000))), expected);
}

/// B 1, I 1, D 1, R 1, S of 32 bytes 8, P 15 (reference §4.5: 474, 237, 118, 118, 14 and 9 a packet).
void TestReadPlan::allVariablesTakeTheFewestPackets()
{
    const QList<TopicRange> all {{Kind::ByteVariable, 0, 99}, {Kind::IntegerVariable, 0, 99},
        {Kind::DoubleVariable, 0, 99}, {Kind::RealVariable, 0, 99}, {Kind::StringVariable, 0, 99},
        {Kind::PositionVariable, 0, 127}};
    QCOMPARE(planReads(all, {}, protocol::dialect(protocol::Model::YRC1000)).size(), 1 + 1 + 1 + 1 + 8 + 15);
    QCOMPARE(planReads(all, {}, protocol::dialect(protocol::Model::FS100)).size(), 1 + 1 + 1 + 1 + 4 + 15);
}

QTEST_GUILESS_MAIN(TestReadPlan)

#include "tst_readplan.moc"
