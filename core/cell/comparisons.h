// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "cell/comparison.h"
#include "cell/sentences.h"

/// How each type of file is compared: comparison.cpp names them.
namespace cell {

struct Context {
    const Versions &versions;
    const Knowledge &knowledge;
    const protocol::TextCodec &codec;
};

[[nodiscard]] Statements compareTools(const Context &context);
[[nodiscard]] Statements compareUserFrames(const Context &context);
[[nodiscard]] Statements compareCubes(const Context &context);
[[nodiscard]] Statements compareShock(const Context &context);
[[nodiscard]] Statements compareVariables(const Context &context);
[[nodiscard]] Statements compareVariableNames(const Context &context);
[[nodiscard]] Statements compareSignalNames(const Context &context);
[[nodiscard]] Statements compareParameters(const Context &context);
[[nodiscard]] Statements compareLadders(const Context &context);
[[nodiscard]] Statements compareEncoderOffsets(const Context &context);
[[nodiscard]] Statements compareHomePositions(const Context &context);
[[nodiscard]] Statements comparePseudoInputs(const Context &context);
[[nodiscard]] Statements compareSystems(const Context &context);
[[nodiscard]] Statements compareLogs(const Context &context);
[[nodiscard]] Statements compareAlarms(const Context &context);

/// The rows of both views side by side, for whatever has no words of its own.
[[nodiscard]] Statements compareTables(const QByteArray &name, const Context &context);

/// "163.250 → 165.000"
[[nodiscard]] inline QString change(const QString &older, const QString &newer)
{
    const QString nothing = Sentences::tr("nothing");
    return QStringLiteral("%1 → %2").arg(older.isEmpty() ? nothing : older, newer.isEmpty() ? nothing : newer);
}

} // namespace cell
