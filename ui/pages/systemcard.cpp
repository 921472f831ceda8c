// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/systemcard.h"

#include "ui/widgets/rows.h"
#include "ui/words.h"
#include <QClipboard>
#include <QGuiApplication>
#include <QPushButton>

namespace pages {

namespace {

using values::SystemInformation;

widgets::Word model(const SystemInformation &system) { return {ui::controllerText(system.model.bytes())}; }
widgets::Word software(const SystemInformation &system) { return {ui::controllerText(system.software.bytes())}; }
widgets::Word parameters(const SystemInformation &system) { return {ui::controllerText(system.parameters.bytes())}; }

} // namespace

SystemCard::SystemCard(const robot::RobotState &state, QWidget *parent)
    : Card(tr("System"), parent), m_state {state}, m_rows {new widgets::Rows(Qt::AlignLeft)}
{
    m_rows->add(QStringLiteral("model"), tr("Model"));
    m_rows->add(QStringLiteral("software"), tr("Software"));
    m_rows->add(QStringLiteral("parameters"), tr("Parameters"));
    auto *button = new QPushButton(tr("Copy"));
    button->setObjectName(QStringLiteral("copySystem"));
    button->setAccessibleName(tr("Copy the system information"));
    body()->addWidget(m_rows);
    body()->addWidget(button, 0, Qt::AlignLeft);
    body()->addStretch();
    connect(button, &QPushButton::clicked, this, &SystemCard::copy);
    connect(&state, &robot::RobotState::changed, this, &SystemCard::onChanged);
    onChanged(robot::Topic::SystemInformation);
}

void SystemCard::onChanged(robot::Topic topic)
{
    if (topic != robot::Topic::SystemInformation)
        return;
    const auto freshness = m_state.freshness(topic);
    int row = 0;
    for (const auto word : {model, software, parameters})
        m_rows->show(row++, widgets::shown(m_state.systemInformation(), freshness, word));
    const auto &refusal = m_state.systemInformation().refusal;
    setReason(freshness == robot::Freshness::Refused && refusal ? widgets::refused(*refusal).note : QString());
}

void SystemCard::copy() const { QGuiApplication::clipboard()->setText(m_rows->toText()); }

} // namespace pages
