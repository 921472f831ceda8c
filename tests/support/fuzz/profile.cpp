// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "settings/profilestore.h"
#include <QJsonDocument>

namespace fuzz {

namespace {

QByteArray text(const settings::Profile &profile) { return QJsonDocument {toJson(profile)}.toJson(); }

/// A profile that is read has no fault, and is written so that it reads the same. Its limits may hold no number at all
/// (NaN), which JSON does not know.
void take(QByteArrayView data)
{
    const auto profile = settings::profileFromJson(QJsonDocument::fromJson(data.toByteArray()).object());
    if (!profile) {
        require(!profile.error().detail.isEmpty(), "a refusal without a sentence");
        return;
    }
    require(settings::complaint(*profile).isEmpty(), "a faulty profile was read");
    const auto again = settings::profileFromJson(QJsonDocument::fromJson(text(*profile)).object());
    require(again && text(*again) == text(*profile), "a profile changed on the way");
}

Seeds seeds()
{
    settings::Profile profile;
    profile.name = QStringLiteral("CELL 4");
    profile.host = QStringLiteral("192.168.1.31");
    profile.pulsesPerDegree[1] = {1000, 900, 800, 700, 600, 500};
    profile.motion.toolSpeed = 50;
    profile.motion.box = motion::Box {{-100, -100, 0}, {100, 100, 900}};
    return {text(profile), text({}), "[]", "{\"name\": 4}"};
}

} // namespace

extern const Target profile;
const Target profile {"profile", take, seeds, 900};

} // namespace fuzz
