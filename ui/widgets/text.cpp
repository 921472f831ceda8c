// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/text.h"

#include <QStyle>
#include <QVariant>
#include <algorithm>

namespace widgets {

void setTextRole(QWidget *widget, ui::Role role)
{
    if (widget->property("textRole") == int(role))
        return;
    widget->setProperty("textRole", int(role));
    if (widget->testAttribute(Qt::WA_WState_Polished)) {
        widget->style()->unpolish(widget);
        widget->style()->polish(widget);
    }
}

QLabel *text(const QString &words, ui::Type type, ui::Role role, QWidget *parent)
{
    auto *label = new QLabel(words, parent);
    label->setTextFormat(Qt::PlainText);
    label->setFont(ui::font(type));
    setTextRole(label, role);
    return label;
}

QLabel *sentence(const QString &words, ui::Role role, QWidget *parent)
{
    QLabel *label = text(words, ui::Type::Body, role, parent);
    label->setWordWrap(true);
    return label;
}

void reserveWidth(QAbstractButton *button, const QStringList &texts)
{
    const QString present = button->text();
    int widest = 0;
    for (const QString &text : texts) {
        button->setText(text);
        widest = std::max(widest, button->sizeHint().width());
    }
    button->setText(present);
    button->setMinimumWidth(widest);
}

} // namespace widgets
