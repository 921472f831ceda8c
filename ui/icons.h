// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QIcon>

namespace ui {

/// An own drawing from resources/icons, in the text colour of the present scheme, the accent where it is checked, and
/// text 3 where it is disabled. It is drawn when it is first painted. An empty name gives a null icon.
[[nodiscard]] QIcon icon(const QString &name);

/// The program's own icon, in its own colours.
[[nodiscard]] QIcon applicationIcon();

} // namespace ui
