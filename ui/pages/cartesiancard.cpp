// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/cartesiancard.h"

#include "ui/widgets/plottable.h"
#include "ui/widgets/rows.h"
#include "ui/widgets/valuegrid.h"
#include "ui/widgets/valuelabel.h"
#include "ui/words.h"

namespace pages {

using robot::Kind;

namespace {

enum CartesianColumn { CartesianNow, CartesianLowest, CartesianHighest };
enum FormRow { Form, ExtendedForm };

QList<widgets::ValueColumn> cartesianColumns()
{
    const QString reserve = ui::millimetres(-8888888);
    return {{QStringLiteral("cartesian"), CartesianCard::tr("now"), reserve, ui::Type::Position},
        {QStringLiteral("cartesianMin"), CartesianCard::tr("min"), reserve, ui::Type::Body, ui::Role::Text2},
        {QStringLiteral("cartesianMax"), CartesianCard::tr("max"), reserve, ui::Type::Body, ui::Role::Text2}};
}

} // namespace

CartesianCard::CartesianCard(const robot::RobotState &state, QWidget *parent)
    : GroupCard(tr("Tool point"), state, parent),
      m_grid {new widgets::ValueGrid(cartesianColumns(), values::maxAxes)},
      m_form {new widgets::Rows(Qt::AlignLeft)}
{
    m_form->add(QStringLiteral("form"), tr("Form"));
    m_form->add(QStringLiteral("extendedForm"), tr("Extended form"));
    body()->addWidget(m_grid);
    body()->addWidget(m_form);
    body()->addStretch();
}

quint16 CartesianCard::positionInstance() const { return group().instance <= 8 ? quint16(100 + group().instance) : 0; }

void CartesianCard::onChanged(const robot::TopicRange &range)
{
    if (range.contains(positionTopic()))
        showPosition();
    if (range.contains({Kind::AxisNames, positionInstance()}))
        nameRows(*m_grid, true);
}

void CartesianCard::showAll()
{
    nameRows(*m_grid, true);
    for (int axis = 0; axis < values::maxAxes; ++axis)
        widgets::setSignal(m_grid->value(axis, CartesianNow), trend::Signal {positionTopic(), quint16(axis)});
    showPosition();
}

void CartesianCard::showPosition()
{
    const auto freshness = m_state.freshness(positionTopic());
    for (int axis = 0; axis < values::maxAxes; ++axis) {
        m_grid->show(axis, CartesianNow, widgets::shown(position(), freshness, [axis](const values::Position &p) {
            return widgets::Word {axis < p.axes.count() ? ui::axisText(p.type, axis, p.axes[axis]) : widgets::dash()};
        }));
    }
    m_grid->setRowCount(axisCount());
    showExtremes(*m_grid, CartesianLowest);
    showForm();
    const QString name = values::toString(group());
    setNote(position().value ? tr("%1 · base frame, tool %2").arg(name).arg(position().value->tool)
                             : tr("%1 · base frame").arg(name));
    if (positionInstance() == 0)
        setReason(tr("%1 has no tool point: HSES tells it of robots only.").arg(name));
    else
        setReason(freshness == robot::Freshness::Refused ? m_grid->value(0, CartesianNow)->shown().note : QString());
}

void CartesianCard::showForm()
{
    const auto freshness = m_state.freshness(positionTopic());
    m_form->show(Form, widgets::shown(position(), freshness, [](const values::Position &p) {
        return widgets::Word {ui::formText(p.form, p.axes.count() > 6)};
    }));
    m_form->show(ExtendedForm, widgets::shown(position(), freshness, [](const values::Position &p) {
        return widgets::Word {ui::extendedFormText(p.extendedForm)};
    }));
}

QString CartesianCard::toText() const
{
    if (positionInstance() == 0 || !position().value)
        return {};
    return tr("%1, base frame, tool %2").arg(values::toString(group())).arg(position().value->tool) + u'\n'
        + m_grid->toText() + u'\n' + m_form->toText();
}

} // namespace pages
