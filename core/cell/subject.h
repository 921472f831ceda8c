// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "inform/statement.h"
#include <QString>
#include <optional>
#include <tuple>

/// What the files of one controller say together: where a thing is used, which job calls which (INFORM reference §7).
namespace cell {

/// Something that lines of jobs and of the ladder have to do with.
struct Subject {
    enum class Kind : quint8 {
        B,
        I,
        D,
        R,
        S,
        P,
        BP,
        EX,
        Register, ///< M005, MREG#(5) in jobs.
        Signal, ///< By its logical number: 14 is #00014, which jobs call IN#(5).
        Tool,
        UserFrame,
        Macro, ///< MJ#(2)
        Numbered, ///< Files and other things that jobs number: `name` is "ASF", "WEV", "CV", "GUN", "RIN", "AO".
        Alarm, ///< A user alarm that a job sets, 8000 to 8999, or the ladder, 9000 to 9255.
        System, ///< `name` is "$RV", "$B002".
        Job, ///< `name` is the job's.
    };

    Kind kind = Kind::B;
    int number = 0; ///< 0 for jobs and system variables.
    QByteArray name = {};

    bool operator==(const Subject &) const = default;
    /// By kind, number, name.
    bool operator<(const Subject &other) const
    {
        return std::tie(kind, number, name) < std::tie(other.kind, other.number, other.name);
    }
};

/// B to EX.
[[nodiscard]] constexpr bool isVariable(Subject::Kind kind) { return kind <= Subject::Kind::EX; }

/// As on the pendant: "B012", "M005", "IN#(5)" or "#40010", "TOOL 3", "UF#(2)", "MJ#(2)", "ASF#(12)", "8021", "$RV";
/// a job is its name, decoded as Latin-1: whoever shows it decodes `name`.
[[nodiscard]] QString toString(const Subject &subject);
/// Reads these, and "b12", "OT 5", "OUT#(5)", "TL#(3)", "M5"; anything else is taken for a job's name. nullopt for an
/// empty text.
[[nodiscard]] std::optional<Subject> subjectFromText(QStringView text);

/// The subjects that a reference such as "OG#(1)" stands for: eight signals. Empty for what belongs to one job alone
/// (C points, locals, steps, arguments) and for what no rule knows.
[[nodiscard]] QList<Subject> subjectsOf(QByteArrayView reference);
/// The kind of which `reference` of inform::references() is any: "B", "OT#", "P". `name` is that of Numbered.
struct AnyOf {
    Subject::Kind kind;
    QByteArray name = {};
    int first = 0; ///< Least and greatest number that it may be.
    int last = 0;
};
[[nodiscard]] std::optional<AnyOf> anyOf(QByteArrayView reference);

} // namespace cell
