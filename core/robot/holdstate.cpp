// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/holdstate.h"

using values::Status;

namespace robot {

namespace {

std::optional<HoldWord> heldWord(const Status &status)
{
    if (status.data2.testFlag(Status::HeldByCommand))
        return HoldWord::HeldByCommand;
    if (status.data2.testFlag(Status::HeldByPendant))
        return HoldWord::HeldByPendant;
    if (status.data2.testFlag(Status::HeldExternally))
        return HoldWord::HeldExternally;
    return std::nullopt;
}

/// An order that ended badly. Without a live status it is the last thing known, and stays.
std::optional<HoldState> badEnd(const HoldFacts &facts, Time now)
{
    using Progress = HoldOrder::Progress;
    if (!facts.order || (facts.status && now - facts.order->since >= holdOutcomeShown))
        return std::nullopt;
    switch (facts.order->progress) {
    case Progress::Refused: return HoldState {HoldWord::Refused, 0, facts.order->refusal};
    case Progress::Unconfirmed: return HoldState {HoldWord::Unconfirmed};
    case Progress::UnderWay:
    case Progress::Confirmed: break;
    }
    return std::nullopt;
}

} // namespace

HoldState holdState(const HoldFacts &facts, Time now)
{
    if (facts.link == LinkState::Disconnected)
        return {};
    if (facts.order && facts.order->progress == HoldOrder::Progress::UnderWay)
        return {HoldWord::Asked, int(std::chrono::floor<std::chrono::seconds>(now - facts.order->since).count())};
    if (const auto held = facts.status ? heldWord(*facts.status) : std::nullopt)
        return {*held};
    if (const auto end = badEnd(facts, now))
        return *end;
    if (facts.status && facts.releasedAt && now - *facts.releasedAt < releaseShown)
        return {HoldWord::Released};
    return {};
}

} // namespace robot
