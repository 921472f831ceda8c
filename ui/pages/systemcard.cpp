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

SystemCard::SystemCard(const robot::RobotState &state, protocol::Model expected, QWidget *parent)
    : Card(tr("System"), parent), m_state {state}, m_expected {expected}, m_rows {new widgets::Rows(Qt::AlignLeft)}
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
    onChanged(robot::topics::systemInformation);
}

void SystemCard::onChanged(const robot::TopicRange &range)
{
    if (!range.contains(robot::topics::systemInformation))
        return;
    const auto freshness = m_state.freshness(robot::topics::systemInformation);
    int row = 0;
    for (const auto word : {model, software, parameters})
        m_rows->show(row++, widgets::shown(m_state.systemInformation(), freshness, word));
    setReason(reason());
}

QString SystemCard::reason() const
{
    const auto &reading = m_state.systemInformation();
    if (reading.refusal)
        return widgets::refused(*reading.refusal).note;
    const auto told = reading.value ? protocol::modelOfSoftware(reading.value->software.bytes()) : std::nullopt;
    if (!told || *told == m_expected)
        return {};
    return tr("The profile says %1, but this is the software of a %2: correct the profile.")
        .arg(QLatin1String(protocol::dialect(m_expected).name), QLatin1String(protocol::dialect(*told).name));
}

void SystemCard::copy() const { QGuiApplication::clipboard()->setText(m_rows->toText()); }

} // namespace pages
