// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QStringList>

class QPushButton;
class QTreeWidget;

/// Parts that the pages about files and their cards share.
namespace pages {

/// A button that Enter does not press by accident; `name` becomes its objectName.
[[nodiscard]] QPushButton *button(const QString &text, const char *name);

/// Makes a flat list with columns of a tree.
void dressTable(QTreeWidget *tree, const QStringList &titles, const char *name, const QString &accessibleName);

} // namespace pages
