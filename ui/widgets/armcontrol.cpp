// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/armcontrol.h"

#include "ui/conditionwords.h"
#include "ui/dialogs/whynotdialog.h"
#include "ui/widgets/flow.h"
#include "ui/widgets/line.h"
#include "ui/widgets/tickbox.h"
#include <QCheckBox>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

using namespace std::chrono_literals;
using robot::Act;

namespace widgets {

ArmControl::ArmControl(robot::Orders &orders, QWidget *parent)
    : QWidget(parent),
      m_orders {orders},
      m_arm {new QPushButton(tr("Hold for 1 s to arm"))},
      m_why {new QPushButton(tr("Why not?"))},
      m_disarm {new QPushButton(tr("Disarm"))},
      m_reason {new Line(ui::Role::Text2)}
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    addBox("armNobody", tr("Nobody is inside the fence"));
    addBox("armSight", tr("I see the robot, or somebody who does"));
    addBox("armStop", tr("An emergency stop is within reach there"));
    m_arm->setObjectName(QStringLiteral("arm"));
    m_why->setObjectName(QStringLiteral("why-arm"));
    m_why->setProperty("link", true);
    m_disarm->setObjectName(QStringLiteral("disarm"));
    m_reason->setObjectName(QStringLiteral("reason-arm"));
    keepRoom(m_why);
    auto *row = new Flow;
    for (QPushButton *button : {m_arm, m_disarm, m_why}) {
        button->setAutoDefault(false);
        row->addWidget(button);
    }
    column->addLayout(row);
    column->addWidget(m_reason);
    m_hold.setSingleShot(true);
    m_hold.setInterval(1s);
    connect(m_arm, &QPushButton::pressed, &m_hold, qOverload<>(&QTimer::start));
    connect(m_arm, &QPushButton::released, &m_hold, &QTimer::stop);
    connect(&m_hold, &QTimer::timeout, this, &ArmControl::onHeld);
    connect(m_disarm, &QPushButton::clicked, this, [this] { m_orders.arming().drop(robot::Arming::Drop::ByHand); });
    connect(
        m_why, &QPushButton::clicked, this, [this] { (new dialogs::WhyNotDialog(m_orders, Act::Arm, this))->show(); });
    connect(&orders, &robot::Orders::situationChanged, this, &ArmControl::showState);
    connect(&orders.arming(), &robot::Arming::changed, this, &ArmControl::showState);
    showState();
}

void ArmControl::addBox(const char *name, const QString &text)
{
    auto *box = new TickBox(text);
    box->setObjectName(QLatin1String(name));
    layout()->addWidget(box);
    connect(box, &QCheckBox::toggled, this, &ArmControl::showState);
    m_boxes << box;
}

bool ArmControl::isTicked() const
{
    return std::ranges::all_of(m_boxes, [](const QCheckBox *box) { return box->isChecked(); });
}

void ArmControl::onHeld()
{
    if (m_arm->isDown() && isTicked())
        m_orders.arm();
}

/// What was ticked holds for one arming only.
void ArmControl::showState()
{
    const bool isArmed = m_orders.isArmed();
    if (std::exchange(m_wasArmed, isArmed) && !isArmed) {
        for (QCheckBox *box : m_boxes)
            box->setChecked(false);
    }
    for (QCheckBox *box : m_boxes)
        box->setEnabled(!isArmed);
    const bool isPossible = !m_orders.obstacle(Act::Arm) && isTicked();
    m_arm->setEnabled(!isArmed && (isPossible || m_arm->isDown())); // while it is held, the end of the second decides
    m_disarm->setEnabled(isArmed);
    m_why->setVisible(!isArmed);
    m_why->setText(isPossible ? tr("Conditions") : tr("Why not?"));
    m_reason->setWords(reason());
}

QString ArmControl::reason() const
{
    if (m_orders.isArmed())
        return tr("Armed: start, servo on and moves are possible. It drops after a minute without key or mouse.");
    if (const auto obstacle = m_orders.obstacle(Act::Arm))
        return ui::reason(*obstacle, m_orders.controller().profile().model);
    if (const auto &drop = m_orders.lastDrop(); drop && !isTicked())
        return tr("Disarmed at %1: %2.").arg(drop->at.toString(u"HH:mm:ss"), ui::reason(drop->reason));
    return isTicked() ? QString() : tr("Tick all three first.");
}

} // namespace widgets
