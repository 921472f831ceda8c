// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "values/managementtime.h"

#include <QRegularExpression>

namespace values {

std::optional<std::chrono::seconds> ManagementTime::duration() const
{
    static const QRegularExpression form {QStringLiteral("^(\\d+):([0-5]\\d)'([0-5]\\d)$")};
    const auto match = form.match(QString::fromLatin1(elapsed.bytes()));
    if (!match.hasMatch())
        return std::nullopt;
    return std::chrono::hours {match.captured(1).toLongLong()} + std::chrono::minutes {match.captured(2).toInt()}
    + std::chrono::seconds {match.captured(3).toInt()};
}

} // namespace values
