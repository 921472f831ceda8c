// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/bagtext.h"
#include "files/fileset.h"
#include "files/localname.h"
#include <memory>

namespace files {

/// A backup that is being written, in a folder whose name ends in ".partial" until it is whole. No half backup can be
/// taken for a whole one, whenever the program or the computer stops.
class BagWriter
{
public:
    /// Begins in `folder`, which is made if need be.
    static values::Result<std::unique_ptr<BagWriter>> create(const QString &folder, const QDateTime &taken);
    /// Takes away what was not sealed.
    ~BagWriter();
    BagWriter(const BagWriter &) = delete;
    BagWriter &operator=(const BagWriter &) = delete;

    [[nodiscard]] values::Result<void> add(const values::FileName &name, const QByteArray &content);
    /// Waits until the disk has everything, then gives the folder its name, which it returns. Can take seconds and may
    /// run in another thread. The writer is done with afterwards.
    [[nodiscard]] values::Result<QString> seal(const BagInfo &info);

private:
    BagWriter(QString folder, QString id) : m_folder {std::move(folder)}, m_id {std::move(id)} { }
    [[nodiscard]] QString path() const;
    [[nodiscard]] values::Result<void> addTag(Manifest &tags, const QString &name, const QByteArray &content);
    [[nodiscard]] values::Result<void> writeTags(const BagInfo &info);

    QString m_folder;
    QString m_id;
    LocalNames m_names;
    Manifest m_manifest;
    qint64 m_bytes = 0;
    bool m_isSealed = false;
};

/// A finished backup on disk.
class Bag
{
public:
    /// LocalFile if there is no bag that can be read; whether it is good, verify() says.
    static values::Result<Bag> open(const QString &path);

    [[nodiscard]] const QString &path() const { return m_path; }
    [[nodiscard]] const BagInfo &info() const { return m_info; }
    [[nodiscard]] FileSet files() const;

private:
    QString m_path;
    BagInfo m_info;
    Manifest m_manifest;
};

enum class FaultKind {
    NotABag, ///< bagit.txt or the manifest is missing, or of another version.
    Malformed, ///< A manifest is not as it was written, or names something outside.
    Changed,
    Missing,
    Extra, ///< Not listed, or no plain file.
};

struct BagFault {
    FaultKind kind;
    QString path; ///< Below the bag.

    bool operator==(const BagFault &) const = default;
};

/// "data/HOME.JBI was changed."
[[nodiscard]] QString explain(const BagFault &fault);

struct Verification {
    QList<BagFault> faults;
    int files = 0; ///< Looked at, in data/.
    qint64 bytes = 0;

    [[nodiscard]] bool isGood() const { return faults.isEmpty(); }
};

/// Reads and hashes every byte of the bag at `path`: is it what was written? Can take seconds and may run in another
/// thread.
[[nodiscard]] Verification verify(const QString &path);

} // namespace files
