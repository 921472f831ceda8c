// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "trend/incident.h"
#include <QDir>

namespace trend {

/// A kept incident, without its samples.
struct IncidentEntry {
    QString file; ///< Full path.
    Moment at;
    QString title;

    bool operator==(const IncidentEntry &) const = default;
};

/// What the trend keeps of one controller on the disk: which signals are plotted, and the incidents, a JSON file each.
/// The folder is made when something is written. Every call may block.
class Archive
{
public:
    static constexpr int mostIncidents = 100; ///< Keeping another drops the oldest.

    explicit Archive(const QString &folder) : m_folder {folder} { }
    /// The folder of a controller among this user's data.
    [[nodiscard]] static QString folderOf(const QString &controller);

    [[nodiscard]] QString folder() const { return m_folder.path(); }

    /// Signals that this version does not know are left out; empty if nothing was saved.
    [[nodiscard]] QList<Signal> signalSet() const;
    [[nodiscard]] values::Result<void> saveSignalSet(const QList<Signal> &list) const;

    /// The newest first.
    [[nodiscard]] QList<IncidentEntry> incidents() const;
    [[nodiscard]] values::Result<Incident> load(const IncidentEntry &entry) const;
    [[nodiscard]] values::Result<IncidentEntry> keep(const Incident &incident) const;

private:
    [[nodiscard]] QDir incidentFolder() const;

    QDir m_folder;
};

} // namespace trend
