// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "settings/settingsfile.h"

/// The settings as they lie on the disk: {"format": 1, "values": {key: value}}. May block.
namespace settings::onDisk {

/// Reads the file. One that is damaged is renamed and the copy of it used; without either, the settings of earlier
/// versions are taken over from pendesk.conf (INI) in the same folder, which stays as it is.
[[nodiscard]] SettingsFile::Content read(const QString &path);
/// Brings the changes into what the file holds, and answers what it holds then. Waits some seconds if another program
/// is writing. LocalFile with the reason.
[[nodiscard]] values::Result<SettingsFile::Content> write(const QString &path, const SettingsFile::Changes &changes);

/// The values of an INI file of earlier versions, with a sentence if some of it could not be read.
[[nodiscard]] SettingsFile::Content takeOver(const QString &path);

} // namespace settings::onDisk
