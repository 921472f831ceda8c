// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/orderbutton.h"

#include "ui/conditionwords.h"
#include "ui/dialogs/whynotdialog.h"
#include "ui/widgets/dialogsheet.h"
#include "ui/widgets/flow.h"
#include "ui/widgets/line.h"
#include "ui/widgets/text.h"
#include <QPushButton>
#include <QVBoxLayout>

using namespace std::chrono_literals;

namespace widgets {

namespace {

constexpr auto longestWait = 10s; ///< Servo power may take 8 s (reference §11).

} // namespace

OrderButton::OrderButton(robot::Orders &orders, robot::Act act, Reason place, QWidget *parent)
    : QWidget(parent),
      m_orders {orders},
      m_act {act},
      m_button {new QPushButton},
      m_why {new QPushButton},
      m_reason {new Line(ui::Role::Text2)}
{
    const auto name = QLatin1String(robot::key(act));
    m_button->setObjectName(name);
    writing(m_button);
    m_why->setObjectName(QLatin1String("why-") + name);
    m_why->setAutoDefault(false);
    m_why->setProperty("link", true);
    m_reason->setObjectName(QLatin1String("reason-") + name);
    auto *row = new Flow;
    row->setSpacing(4);
    row->addWidget(m_button);
    row->addWidget(m_why);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addLayout(row);
    column->addWidget(m_reason);
    m_reason->setVisible(place == Reason::Below);
    const bool hasConditions = !orders.findings(act).isEmpty();
    if (hasConditions)
        keepRoom(m_why);
    reserveWidth(m_why, {tr("Why not?"), tr("Conditions")});
    m_why->setVisible(hasConditions); // not before it has a parent: it would be a window
    m_patience.setSingleShot(true);
    connect(m_button, &QPushButton::clicked, this, &OrderButton::clicked);
    connect(m_why, &QPushButton::clicked, this, &OrderButton::openConditions);
    connect(&m_patience, &QTimer::timeout, this, &OrderButton::stopExpecting);
    connect(&orders, &robot::Orders::situationChanged, this, &OrderButton::update);
    setText(ui::title(act));
    update();
}

void OrderButton::setText(const QString &text)
{
    m_button->setText(text);
    m_why->setAccessibleName(tr("Conditions of: %1").arg(text));
}

void OrderButton::setComplaint(const QString &complaint)
{
    m_complaint = complaint;
    update();
}

void OrderButton::expect(Agrees agrees)
{
    m_agrees = std::move(agrees);
    m_patience.start(longestWait);
    update();
}

void OrderButton::stopExpecting()
{
    m_agrees = {};
    m_patience.stop();
    update();
}

void OrderButton::update()
{
    if (m_agrees && m_agrees(m_orders.situation()))
        return stopExpecting();
    const auto obstacle = m_orders.obstacle(m_act);
    const QString reason = m_agrees ? tr("Pending…")
        : obstacle                  ? ui::reason(*obstacle, m_orders.controller().profile().model)
                                    : m_complaint;
    setPressable(reason.isEmpty());
    m_button->setToolTip(reason);
    m_button->setAccessibleDescription(reason);
    m_why->setText(obstacle ? tr("Why not?") : tr("Conditions"));
    m_reason->setWords(reason);
}

/// A button that cannot be pressed cannot have the focus: this keeps its place meanwhile.
void OrderButton::setPressable(bool isPressable)
{
    if (!isPressable && m_button->hasFocus())
        setFocus(Qt::OtherFocusReason);
    m_button->setEnabled(isPressable);
    if (isPressable && hasFocus())
        m_button->setFocus(Qt::OtherFocusReason);
}

void OrderButton::openConditions()
{
    auto *dialog = new dialogs::WhyNotDialog(m_orders, m_act, this);
    dialog->show();
}

} // namespace widgets
