// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QString>
#include <tl/expected.hpp>

namespace values {

/// Why something asked of a controller, the network or the disk did not happen.
enum class ErrorKind {
    Refused, ///< The controller answered with a status other than 0 (reference §1.6, §9).
    NoAnswer, ///< A read got no answer within its deadline. Nothing was changed.
    UnknownOutcome, ///< A write, start or move was sent once and not answered: it may or may not have happened.
    Malformed, ///< The answer came but cannot be what was asked for.
    NotSent, ///< The link was closed, or the order was withdrawn before anything left this computer.
    Network, ///< The computer's own network refused: no route, port closed, name not found.
    BadInput, ///< The order itself is not one that the protocol can carry.
    LocalFile, ///< Reading or writing a file on this computer failed.
    Cancelled, ///< The person cancelled.
};

/// A failure as data. It is put into words in one place: protocol::explain().
struct Error {
    ErrorKind kind = ErrorKind::NoAnswer;
    quint8 status = 0; ///< The reply's status byte, for Refused.
    quint16 addedStatus = 0; ///< The reply's added status (reference §9), for Refused.
    QString detail = {}; ///< What was wrong, untranslated; for logs and for kinds that carry no code.

    bool operator==(const Error &) const = default;
};

template <typename Value> using Result = tl::expected<Value, Error>;

inline tl::unexpected<Error> failure(ErrorKind kind, QString detail = {})
{
    return tl::unexpected(Error {kind, 0, 0, std::move(detail)});
}

/// What a person gave cannot be followed; `sentence` says why.
inline tl::unexpected<Error> badInput(QString sentence) { return failure(ErrorKind::BadInput, std::move(sentence)); }

} // namespace values
