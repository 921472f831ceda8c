// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "inform/job.h"
#include <functional>

/// When two lines or positions of jobs say the same, though their bytes differ (reference §10.3, §10.4).
namespace inform {

/// Takes the noise out of free text, such as a date in a comment; nothing is taken out if it is empty.
using Clean = std::function<QByteArray(const QByteArray &)>;

/// "0.05" of "+0.050", "0" of "-0.0"; what is no decimal number stays as it is.
[[nodiscard]] QByteArray canonicalNumber(QByteArrayView text);
/// "P5" of P005 and P00005; a number as canonicalNumber; other tokens as they stand.
[[nodiscard]] QByteArray canonical(const Token &token, QByteArrayView line);

/// What a position is, whatever its name: equal if type, tool, user frame, arm form, limit and values are. The tool of
/// base and station axes has no meaning (reference §3.2), and fields of an arm form that are missing are 0.
[[nodiscard]] QByteArray pointKey(const Point &point);

/// What one line says; equal for lines that differ in indentation, in how numbers are written, and in the numbers of C,
/// BC and EC points that are the same positions.
[[nodiscard]] QByteArray lineKey(const Job &job, int number, const Clean &clean);

} // namespace inform
