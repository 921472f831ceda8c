// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/pages/page.h"
#include <span>

namespace ui {

/// One row a page: rail, shortcuts, pictures and tests are made from it.
struct PageRow {
    const char *id;
    const char *title; ///< Translated by title().
    const char *icon;
    const char *shortcut;
    pages::Page *(*create)(const pages::Context &context, QWidget *parent);
};

[[nodiscard]] std::span<const PageRow> pageCatalog();
[[nodiscard]] QString title(const PageRow &row);

} // namespace ui
