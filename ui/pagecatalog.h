// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/pages/page.h"
#include <span>

namespace ui {

/// A key that does something on one page alone.
struct PageKey {
    const char *keys; ///< Portable, several separated by "; ".
    const char *what; ///< Translated in the context "Pages".
};

/// One row a page: rail, shortcuts, pictures, help and tests are made from it.
struct PageRow {
    const char *id;
    const char *title; ///< Translated by title().
    const char *icon;
    const char *shortcut;
    pages::Page *(*create)(const pages::Context &context, QWidget *parent);
    std::span<const char *const> help; ///< Sentences for F1, translated in the context "Pages".
    std::span<const PageKey> keys = {};
};

[[nodiscard]] std::span<const PageRow> pageCatalog();
[[nodiscard]] QString title(const PageRow &row);
[[nodiscard]] QStringList helpOf(const PageRow &row);
[[nodiscard]] QString text(const PageKey &key);

} // namespace ui
