// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/start/setupcard.h"

#include "protocol/packet.h"
#include "ui/conditionwords.h"
#include <QHBoxLayout>

namespace pages::start {

SetupCard::SetupCard(protocol::Model model, QWidget *parent) : Card(tr("What must be set on the pendant"), parent)
{
    using robot::Condition;
    setObjectName(QStringLiteral("setupCard"));
    setNote(tr("Menus differ by model and software"));
    body()->setSpacing(8);
    addStep(tr("To be found"),
        tr("The Ethernet server function (HSES) is on; it is an option of DX100, DX200 and FS100. The controller has "
           "an "
           "IPv4 address in the network of this computer, and no firewall between them drops UDP %1 and %2.")
            .arg(protocol::robotPort)
            .arg(protocol::filePort));
    addStep(tr("To take orders"),
        tr("Only for starting, moving, resetting and files, not for reading: %1.")
            .arg(ui::remedy(Condition::Remote, model)));
    addStep(tr("To select and replace"),
        tr("For selecting jobs from here: %1. For replacing files that exist there: %2.")
            .arg(ui::remedy(Condition::JobSelectPermitted, model), ui::remedy(Condition::OverwritePermitted, model)));
}

void SetupCard::addStep(const QString &title, const QString &sentence)
{
    auto *number = widgets::text(QString::number(++m_steps), ui::Type::State, ui::Role::Text2);
    number->setMinimumWidth(20);
    auto *words = new QVBoxLayout;
    words->setSpacing(1);
    words->addWidget(widgets::text(title, ui::Type::Heading, ui::Role::Text1));
    words->addWidget(widgets::sentence(sentence, ui::Role::Text2));
    auto *row = new QHBoxLayout;
    row->setSpacing(10);
    row->addWidget(number, 0, Qt::AlignTop);
    row->addLayout(words, 1);
    body()->addLayout(row);
}

} // namespace pages::start
