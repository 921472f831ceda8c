// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "session/idpool.h"
#include "session/policy.h"
#include "session/transfer.h"
#include "settings/profile.h"

namespace robot {

/// How long and how often the sessions of a controller ask, as its profile says.
[[nodiscard]] inline session::Policy policyOf(const settings::Profile &profile)
{
    session::Policy policy;
    policy.timeout = profile.readTimeout;
    policy.repeats = profile.readRepeats;
    policy.servoTimeout = profile.servoTimeout;
    policy.window = profile.window;
    // Even, and never in bursts: the status must not wait for ids to come free, or the link looks lost.
    policy.requestsPerSecond = std::min(profile.requestsPerSecond, session::IdPool::lastingPace(policy.idLinger));
    return policy;
}

[[nodiscard]] inline session::FilePolicy filePolicyOf(const settings::Profile &profile)
{
    session::FilePolicy policy;
    policy.timeout = profile.fileTimeout;
    return policy;
}

} // namespace robot
