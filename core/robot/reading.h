// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/clock.h"
#include "values/error.h"
#include <QDateTime>
#include <optional>

namespace robot {

using values::now;
using values::Time;
using Milliseconds = std::chrono::milliseconds;

/// How a value may be shown. There is no fifth state, and none of them is 0 or blank.
enum class Freshness {
    Unknown, ///< Never read on this link: "—".
    Live, ///< Read within the last two periods.
    Stale, ///< Read once, too long ago: grey and hatched, with the time it was read.
    Refused, ///< The controller refuses to tell: "—" with the reason.
};

/// The latest value of one topic, and when it was read. It never holds a value that did not come from the controller.
template <typename Value> struct Reading {
    std::optional<Value> value;
    Time at {}; ///< When the answer arrived; meaningless while there is no value.
    QDateTime clock; ///< The same moment on this computer's clock, local time.
    std::optional<values::Error> refusal; ///< Set if the last answer was a refusal, with no value.

    void take(Value newValue, Time now)
    {
        value = std::move(newValue);
        at = now;
        clock = QDateTime::currentDateTime();
        refusal.reset();
    }
    void refuse(const values::Error &error)
    {
        value.reset();
        refusal = error;
    }

    /// `period` is how often the topic is read; 0 for a topic that is read once and holds as long as the link.
    [[nodiscard]] Freshness freshness(Time now, Milliseconds period, bool linkIsUp) const
    {
        if (!value)
            return refusal ? Freshness::Refused : Freshness::Unknown;
        if (!linkIsUp || (period.count() > 0 && now - at > 3 * period))
            return Freshness::Stale;
        return Freshness::Live;
    }
};

} // namespace robot
