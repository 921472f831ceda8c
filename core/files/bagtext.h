// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/filename.h"
#include <QDateTime>
#include <QList>
#include <map>

/// The text files of a bag (RFC 8493) as text and back.
namespace files {

/// How a file of the controller fared in a backup.
struct FileResult {
    QByteArray name; ///< As the controller listed it; perhaps no name that can be asked for.
    std::optional<values::Error> error; ///< Empty: it is in the bag.

    bool operator==(const FileResult &) const = default;
};

/// What bag-info.txt says.
struct BagInfo {
    QString controller; ///< Name of the profile.
    QString host;
    QString model; ///< As the controller gives it; empty if it was not read. So are the next two.
    QString software;
    QString parameterVersion;
    QDateTime taken; ///< UTC, when the backup began.
    QList<FileResult> results; ///< A list that was refused is in it by its pattern.

    [[nodiscard]] int failures() const;
    [[nodiscard]] bool isComplete() const { return failures() == 0; }
    bool operator==(const BagInfo &) const = default;
};

[[nodiscard]] QByteArray toText(const BagInfo &info, qint64 bytes, int files);
/// Unknown labels are skipped: other programs may have added some.
[[nodiscard]] BagInfo bagInfoFrom(const QByteArray &text);

/// The declaration in bagit.txt.
[[nodiscard]] QByteArray bagDeclaration();

/// Paths below the bag and their SHA-256 in lower-case hex.
using Manifest = std::map<QByteArray, QByteArray>;

[[nodiscard]] QByteArray toText(const Manifest &manifest);
/// nullopt unless `text` is exactly what toText() writes, and no path leads out of the bag. So no byte of it can change
/// unseen.
[[nodiscard]] std::optional<Manifest> manifestFrom(const QByteArray &text);

[[nodiscard]] QByteArray sha256(const QByteArray &content);

} // namespace files
