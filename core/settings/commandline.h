// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "settings/profilestore.h"

class QCommandLineParser;

namespace settings {

/// The options by which every program is told its controller: --host, --port, --file-port, --profile, --timeout.
void addConnectionOptions(QCommandLineParser &parser);

/// --log, for every program: rules for QLoggingCategory, as "pendesk.*=true;pendesk.session.debug=false". One category
/// a folder of the sources: pendesk.session, pendesk.journal …
void addLogOption(QCommandLineParser &parser);
/// Follows it from now on.
void applyLogOption(const QCommandLineParser &parser);

/// The controller that the parsed options name; nullopt if they name none. BadInput with a whole, translated sentence
/// if they cannot be followed.
[[nodiscard]] values::Result<std::optional<Profile>> namedController(
    const QCommandLineParser &parser, const ProfileStore &store);

} // namespace settings
