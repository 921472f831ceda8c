// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "cellfiles/arm.h"
#include "cellfiles/signalnames.h"
#include <functional>

/// The files of one controller, or of one backup, joined: what one file says of the numbers in another.
namespace cell {

/// What the sentences about one file take from the others.
struct Knowledge {
    static constexpr int robots = 8;

    QMap<int, QString> signalNames; ///< By logical number.
    QHash<variables::Reference, QString> variableNames; ///< Registers too.
    std::array<cellfiles::Arm, robots> arms;
    QHash<int, int> toolJobs; ///< In how many jobs a tool is used for a position.
    QHash<int, int> frameJobs; ///< Likewise a user frame.

    /// "B007 “MODE”", or the number alone.
    [[nodiscard]] QString text(const variables::Reference &variable) const;
    /// "IN#(1) “CYCLE START”", or the number alone.
    [[nodiscard]] QString signalText(int logicalNumber) const;
};

/// The content of a file; nullopt if it is not there or cannot be read.
using FileReader = std::function<std::optional<QByteArray>(const QByteArray &name)>;

/// Joins the files that have these names. Reads every one that matters, so it belongs into a worker where there are
/// many.
[[nodiscard]] Knowledge knowledgeOf(
    const QByteArrayList &names, const FileReader &read, const protocol::TextCodec &codec);

} // namespace cell
