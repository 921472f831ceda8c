// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "cellfiles/outline.h"
#include "variables/reference.h"
#include <QHash>
#include <QMap>

/// What a controller calls its signals, registers, timers and variables (controller files reference §7).
namespace cellfiles {

/// IONAME.DAT or EXIONAME.DAT: names by logical number. 10 is #00010, that is IN#(1).
struct SignalNames {
    QMap<int, QString> names;
    QMap<int, int> lines; ///< Where a name stands.
};
[[nodiscard]] Parsed<SignalNames> signalNamesFrom(QByteArrayView file, const protocol::TextCodec &codec);

/// "IN#(5)" for 14, "OUT#(889)" for 11120; "#20010" for what is counted by its logical number alone.
[[nodiscard]] QString signalText(int logicalNumber);
/// The logical number of the signal `index` (from 1) of an area that begins at 0, 10000, 20000 or 30000.
constexpr int logicalNumber(int areaStart, int index)
{
    return areaStart + ((index - 1) / 8 + 1) * 10 + (index - 1) % 8;
}

/// IOMNAME.DAT: the names of registers by number. Also UWORD.DAT, FLNAME.DAT and USRIOVAR.DAT have such lists.
struct NameList {
    QMap<int, QString> names;
    int rows = 0; ///< Also those without a name.
};
[[nodiscard]] Parsed<NameList> registerNamesFrom(QByteArrayView file, const protocol::TextCodec &codec);

/// TMNAME.DAT: 60 timers and 60 timer flags.
struct TimerNames {
    QMap<int, QString> timers;
    QMap<int, QString> flags;
};
[[nodiscard]] Parsed<TimerNames> timerNamesFrom(QByteArrayView file, const protocol::TextCodec &codec);

struct VariableName {
    variables::Reference variable;
    QString name;
    int line = 0;

    bool operator==(const VariableName &) const = default;
};

/// VARNAME.DAT. The number stands in the row; a number may occur twice with different names.
struct VariableNames {
    QList<VariableName> names; ///< In the order of the file.
    QHash<variables::Kind, int> shares; ///< Rows that the head announces, a kind.

    /// All names of a variable, " / " between them where there are several.
    [[nodiscard]] QHash<variables::Reference, QString> byVariable() const;
};
[[nodiscard]] Parsed<VariableNames> variableNamesFrom(QByteArrayView file, const protocol::TextCodec &codec);

/// The kinds in the order of SHARE, and the one whose section has this word.
inline constexpr std::array sharedKinds {variables::Kind::B, variables::Kind::I, variables::Kind::D, variables::Kind::R,
    variables::Kind::S, variables::Kind::P, variables::Kind::BP, variables::Kind::EX};
[[nodiscard]] std::optional<variables::Kind> sectionKind(QByteArrayView word);
/// Reads a SHARE line; kinds that it does not give are missing.
[[nodiscard]] QHash<variables::Kind, int> sharesFrom(QByteArrayView text, int line, Warnings &warnings);

} // namespace cellfiles
