// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/archive.h"
#include "settings/notes.h"

namespace station {

/// Where the backups of a controller go at this computer, and which are kept.
struct BackupChoices {
    QString folder; ///< Of all backups; each controller has a folder of its own inside.
    files::Retention retention {};
};

/// What the person chose last; else "Pendesk backups" among the documents, and everything is kept.
[[nodiscard]] BackupChoices readBackupChoices(const settings::Notes &notes);
void writeBackupChoices(settings::Notes notes, const BackupChoices &choices);

} // namespace station
