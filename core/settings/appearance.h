// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QString>

namespace settings {

/// How this user wants the program to look. What is empty, or no word that the program knows, follows the desktop.
struct Appearance {
    QString language; ///< Code of one of ui::languages().
    QString scheme; ///< "light" or "dark".

    bool operator==(const Appearance &) const = default;
};

} // namespace settings
