// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "cell/knowledge.h"

namespace cell {

/// One difference between two versions of a file, in a sentence.
struct Statement {
    QString text;
    bool isSafety = false; ///< It may move the robot elsewhere, or switch off what protects people.
    bool isNoise = false; ///< Worth no attention: hours, counters, log entries.

    bool operator==(const Statement &) const = default;
};

using Statements = QList<Statement>;

/// Two versions of one file.
struct Versions {
    QByteArray older;
    QByteArray newer;
};

/// What is different between two versions of a file that is no job, in the words of the pendant (controller files
/// reference §16), the safety relevant first. At most `mostStatements`; the last one counts the rest. An empty or
/// damaged version is said to be so: what is missing in it was not deleted. Empty: no difference that means anything.
[[nodiscard]] Statements statementsOf(
    const QByteArray &name, const Versions &versions, const Knowledge &knowledge, const protocol::TextCodec &codec);
constexpr int mostStatements = 200;

/// Has this type of file words of its own, so that what they leave out is noise and nothing else is?
[[nodiscard]] bool hasWords(const QByteArray &name);

/// Is any of them more than noise?
[[nodiscard]] bool isDifference(const Statements &statements);

} // namespace cell
