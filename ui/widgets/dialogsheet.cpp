// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/dialogsheet.h"

#include "ui/widgets/sheetlayer.h"
#include <QPushButton>

namespace widgets {

DialogSheet::DialogSheet(QWidget *owner) : QDialog(owner), m_owner {owner} { setAttribute(Qt::WA_DeleteOnClose); }

void DialogSheet::setVisible(bool isVisible)
{
    if (isVisible && isWindow() && m_owner) {
        if (isOpenAlready())
            return deleteLater();
        enter();
    }
    if (isVisible) {
        m_isAnswered = false;
        setEnabled(true);
    }
    QDialog::setVisible(isVisible);
    if (isVisible && !isWindow())
        keepDefault();
}

bool DialogSheet::isOpenAlready() const
{
    const auto open = SheetLayer::of(m_owner->window())->sheets();
    return std::ranges::any_of(open, [this](const DialogSheet *sheet) {
        return !objectName().isEmpty() && sheet->objectName() == objectName() && sheet->m_owner == m_owner;
    });
}

/// From a child of its owner to a child of the layer; it still goes when the owner goes.
void DialogSheet::enter()
{
    SheetLayer *layer = SheetLayer::of(m_owner->window());
    connect(m_owner, &QObject::destroyed, this, [this] { delete this; });
    layer->take(this);
}

/// Qt forgets which button is the default one when the focus leaves it, unless the dialog is a window.
void DialogSheet::keepDefault()
{
    for (auto *button : findChildren<QPushButton *>()) {
        if (button->isDefault())
            button->setAutoDefault(false);
    }
}

void DialogSheet::done(int result)
{
    if (std::exchange(m_isAnswered, true))
        return;
    setEnabled(false);
    QDialog::done(result);
}

QPushButton *writing(QPushButton *button)
{
    button->setProperty("writes", true);
    button->setDefault(false);
    button->setAutoDefault(false);
    return button;
}

bool isWriting(const QPushButton *button) { return button->property("writes").toBool(); }

} // namespace widgets
