// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/conditions.h"
#include "robot/controller.h"

namespace robot {

/// What a person wants to know of a controller before working with it.
enum class Subject {
    Reading, ///< Status and system information.
    Data, ///< I/O and variables.
    Ranges, ///< Of signals, variables and groups, which follow the model.
    Remote, ///< Orders.
    JobSelect,
    JobStart,
    Servo, ///< On.
    Moves, ///< 0x8A 0x8B.
    Hold,
    Files, ///< The file port.
    Overwrite, ///< Replacing files that exist there.
    Numbering, ///< Of variables (RS022).
};
constexpr int subjectCount = int(Subject::Numbering) + 1;

enum class Allowance { Allowed, NotAllowed, NotKnown };

/// What an allowance rests on.
enum class Evidence {
    Measured, ///< It was read from the controller, tried, or compared with the pendant.
    Assumed, ///< Nothing that was read speaks against it; nobody tried it.
    Unreadable, ///< It hangs on a setting that HSES does not tell.
    Unread, ///< It can be read and was not yet.
};

/// Something that was asked to see whether it is answered.
struct Probe {
    enum class Outcome { Unread, Answered, Failed };

    Outcome outcome = Outcome::Unread;
    std::optional<values::Error> error; ///< Why it failed.

    bool operator==(const Probe &) const = default;
};

/// Everything that the readiness of a controller is judged by.
struct ReadinessFacts {
    LinkState link = LinkState::Disconnected;
    /// As it was read last. Level and arming are this program's business and not looked at.
    Situation situation;
    settings::Profile profile;
    std::optional<values::SystemInformation> system;
    Probe signal; ///< A group of I/O.
    Probe variable;
    Probe files; ///< A list of jobs over the file port.
    std::optional<HoldOrder> hold; ///< The last one given on this link.
};

/// How one subject stands.
struct ReadinessRow {
    Subject subject = Subject::Reading;
    Allowance allowance = Allowance::NotKnown;
    Evidence evidence = Evidence::Unread;
    QList<Condition> obstacles {}; ///< Not met now, as read; in the order in which the controller would refuse.
    QList<Condition> untold {}; ///< What it depends on besides, and HSES does not tell.
    std::optional<values::Error> error {}; ///< What came back when it was tried.

    bool operator==(const ReadinessRow &) const = default;
};

/// What this controller allows now: one row a subject, in their order. It rests on findings() and claims nothing as
/// measured that is not among the facts.
[[nodiscard]] QList<ReadinessRow> readiness(const ReadinessFacts &facts);

/// The facts about a controller: what was read last, even if communication was lost since. The probes are left out.
[[nodiscard]] ReadinessFacts readinessFacts(const Controller &controller, const Situation &situation);

/// In plain English, for tests and logs; ui translates and explains it.
[[nodiscard]] const char *key(Subject subject);

} // namespace robot
