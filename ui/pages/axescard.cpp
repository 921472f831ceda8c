// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/axescard.h"

#include "ui/widgets/plottable.h"
#include "ui/widgets/valuegrid.h"
#include "ui/widgets/valuelabel.h"
#include "ui/words.h"
#include <QLocale>

namespace pages {

using robot::Freshness;
using robot::Kind;
using widgets::Word;

namespace {

enum AxisColumn { Pulses, Degrees, Following, Torque, Temperature, Lowest, Highest };

QList<widgets::ValueColumn> axisColumns()
{
    const QString pulses = ui::pulses(-8888888);
    const auto quiet = ui::Role::Text2;
    return {{QStringLiteral("axisPulse"), AxesCard::tr("pulses"), pulses},
        {QStringLiteral("axisDegree"), AxesCard::tr("degrees"), ui::degrees(-8888888)},
        {QStringLiteral("axisError"), AxesCard::tr("following error, pulses"), ui::pulses(-8888)},
        {QStringLiteral("axisTorque"), AxesCard::tr("torque, raw"), ui::pulses(-8888), ui::Type::Body, ui::Role::Text1,
            AxesCard::tr("As the controller sends it: the unit is stated nowhere.")},
        {QStringLiteral("axisTemperature"), AxesCard::tr("encoder, °C"), ui::pulses(888)},
        {QStringLiteral("axisMin"), AxesCard::tr("min"), pulses, ui::Type::Body, quiet},
        {QStringLiteral("axisMax"), AxesCard::tr("max"), pulses, ui::Type::Body, quiet}};
}

struct PlottedColumn {
    AxisColumn column;
    Kind kind;
};
constexpr PlottedColumn plotted[] {{Pulses, Kind::Position}, {Following, Kind::FollowingError}, {Torque, Kind::Torque},
    {Temperature, Kind::EncoderTemperatures}};

QString word(const values::AxisWords &axes, int axis)
{
    return axis < axes.count() ? ui::pulses(axes[axis]) : widgets::dash();
}

} // namespace

AxesCard::AxesCard(const robot::RobotState &state, const settings::Profile &profile, QWidget *parent)
    : GroupCard(tr("Axes"), state, parent),
      m_profile {profile},
      m_hasTemperatures {profile.dialect().hasTemperatures},
      m_grid {new widgets::ValueGrid(axisColumns(), values::maxAxes)},
      m_converters {widgets::sentence({}, ui::Role::Text2)}
{
    m_grid->setColumnVisible(Temperature, m_hasTemperatures);
    m_converters->setObjectName(QStringLiteral("converters"));
    body()->addWidget(m_grid);
    body()->addWidget(m_converters);
    body()->addStretch();
    m_converters->setVisible(m_hasTemperatures);
}

void AxesCard::onChanged(const robot::TopicRange &range)
{
    const auto concerns = [&](Kind kind) { return range.contains({kind, positionInstance()}); };
    if (concerns(Kind::Position))
        showPosition();
    else if (concerns(Kind::FollowingError))
        showErrors();
    else if (concerns(Kind::Torque))
        showTorques();
    else if (concerns(Kind::EncoderTemperatures))
        showTemperatures();
    else if (concerns(Kind::AxisNames))
        nameRows(*m_grid, false);
    else if (range.kind == Kind::ConverterTemperature)
        showConverters();
}

void AxesCard::showAll()
{
    nameRows(*m_grid, false);
    for (const auto &[column, kind] : plotted) {
        for (int axis = 0; axis < values::maxAxes; ++axis)
            widgets::setSignal(m_grid->value(axis, column), trend::Signal {{kind, positionInstance()}, quint16(axis)});
    }
    setNote(values::toString(group()));
    showPosition();
    showErrors();
    showTorques();
    showTemperatures();
    showConverters();
}

template <Kind kind, typename Text> void AxesCard::showColumn(int column, Text text)
{
    const auto &reading = m_state.reading<kind>(positionInstance());
    const auto freshness = m_state.freshness({kind, positionInstance()});
    for (int axis = 0; axis < values::maxAxes; ++axis)
        m_grid->show(axis, column,
            widgets::shown(reading, freshness, [&](const auto &value) { return Word {text(value, axis)}; }));
}

double AxesCard::pulsesPerDegree(int axis) const
{
    const auto found = m_profile.pulsesPerDegree.find(group().instance);
    return found == m_profile.pulsesPerDegree.end() ? 0 : found->second[std::size_t(axis)];
}

void AxesCard::showPosition()
{
    showColumn<Kind::Position>(Pulses, [](const values::Position &p, int axis) { return word(p.axes, axis); });
    showColumn<Kind::Position>(Degrees, [this](const values::Position &p, int axis) {
        const double factor = pulsesPerDegree(axis);
        return axis < p.axes.count() && factor != 0 ? QLocale().toString(p.axes[axis] / factor, 'f', 4)
                                                    : widgets::dash();
    });
    m_grid->setColumnVisible(Degrees, m_profile.pulsesPerDegree.contains(group().instance));
    m_grid->setRowCount(axisCount());
    showExtremes(*m_grid, Lowest);
    showReason();
}

void AxesCard::showErrors()
{
    showColumn<Kind::FollowingError>(
        Following, [](const values::FollowingError &e, int axis) { return word(e.axes, axis); });
    showReason();
}

void AxesCard::showTorques()
{
    showColumn<Kind::Torque>(Torque, [](const values::Torque &t, int axis) { return word(t.axes, axis); });
    showReason();
}

void AxesCard::showTemperatures()
{
    showColumn<Kind::EncoderTemperatures>(Temperature, [](const values::EncoderTemperatures &t, int axis) {
        return QLocale().toString(t.celsius[std::size_t(axis)]);
    });
    showReason();
}

/// One line for both servo boards; a board that is not there says nothing.
void AxesCard::showConverters()
{
    QStringList boards;
    for (int board = 1; board <= 2; ++board) {
        const auto &reading = m_state.reading<Kind::ConverterTemperature>(board);
        const auto freshness = m_state.freshness({Kind::ConverterTemperature, quint16(board)});
        if (reading.value && freshness == Freshness::Live)
            boards << tr("Converter %1: %2 °C").arg(board).arg(QLocale().toString(reading.value->celsius()));
        else if (reading.value)
            boards << tr("Converter %1: %2 °C, last seen %3")
                          .arg(board)
                          .arg(QLocale().toString(reading.value->celsius()), reading.clock.toString(u"HH:mm:ss"));
    }
    m_converters->setText(
        boards.isEmpty() ? tr("Converter temperature: %1").arg(widgets::dash()) : boards.join(QStringLiteral(" · ")));
}

/// The first column that is refused, and why.
void AxesCard::showReason()
{
    for (const auto &[column, kind] : plotted) {
        if (column == Temperature && !m_hasTemperatures)
            continue;
        if (m_state.freshness({kind, positionInstance()}) == Freshness::Refused)
            return setReason(m_grid->value(0, column)->shown().note);
    }
    setReason({});
}

QString AxesCard::toText() const
{
    if (!position().value)
        return {};
    const QString text = values::toString(group()) + u'\n' + m_grid->toText();
    return m_hasTemperatures ? text + u'\n' + m_converters->text() : text;
}

} // namespace pages
