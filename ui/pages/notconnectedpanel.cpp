// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/notconnectedpanel.h"

#include "ui/actioncatalog.h"
#include "ui/widgets/text.h"
#include <QHBoxLayout>
#include <QPushButton>

namespace pages {

namespace {

constexpr int widest = 620;

QPushButton *button(const QString &name, const QString &words, const QAction *action)
{
    auto *result = new QPushButton(words);
    result->setObjectName(name);
    result->setToolTip(action->shortcut().toString(QKeySequence::NativeText));
    QObject::connect(result, &QPushButton::clicked, action, &QAction::trigger);
    return result;
}

QLayout *buttons(const Context &context)
{
    const auto action = [&](ui::ActionId id) { return context.actions.action(id); };
    const bool hasProfile = !context.profile.host.isEmpty();
    auto *row = new QHBoxLayout;
    row->setSpacing(10);
    if (hasProfile)
        row->addWidget(button(QStringLiteral("reconnectButton"),
            NotConnectedPanel::tr("Connect to %1").arg(context.profile.name), action(ui::ActionId::Reconnect)));
    row->addWidget(button(QStringLiteral("connectButton"),
        hasProfile ? NotConnectedPanel::tr("Another controller…") : NotConnectedPanel::tr("Connect…"),
        action(ui::ActionId::Connect)));
    if (!context.profile.isSimulation)
        row->addWidget(
            button(QStringLiteral("demoButton"), NotConnectedPanel::tr("Open the demo"), action(ui::ActionId::Demo)));
    row->itemAt(0)->widget()->setProperty("primary", true);
    row->addStretch();
    return row;
}

} // namespace

NotConnectedPanel::NotConnectedPanel(const Context &context, QWidget *parent) : QWidget(parent)
{
    auto *inner = new QWidget;
    inner->setMaximumWidth(widest);
    auto *column = new QVBoxLayout(inner);
    column->setSpacing(12);
    column->addWidget(widgets::text(tr("Not connected"), ui::Type::Hold, ui::Role::Text1));
    column->addWidget(widgets::sentence(tr("Nothing is read and nothing is shown. Connect to a robot controller in "
                                           "your network by its name or address; "
                                           "its Ethernet server must be switched on."),
        ui::Role::Text2));
    column->addWidget(widgets::sentence(
        tr("Connecting only reads. Without a robot at hand, the demo brings its own simulated controller."),
        ui::Role::Text2));
    column->addSpacing(6);
    column->addLayout(buttons(context));
    auto *centre = new QVBoxLayout(this);
    centre->addStretch(2);
    auto *row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(inner, 4);
    row->addStretch(1);
    centre->addLayout(row);
    centre->addStretch(3);
}

} // namespace pages
