// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "names/signal.h"
#include "protocol/text.h"
#include "variables/reference.h"
#include <QHash>
#include <QList>

namespace names {

/// What a line of a names file could not be read for.
struct Remark {
    int line = 0; ///< From 1.
    QString reason; ///< A whole, translated sentence.

    bool operator==(const Remark &) const = default;
};

/// The names that a controller gave to its signals (IONAME.DAT) and variables (VARNAME.DAT).
struct NameFile {
    QHash<Signal, QString> signalNames;
    QHash<variables::Reference, QString> variableNames;
    QList<Remark> remarks; ///< The first `maxRemarks` of them.
    int remarkCount = 0; ///< All of them.

    static constexpr int maxRemarks = 200;
};

/// Reads either file: "//IONAME" or "//VARNAME", sections such as "///IN" or "///B", and lines of a number and a name.
/// What can be read is kept, of a damaged file too; what cannot is remarked on with its line. Bytes that the encoding
/// does not hold stand in the name as ⟨8A⟩, with a remark. Lines end in CR LF, LF or CR.
[[nodiscard]] NameFile readNames(
    QByteArrayView file, const protocol::TextCodec &codec, const protocol::Dialect &dialect);

} // namespace names
