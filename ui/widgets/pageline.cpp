// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/pageline.h"

#include "ui/widgets/text.h"
#include <QHBoxLayout>

namespace widgets {

PageLine::PageLine(QWidget *parent)
    : QWidget(parent),
      m_name {text({}, ui::Type::PageName, ui::Role::Text1)},
      m_subject {new Line(ui::Role::Text2, ui::Type::Body)},
      m_tools {new QHBoxLayout}
{
    setObjectName(QStringLiteral("pageLine"));
    setFixedHeight(ui::space::pageLine);
    m_name->setObjectName(QStringLiteral("pageName"));
    m_subject->setObjectName(QStringLiteral("pageSubject"));
    m_tools->setSpacing(8);
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(ui::space::page, 0, ui::space::page, 0);
    row->setSpacing(ui::space::gap);
    row->addWidget(m_name);
    row->addWidget(m_subject, 1);
    row->addLayout(m_tools);
}

void PageLine::setName(const QString &name) { m_name->setText(name); }

void PageLine::setSubject(const Shown &subject) { m_subject->show(subject); }

void PageLine::addTool(QWidget *tool) { m_tools->addWidget(tool); }

} // namespace widgets
