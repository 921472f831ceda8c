// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/motion/pointsbar.h"

#include "protocol/codes.h"
#include "robot/motionorders.h"
#include "ui/widgets/line.h"
#include "ui/widgets/text.h"
#include <QGridLayout>
#include <QMenu>
#include <QPushButton>
#include <QSpinBox>

namespace pages {

using values::Position;
using values::PositionVariable;
using values::Result;
using variables::Reference;

namespace {

constexpr int historySize = 12;

QPushButton *button(const char *name, const QString &words)
{
    auto *result = new QPushButton(words);
    result->setObjectName(QLatin1String(name));
    result->setAutoDefault(false);
    return result;
}

} // namespace

PointsBar::PointsBar(const Context &context, QWidget *parent)
    : QWidget(parent),
      m_orders {context.station.orders},
      m_edits {context.station.edits},
      m_variable {new QSpinBox},
      m_menu {new QMenu(this)},
      m_note {new widgets::Line(ui::Role::Text2, ui::Type::Body)}
{
    auto *present = button("moveTakePresent", tr("Take the present position"));
    auto *take = button("moveTakeVariable", tr("Take P"));
    auto *history = button("moveHistory", tr("Earlier places"));
    auto *keepButton = button("moveKeep", tr("Keep the present position as P"));
    m_variable->setObjectName(QStringLiteral("moveVariable"));
    m_variable->setAccessibleName(tr("P variable"));
    m_variable->setRange(0, context.station.profile().dialect().positionVariables - 1);
    m_variable->setPrefix(QStringLiteral("P"));
    m_note->setObjectName(QStringLiteral("moveNote"));
    history->setMenu(m_menu);
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(present, 0, 0);
    grid->addWidget(history, 0, 1);
    grid->addWidget(m_variable, 0, 2);
    grid->addWidget(take, 0, 3);
    grid->addWidget(keepButton, 1, 0, 1, 4);
    grid->addWidget(m_note, 2, 0, 1, 4);
    connect(present, &QPushButton::clicked, this, &PointsBar::presentWanted);
    connect(take, &QPushButton::clicked, this, &PointsBar::takeVariable);
    connect(keepButton, &QPushButton::clicked, this, &PointsBar::keep);
    connect(m_menu, &QMenu::aboutToShow, this, &PointsBar::fillMenu);
    connect(&m_edits, &robot::Edits::applied, this, &PointsBar::onApplied);
}

void PointsBar::setFrame(values::PositionType frame, bool isAbsolute)
{
    m_frame = frame;
    m_isAbsolute = isAbsolute;
}

void PointsBar::remember(const Position &position)
{
    m_history.prepend({QDateTime::currentDateTime(), position});
    if (m_history.size() > historySize)
        m_history.removeLast();
}

void PointsBar::takeVariable()
{
    const Reference variable {variables::Kind::P, m_variable->value()};
    const auto numbering = m_orders.controller().profile().numbering;
    const protocol::ReadItem<PositionVariable> request {protocol::variableInstance(variable.number, numbering)};
    m_note->setWords(tr("%1 is being read…").arg(toString(variable)));
    m_orders.read(request, this, [this, variable](const Result<PositionVariable> &read) { onRead(variable, read); });
}

void PointsBar::onRead(const Reference &variable, const Result<PositionVariable> &read)
{
    const QString name = toString(variable);
    if (!read && protocol::isNotTaught(read.error())) {
        m_note->setWords(tr("%1 is not taught.").arg(name));
    } else if (!read) {
        m_note->setWords(tr("%1 could not be read: %2.").arg(name, protocol::explain(read.error())));
    } else if (read->position.type != m_frame || !m_isAbsolute) {
        m_note->setWords(tr("%1 is in another frame (%2): choose that frame and an absolute move to take it.")
                             .arg(name, values::toString(read->position.type)));
    } else {
        m_note->setWords(tr("The target is %1.").arg(name));
        Q_EMIT taken(read->position);
    }
}

void PointsBar::keep()
{
    if (!m_present) {
        m_note->setWords(tr("Only the present position of a robot can be kept, once it was read."));
        return;
    }
    const Reference variable {variables::Kind::P, m_variable->value()};
    if (m_edits.isApplying()) {
        m_note->setWords(tr("Other values are still being written."));
        return;
    }
    m_edits.stage(variable, variables::valueWith(variables::Kind::P, *m_present));
    if (!m_edits.staged().find(variable)) {
        m_note->setWords(tr("%1 holds this position already.").arg(toString(variable)));
        return;
    }
    m_keeping = variable;
    m_edits.apply({variable});
}

void PointsBar::onApplied()
{
    const auto variable = std::exchange(m_keeping, {});
    if (!variable)
        return;
    const auto *edit = m_edits.staged().find(*variable);
    const QString name = toString(*variable);
    if (!edit)
        m_note->setWords(tr("%1 was written and read back.").arg(name));
    else if (edit->error)
        m_note->setWords(tr("%1 was not verified: %2.").arg(name, protocol::explain(*edit->error)));
    else
        m_note->setWords(tr("%1 was written, but another value was read back.").arg(name));
    m_edits.discard(*variable);
}

void PointsBar::fillMenu()
{
    m_menu->clear();
    for (const Remembered &one : m_history) {
        if (one.position.type != m_frame || !m_isAbsolute)
            continue;
        const QString words = QStringLiteral("%1  %2").arg(
            QLocale().toString(one.at.time(), QStringLiteral("HH:mm:ss")), robot::toText(one.position));
        connect(m_menu->addAction(words), &QAction::triggered, this, [this, one] { Q_EMIT taken(one.position); });
    }
    if (m_menu->isEmpty())
        m_menu->addAction(tr("No move has begun in this frame yet"))->setEnabled(false);
}

} // namespace pages
