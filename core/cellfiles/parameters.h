// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "cellfiles/outline.h"
#include <QMap>

namespace cellfiles {

/// The values of one section, row by row of ten: value 22 stands in row 2, column 2, and is what the pendant calls
/// number 22 (controller files reference §3). What could not be read is unknown, and later values keep their place.
struct ParameterSection {
    static constexpr int columns = 10;

    std::vector<std::optional<qint32>> values;
    int line = 0; ///< Of the header.

    [[nodiscard]] std::optional<qint32> at(int number) const
    {
        return number >= 0 && std::size_t(number) < values.size() ? values[std::size_t(number)] : std::nullopt;
    }
};

/// A .PRM file, or ALL.PRM: sections by name ("RS", "RC1G", "S2C").
struct Parameters {
    QByteArray tag; ///< "YAS", "DX", "DN".
    QByteArrayList files; ///< "RC", "RS" …, in order.
    QMap<QByteArray, ParameterSection> sections;
    QByteArray checkLine; ///< The 16 hex digits of FD, another one at every save; never a value.

    [[nodiscard]] std::optional<qint32> value(const QByteArray &section, int number) const;
    [[nodiscard]] bool isEmpty() const { return sections.isEmpty(); }
};
[[nodiscard]] Parsed<Parameters> parametersFrom(QByteArrayView file);

/// What is known of a parameter (reference §3.1).
struct ParameterMeaning {
    const char *section;
    int first;
    int last;
    const char *text; ///< Translated by meaningOf().
    bool isSecret = false; ///< Addresses: masked in reports (reference §15).
};
[[nodiscard]] const ParameterMeaning *findMeaning(const QByteArray &section, int number);
/// A translated phrase; empty if the meaning is not known.
[[nodiscard]] QString meaningOf(const QByteArray &section, int number);
/// "RS022", "S1C1G800": the name of the pendant.
[[nodiscard]] QString parameterName(const QByteArray &section, int number);

} // namespace cellfiles
