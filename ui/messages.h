// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/actioncatalog.h"
#include "ui/linkview.h"
#include "ui/widgets/messagebar.h"

namespace ui {

/// A message, and the action that its link stands for.
struct Notice {
    widgets::Message message;
    std::optional<ActionId> action;
};

/// The one thing that the bar has to say about this link now; an empty text if there is nothing. What stops the robot
/// comes first: an order to hold that did not get through stands until the next one.
[[nodiscard]] Notice noticeOf(const LinkView &link, const settings::Profile &profile);

/// Why HOLD cannot be sent: there is no link.
[[nodiscard]] Notice holdWithoutLink();

} // namespace ui
