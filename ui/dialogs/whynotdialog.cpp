// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/whynotdialog.h"

#include "ui/conditionwords.h"
#include "ui/widgets/conditionlist.h"
#include "ui/widgets/text.h"
#include <QDialogButtonBox>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace dialogs {

WhyNotDialog::WhyNotDialog(robot::Orders &orders, robot::Act act, QWidget *parent) : DialogSheet(parent)
{
    setObjectName(QStringLiteral("whyNotDialog"));
    setWindowTitle(tr("%1 · %2").arg(ui::title(act), orders.controller().profile().name));
    resize(460, 480);
    auto *scroll = new QScrollArea;
    scroll->setObjectName(QStringLiteral("conditions"));
    scroll->setAccessibleName(tr("Conditions"));
    scroll->setProperty("reads", true);
    scroll->setWidget(new widgets::ConditionList(orders, act));
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->button(QDialogButtonBox::Close)->setObjectName(QStringLiteral("closeButton"));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(ui::space::page, ui::space::page, ui::space::page, ui::space::page);
    column->addWidget(widgets::text(tr("What must be the case"), ui::Type::Heading, ui::Role::Text2));
    column->addWidget(scroll, 1);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
}

} // namespace dialogs
