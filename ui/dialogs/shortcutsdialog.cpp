// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/shortcutsdialog.h"

#include "ui/actioncatalog.h"
#include "ui/pagecatalog.h"
#include "ui/widgets/text.h"
#include <QDialogButtonBox>
#include <QFormLayout>

namespace dialogs {

ShortcutsDialog::ShortcutsDialog(QWidget *parent) : QDialog(parent)
{
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName(QStringLiteral("shortcutsDialog"));
    setWindowTitle(tr("Keyboard shortcuts"));
    auto *form = new QFormLayout(this);
    form->setHorizontalSpacing(24);
    const auto add = [form](const QString &keys, const QString &what) {
        form->addRow(widgets::text(keys, ui::Type::Heading, ui::Role::Text1),
            widgets::text(what, ui::Type::Body, ui::Role::Text2));
    };
    for (const ui::ActionRow &row : ui::actionCatalog()) {
        if (*row.shortcut)
            add(ui::shortcutText(row.shortcut), ui::text(row));
    }
    for (const ui::PageRow &row : ui::pageCatalog())
        add(ui::shortcutText(row.shortcut), tr("Page: %1").arg(ui::title(row)));
    add(ui::shortcutText("F10"), tr("Menu"));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
}

} // namespace dialogs
