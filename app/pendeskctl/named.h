// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "desk.h"
#include "variables/reference.h"
#include <QJsonObject>

namespace pendeskctl {

/// Something that was read, by the name that it has on the pendant.
struct NamedValue {
    QString name;
    QString text;
    QJsonValue json; ///< null for a number that is none, such as the NaN of an R variable.
};

/// A row of variables, registers or I/O groups, or one signal.
struct Selection {
    enum class What { Variables, Groups, Signal } what = What::Variables;
    variables::Range range; ///< For Variables.
    int first = 0; ///< For Groups, and the group of a signal.
    int last = 0;
    int bit = 0; ///< For Signal.
};

/// "B005", "D000..D099", "M5", "2701..2710" for I/O groups, "#27010", "27010" or "IN#(1)" for one signal. BadInput with
/// a sentence for anything else.
[[nodiscard]] values::Result<Selection> selectionFromText(const QString &text, const protocol::Dialect &dialect);

/// The controller's dialect without its standard number of variables: options add to them (reference §0.1 l), so
/// whether it has one is for the controller to say.
[[nodiscard]] protocol::Dialect askedDialect(const Call &call);

/// Several of them; a mistake is complained about, and so is that there is none.
[[nodiscard]] std::optional<QList<Selection>> selectionsFromText(const Call &call, const QStringList &words);

using ValuesHandler = std::function<void(const values::Result<QList<NamedValue>> &)>;
/// Reads one selection after the other, each in the fewest packets. The first error ends it.
void readAll(Desk &desk, const QList<Selection> &selections, const ValuesHandler &handler);

/// Writes one variable or register and reads it back. Malformed with a sentence if another value came back.
void write(Desk &desk, const variables::Reference &reference, const QString &typed,
    const std::function<void(const values::Result<NamedValue> &)> &handler);

/// Prints values as lines, or as one object by name.
void print(const Call &call, const QList<NamedValue> &values);

} // namespace pendeskctl
