// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/gotoedit.h"

#include <QAction>

namespace widgets {

GoToEdit::GoToEdit(QWidget *owner)
{
    setObjectName(QStringLiteral("goTo"));
    setAccessibleName(tr("Go to"));
    setPlaceholderText(tr("Go to…  Ctrl+G"));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    auto *action = new QAction(owner);
    action->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_G));
    owner->addAction(action);
    connect(action, &QAction::triggered, this, [this] {
        setFocus(Qt::ShortcutFocusReason);
        selectAll();
    });
}

QSize GoToEdit::sizeHint() const
{
    constexpr int least = 180;
    constexpr int margins = 16;
    return {
        std::max(least, fontMetrics().horizontalAdvance(placeholderText()) + margins), QLineEdit::sizeHint().height()};
}

} // namespace widgets
