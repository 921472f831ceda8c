// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "trend/series.h"
#include <QDateTime>
#include <optional>

namespace trend {

[[nodiscard]] Moment now();
[[nodiscard]] Moment toMoment(const QDateTime &clock);
[[nodiscard]] QDateTime toLocalTime(Moment moment);
/// "2026-11-22T09:15:17.123Z", UTC.
[[nodiscard]] QString toIso(Moment moment);
/// nullopt for a text of another form.
[[nodiscard]] std::optional<Moment> fromIso(const QString &text);

} // namespace trend
