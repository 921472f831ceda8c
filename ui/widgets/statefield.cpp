// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/statefield.h"

#include <QVBoxLayout>

namespace widgets {

StateField::StateField(const QString &title, ui::Type type, QWidget *parent)
    : QWidget(parent), m_title {new Line(ui::Role::Text2)}, m_value {new ValueLabel(type)}
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(1);
    column->addStretch();
    column->addWidget(m_title);
    column->addWidget(m_value);
    column->addStretch();
    setTitle(title);
}

void StateField::setTitle(const QString &title)
{
    m_title->setWords(title);
    m_value->setTitle(title);
}

} // namespace widgets
