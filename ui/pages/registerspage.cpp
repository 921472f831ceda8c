// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/registerspage.h"

#include "ui/widgets/card.h"
#include <QComboBox>

namespace pages {

QList<variables::Reference> allOf(variables::Kind kind, const protocol::Dialect &dialect)
{
    QList<variables::Reference> result;
    for (int number = 0; number < countOf(kind, dialect); ++number)
        result << variables::Reference {kind, number};
    return result;
}

QWidget *sheetCard(QWidget *content)
{
    auto *card = new widgets::Card({});
    card->body()->addWidget(content);
    auto *result = new QWidget;
    auto *column = new QVBoxLayout(result);
    column->setContentsMargins(ui::space::page, 0, ui::space::page, ui::space::page);
    column->addWidget(card);
    return result;
}

RegistersPage::RegistersPage(const Context &context, QWidget *parent)
    : Page(context, parent),
      m_format {robot::formatOf(context.station.profile())},
      m_desk {context.station.state(), context.station.history, context.station.edits, context.station.names, m_format,
          context.station.profile().dialect()},
      m_model {new models::VariableModel(m_desk, allOf(variables::Kind::M, m_desk.dialect), this)},
      m_sheet {new VariableSheet(context, m_desk, robot::Act::WriteRegister)}
{
    auto *base = new QComboBox;
    base->setObjectName(QStringLiteral("base"));
    base->setAccessibleName(tr("How registers are written"));
    base->addItems({tr("Decimal"), tr("Signed"), tr("Hexadecimal"), tr("Binary")}); // in the order of Base
    m_sheet->addToHead(base);
    m_sheet->setNote(tr("M000 to M559 can be written; the others belong to the ladder."));
    m_sheet->show(m_model);
    setContent(sheetCard(m_sheet));
    connect(base, &QComboBox::currentIndexChanged, this, [this](int row) { choose(variables::Base(row)); });
    connect(m_sheet, &VariableSheet::topicsChanged, this, &Page::topicsChanged);
}

void RegistersPage::choose(variables::Base base)
{
    m_format.registerBase = base;
    m_model->formatChanged();
}

QList<robot::TopicRange> RegistersPage::topics() const { return m_sheet->topics(); }

} // namespace pages
