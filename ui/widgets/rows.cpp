// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/rows.h"

#include "ui/widgets/text.h"
#include "ui/widgets/valuelabel.h"
#include <QGridLayout>

namespace widgets {

Rows::Rows(Qt::Alignment valueAlignment, QWidget *parent)
    : QWidget(parent), m_alignment {valueAlignment}, m_grid {new QGridLayout(this)}
{
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(ui::space::gap);
    m_grid->setVerticalSpacing(3);
    m_grid->setColumnStretch(valueAlignment & Qt::AlignRight ? 1 : 2, 1);
}

void Rows::add(const QString &name, const QString &title)
{
    auto *value = new ValueLabel(ui::Type::Body);
    value->setObjectName(name);
    value->setTitle(title);
    value->setAlignment(m_alignment | Qt::AlignVCenter);
    value->setTabular(true);
    const int row = int(m_values.size());
    m_grid->addWidget(text(title, ui::Type::Body, ui::Role::Text2), row, 0);
    m_grid->addWidget(value, row, 1);
    m_titles << title;
    m_values << value;
}

void Rows::show(int row, const Shown &shown) { m_values[row]->show(shown); }

void Rows::showText(int row, const QString &text) { show(row, {{text, Lamp::None}, robot::Freshness::Live, {}}); }

QString Rows::toText() const
{
    QStringList lines;
    for (qsizetype i = 0; i < m_values.size(); ++i)
        lines << tr("%1: %2").arg(m_titles[i], m_values[i]->shown().word.text);
    return lines.join(u'\n');
}

} // namespace widgets
