// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/files/parts.h"

#include "ui/theme.h"
#include "ui/widgets/rowdelegate.h"
#include <QHeaderView>
#include <QPushButton>
#include <QTreeWidget>

namespace pages {

QPushButton *button(const QString &text, const char *name)
{
    auto *result = new QPushButton(text);
    result->setObjectName(QLatin1String(name));
    result->setAutoDefault(false);
    return result;
}

void dressTable(QTreeWidget *tree, const QStringList &titles, const char *name, const QString &accessibleName)
{
    tree->setObjectName(QLatin1String(name));
    tree->setAccessibleName(accessibleName);
    tree->setHeaderLabels(titles);
    tree->setRootIsDecorated(false);
    tree->setUniformRowHeights(true);
    tree->header()->setFont(ui::font(ui::Type::Label));
    widgets::RowDelegate::dress(tree);
}

} // namespace pages
