// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QString>

namespace values {

/// What a person typed, without what only looks different: trimmed, digits of any script and full-width letters and
/// signs as ASCII, every minus as "-". Nothing else is changed.
[[nodiscard]] QString plainText(QStringView typed);

} // namespace values
