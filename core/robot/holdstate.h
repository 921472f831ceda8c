// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/reading.h"
#include "values/status.h"

namespace robot {

/// Where the link to a controller stands. *Connected* means that status and system information were answered.
enum class LinkState {
    Disconnected, ///< Nobody asked for a link.
    Checking, ///< Asking; no valid reply to system information and status yet. Goes on until told to stop.
    Monitoring, ///< Values are live.
    Lost, ///< Was monitoring, then the status stayed away for three time-outs. Reading resumes by itself.
};

/// The last order to hold that was given on the present link, and how far it has come.
struct HoldOrder {
    enum class Progress {
        UnderWay, ///< Sent, and sent again until a status confirms it, for 2 s.
        Confirmed, ///< A status said "held by command". What the status says now is another matter.
        Refused, ///< The controller refused; see `refusal`.
        Unconfirmed, ///< 2 s passed, or it could not be sent. The robot may or may not have stopped.
    };
    Progress progress = Progress::UnderWay;
    Time since {}; ///< When it was asked; once it is over, when it ended.
    std::optional<values::Error> refusal {};

    bool operator==(const HoldOrder &) const = default;
};

/// Everything that the words under HOLD may depend on.
struct HoldFacts {
    LinkState link = LinkState::Disconnected;
    std::optional<values::Status> status {}; ///< Only while it is live.
    std::optional<HoldOrder> order {};
    /// When the live status last went from held by command to not held; empty once it is held again.
    std::optional<Time> releasedAt {};
};

/// What is said under HOLD.
enum class HoldWord {
    None, ///< Nothing to say: not held as far as known, and nobody asked for it.
    Asked,
    HeldByCommand,
    HeldByPendant,
    HeldExternally,
    Refused,
    Unconfirmed,
    Released, ///< A hold by command has just ended.
};

struct HoldState {
    HoldWord word = HoldWord::None;
    int seconds = 0; ///< Since it was asked, while Asked.
    std::optional<values::Error> refusal {}; ///< While Refused.

    bool operator==(const HoldState &) const = default;
};

/// How long the end of an order, or of a hold, is worth a word beside a live status that says otherwise.
constexpr Milliseconds holdOutcomeShown {10'000};
constexpr Milliseconds releaseShown {3'000};

/// The words under HOLD are this function of the status bits and the order under way, and nothing else: nothing is
/// remembered that could outlive what it was true of. A status that is not live never says "held".
[[nodiscard]] HoldState holdState(const HoldFacts &facts, Time now);

} // namespace robot
