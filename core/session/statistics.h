// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QtGlobal>
#include <chrono>
#include <optional>
#include <vector>

namespace session {

/// What a link has seen since it was opened.
struct Counters {
    quint64 requests = 0; ///< First tries sent.
    quint64 repeats = 0; ///< Further tries sent.
    quint64 answers = 0; ///< Answers that belonged to an open request.
    quint64 lost = 0; ///< Requests that ended without an answer.
    quint64 late = 0; ///< Answers to a request that had already ended.
    quint64 duplicates = 0; ///< Further answers to an answered request.
    quint64 mismatched = 0; ///< An open request's id, but another service.
    quint64 malformed = 0; ///< Not an HSES reply.
    quint64 strangers = 0; ///< From another address or port.
    quint64 busy = 0; ///< Reads asked again because the controller was busy.

    bool operator==(const Counters &) const = default;
};

/// One second of a link.
struct LinkSecond {
    int sent = 0; ///< Tries that left.
    int missed = 0; ///< Tries that were given up.
    std::optional<std::chrono::microseconds> roundTrip; ///< The median; empty if nothing was answered.
};

/// How one command fares on a link.
struct CommandStatistics {
    quint16 command = 0;
    std::optional<std::chrono::microseconds> p50; ///< Of the last 64 answers; empty before the first.
    std::optional<std::chrono::microseconds> p95;
    double loss = 0; ///< Tries given up among tries sent since the link was opened, 0 to 1.
    std::optional<std::chrono::milliseconds> lastAnswerAge; ///< Empty before the first answer.
};

/// The last minute of a link.
struct LinkStatistics {
    std::optional<std::chrono::microseconds> p50; ///< Round trip; empty before the first answer.
    std::optional<std::chrono::microseconds> p95;
    double loss = 0; ///< Tries given up among tries sent, 0 to 1.
    int requestsPerSecond = 0; ///< Tries sent in the last full second.
    std::optional<std::chrono::milliseconds> lastAnswerAge; ///< Empty before the first answer.
    std::vector<LinkSecond> seconds; ///< Oldest first, at most 60, up to the last full second.
    std::vector<CommandStatistics> commands; ///< By number.
    Counters counters;
};

} // namespace session
