// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/holdstate.h"
#include <QTest>

using namespace std::chrono_literals;
using namespace robot;
using values::Status;

namespace {

using Progress = HoldOrder::Progress;
using Held = Status::Data2;

const Time moment = Time {} + 100s;
const values::Error refusal {values::ErrorKind::Refused, 0x1F, 0x2110, {}};

std::optional<Status> live(Held held) { return Status {Status::Data1 {Status::Remote} | Status::Play, held}; }
const std::optional<Status> stale;

HoldOrder order(Progress progress, Milliseconds ago) { return {progress, moment - ago, {}}; }

const LinkState links[] {LinkState::Disconnected, LinkState::Checking, LinkState::Monitoring, LinkState::Lost};
const Held bits[] {Status::HeldByPendant, Status::HeldExternally, Status::HeldByCommand};

} // namespace

/// The words under HOLD are the status bits and the order under way, and nothing else.
class TestHoldState : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void table_data()
    {
        QTest::addColumn<HoldFacts>("facts");
        QTest::addColumn<int>("word");
        QTest::addColumn<int>("seconds");
        const auto row = [](const char *name, const HoldFacts &facts, HoldWord word, int seconds = 0) {
            QTest::newRow(name) << facts << int(word) << seconds;
        };
        using enum LinkState;
        row("nothing", {Monitoring, live({}), {}, {}}, HoldWord::None);
        row("held by command", {Monitoring, live(Status::HeldByCommand), {}, {}}, HoldWord::HeldByCommand);
        row("held by the pendant", {Monitoring, live(Status::HeldByPendant), {}, {}}, HoldWord::HeldByPendant);
        row("held externally", {Monitoring, live(Status::HeldExternally), {}, {}}, HoldWord::HeldExternally);
        row("held by all", {Monitoring, live(bits[0] | bits[1] | bits[2]), {}, {}}, HoldWord::HeldByCommand);
        row("asked", {Monitoring, live({}), order(Progress::UnderWay, 999ms), {}}, HoldWord::Asked, 0);
        row("asked for a second", {Monitoring, live({}), order(Progress::UnderWay, 1000ms), {}}, HoldWord::Asked, 1);
        row("asked again while held", {Monitoring, live(Status::HeldByCommand), order(Progress::UnderWay, 0ms), {}},
            HoldWord::Asked);
        row("asked without a link", {Lost, stale, order(Progress::UnderWay, 1500ms), {}}, HoldWord::Asked, 1);
        row("asked while checking", {Checking, stale, order(Progress::UnderWay, 0ms), {}}, HoldWord::Asked);
        row("confirmed", {Monitoring, live(Status::HeldByCommand), order(Progress::Confirmed, 1h), {}},
            HoldWord::HeldByCommand);
        row("confirmed, then a new start", {Monitoring, live({}), order(Progress::Confirmed, 1s), {}}, HoldWord::None);
        row("confirmed, then lost", {Lost, stale, order(Progress::Confirmed, 1s), {}}, HoldWord::None);
        row("released", {Monitoring, live({}), order(Progress::Confirmed, 1s), moment - 2999ms}, HoldWord::Released);
        row("released long ago", {Monitoring, live({}), order(Progress::Confirmed, 9s), moment - 3s}, HoldWord::None);
        row("released, then lost", {Lost, stale, {}, moment - 1s}, HoldWord::None);
        row("released, then asked", {Monitoring, live({}), order(Progress::UnderWay, 0ms), moment}, HoldWord::Asked);
        row("refused", {Monitoring, live({}), order(Progress::Refused, 0ms), {}}, HoldWord::Refused);
        row("refused long ago", {Monitoring, live({}), order(Progress::Refused, 10s), {}}, HoldWord::None);
        row("refused, held by the pendant",
            {Monitoring, live(Status::HeldByPendant), order(Progress::Refused, 0ms), {}}, HoldWord::HeldByPendant);
        row("not confirmed", {Monitoring, live({}), order(Progress::Unconfirmed, 9999ms), {}}, HoldWord::Unconfirmed);
        row("not confirmed long ago", {Monitoring, live({}), order(Progress::Unconfirmed, 10s), {}}, HoldWord::None);
        row("not confirmed, and nobody knows", {Lost, stale, order(Progress::Unconfirmed, 1h), {}},
            HoldWord::Unconfirmed);
        row("not confirmed, but held after all",
            {Monitoring, live(Status::HeldByCommand), order(Progress::Unconfirmed, 0ms), {}}, HoldWord::HeldByCommand);
        row("stale", {Monitoring, stale, {}, {}}, HoldWord::None);
        row("disconnected", {Disconnected, stale, order(Progress::Unconfirmed, 0ms), moment}, HoldWord::None);
    }
    void table()
    {
        QFETCH(HoldFacts, facts);
        QFETCH(int, word);
        QFETCH(int, seconds);
        QCOMPARE(int(holdState(facts, moment).word), word);
        QCOMPARE(holdState(facts, moment).seconds, seconds);
    }

    void aRefusalIsKept()
    {
        const HoldFacts facts {LinkState::Monitoring, live({}), HoldOrder {Progress::Refused, moment, refusal}, {}};
        QCOMPARE(holdState(facts, moment).refusal, std::optional {refusal});
    }

    /// Over everything there is: "held" only by a live bit, "asked" only with an order under way.
    void neverMoreThanIsKnown()
    {
        for (const LinkState link : links) {
            for (int held = -1; held < 8; ++held) {
                for (int progress = -1; progress < 4; ++progress) {
                    for (const Milliseconds age : {0ms, 5000ms, 3600'000ms}) {
                        Held set;
                        for (int bit = 0; bit < 3; ++bit)
                            set.setFlag(Status::Data2Flag(int(bits[bit])), held >= 0 && (held >> bit & 1));
                        HoldFacts facts {link, held < 0 ? stale : live(set), {}, moment - age};
                        if (progress >= 0)
                            facts.order = order(Progress(progress), age);
                        check(facts);
                    }
                }
            }
        }
    }

private:
    static void check(const HoldFacts &facts)
    {
        const HoldWord word = holdState(facts, moment).word;
        const bool isHeldWord =
            word == HoldWord::HeldByCommand || word == HoldWord::HeldByPendant || word == HoldWord::HeldExternally;
        const bool isUnderWay = facts.order && facts.order->progress == Progress::UnderWay;
        const bool isOpen = facts.link != LinkState::Disconnected;
        QCOMPARE(word == HoldWord::Asked, isUnderWay && isOpen);
        QCOMPARE(isHeldWord, facts.status && facts.status->isHeld() && !isUnderWay && isOpen);
        QVERIFY(word != HoldWord::Released || (facts.status && !facts.status->isHeld()));
        QVERIFY(isOpen || word == HoldWord::None);
    }
};

QTEST_APPLESS_MAIN(TestHoldState)
#include "tst_holdstate.moc"
