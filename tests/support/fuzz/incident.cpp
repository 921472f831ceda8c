// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "trend/incident.h"
#include <QJsonDocument>

namespace fuzz {

namespace {

/// An incident that is read is written so that it reads the same.
void take(QByteArrayView data)
{
    const auto incident = trend::incidentFromJson(QJsonDocument::fromJson(data.toByteArray()).object());
    if (!incident) {
        require(!incident.error().detail.isEmpty(), "a refusal without a sentence");
        return;
    }
    const QJsonObject kept = toJson(*incident);
    const auto again = trend::incidentFromJson(kept);
    require(again && toJson(*again) == kept, "an incident changed on the way");
}

Seeds seeds()
{
    trend::Incident incident;
    incident.controller = QStringLiteral("CELL 4");
    incident.title = QStringLiteral("Alarm 4315");
    incident.notes << trend::Note {incident.at, QStringLiteral("stopped")};
    return {QJsonDocument {toJson(incident)}.toJson(QJsonDocument::Compact),
        R"({"version":1,"controller":"A","title":"B","at":"2026-11-22T09:15:17.123Z","from":"2026-11-22T09:14:17.123Z",)"
        R"("to":"2026-11-22T09:16:17.123Z","notes":[],"tracks":[{"signal":"torque.1.0","label":"S","unit":"percent",)"
        R"("samples":[[-5,1.5],[0,null],[7,2]]}]})",
        "[1]"};
}

} // namespace

extern const Target incident;
const Target incident {"incident", take, seeds, 600};

} // namespace fuzz
