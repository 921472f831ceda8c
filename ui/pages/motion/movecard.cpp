// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/motion/movecard.h"

#include "robot/motionorders.h"
#include "ui/dialogs/movesheet.h"
#include "ui/pages/motion/pointsbar.h"
#include "ui/widgets/orderbutton.h"
#include "ui/words.h"
#include "variables/text.h"
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLineEdit>
#include <QSignalBlocker>

namespace pages {

using motion::Wish;
using robot::Kind;
using values::AxisWords;
using values::ControlGroup;
using values::Position;
using values::PositionType;
using values::Result;

namespace {

constexpr int mostFrames = 63;
constexpr int targetWidth = 140; ///< Pixels.

QLabel *label(const QString &words) { return widgets::text(words, ui::Type::Label, ui::Role::Text2); }

template <typename Widget> Widget *named(Widget *widget, const char *name, const QString &title)
{
    widget->setObjectName(QLatin1String(name));
    widget->setAccessibleName(title);
    return widget;
}

QSpinBox *spin(const char *name, const QString &title, int most)
{
    auto *box = named(new QSpinBox, name, title);
    box->setRange(0, most);
    return box;
}

/// A row above its field.
QHBoxLayout *fields(std::initializer_list<std::pair<QString, QWidget *>> parts)
{
    auto *row = new QHBoxLayout;
    row->setContentsMargins(0, 0, 0, 0);
    for (const auto &[title, widget] : parts) {
        auto *column = new QVBoxLayout;
        column->setSpacing(2);
        column->addWidget(label(title));
        column->addWidget(widget);
        row->addLayout(column);
    }
    return row;
}

QWidget *holding(QLayout *layout)
{
    auto *result = new QWidget;
    layout->setContentsMargins(0, 0, 0, 0);
    result->setLayout(layout);
    return result;
}

} // namespace

MoveCard::MoveCard(const Context &context, const Result<motion::Limits> &limits, QWidget *parent)
    : Card(tr("Move"), parent),
      m_orders {context.station.orders},
      m_state {context.station.state()},
      m_profile {context.station.profile()},
      m_limits {limits},
      m_how {named(new QComboBox, "moveType", tr("Type of the move"))},
      m_frame {named(new QComboBox, "moveFrame", tr("Frame of the target"))},
      m_tool {spin("moveTool", tr("Tool"), mostFrames)},
      m_userFrame {spin("moveUserFrame", tr("User frame"), mostFrames)},
      m_track {named(new QLineEdit, "moveTrack", tr("Base axes in mm"))},
      m_form {widgets::sentence({}, ui::Role::Text2)},
      m_points {new PointsBar(context)},
      m_move {new widgets::OrderButton(context.station.orders, robot::Act::Move)}
{
    m_form->setObjectName(QStringLiteral("moveForm"));
    m_move->setText(tr("Rehearse…"));
    for (QWidget *part : {choices(), axes(), static_cast<QWidget *>(m_form), speeds(), static_cast<QWidget *>(m_points),
             static_cast<QWidget *>(m_move)})
        body()->addWidget(part);
    body()->addStretch();
    connect(m_move, &widgets::OrderButton::clicked, this, &MoveCard::rehearse);
    connect(m_points, &PointsBar::presentWanted, this, &MoveCard::fillWithPresent);
    connect(m_points, &PointsBar::taken, this, &MoveCard::fill);
    connect(&m_state, &robot::RobotState::changed, this, [this](const robot::TopicRange &range) {
        if (range.kind != Kind::Position)
            return;
        if (m_rows.first().target->text().isEmpty())
            fillWithPresent(); // the first one that was read
        showRows();
    });
    onKindChanged();
}

QWidget *MoveCard::choices()
{
    m_how->addItems({tr("Joint"), tr("Straight"), tr("Straight, increment")});
    m_how->setCurrentIndex(int(Wish::How::Straight));
    m_frame->addItem(tr("Base frame"), quint32(PositionType::Base));
    m_frame->addItem(tr("Robot frame"), quint32(PositionType::Robot));
    m_frame->addItem(tr("User frame"), quint32(PositionType::User));
    m_frame->addItem(tr("Tool frame"), quint32(PositionType::Tool));
    m_frame->addItem(tr("Pulses"), quint32(PositionType::Pulse));
    connect(m_how, &QComboBox::currentIndexChanged, this, &MoveCard::onKindChanged);
    connect(m_frame, &QComboBox::currentIndexChanged, this, &MoveCard::onKindChanged);
    connect(m_tool, &QSpinBox::valueChanged, this, &MoveCard::judge);
    connect(m_userFrame, &QSpinBox::valueChanged, this, &MoveCard::judge);
    connect(m_track, &QLineEdit::textChanged, this, &MoveCard::judge);
    return holding(fields({{tr("Type"), m_how}, {tr("Frame"), m_frame}, {tr("Tool"), m_tool},
        {tr("User frame"), m_userFrame}, {tr("Base axes in mm"), m_track}}));
}

QWidget *MoveCard::axes()
{
    auto *grid = new QGridLayout;
    grid->setVerticalSpacing(2);
    int column = 1;
    for (const QString &head : {tr("now"), tr("target"), tr("change")})
        grid->addWidget(label(head), 0, column++, Qt::AlignRight);
    for (int axis = 0; axis < values::maxAxes; ++axis)
        addRow(grid, axis);
    const int widest = QFontMetrics(ui::font(ui::Type::Body)).horizontalAdvance(QStringLiteral("-99,999,999.9999"));
    for (const int numbers : {1, 3})
        grid->setColumnMinimumWidth(numbers, widest); // more digits move nothing
    grid->setColumnStretch(5, 1);
    grid->setHorizontalSpacing(12);
    return holding(grid);
}

void MoveCard::addRow(QGridLayout *grid, int axis)
{
    const Row row {widgets::text({}, ui::Type::Body, ui::Role::Text2),
        widgets::text({}, ui::Type::Body, ui::Role::Text1), new QLineEdit,
        widgets::text({}, ui::Type::Body, ui::Role::Text1), widgets::text({}, ui::Type::Body, ui::Role::Text3)};
    row.now->setObjectName(QStringLiteral("moveNow%1").arg(axis + 1));
    row.target->setObjectName(QStringLiteral("moveTarget%1").arg(axis + 1));
    row.target->setAlignment(Qt::AlignRight);
    row.target->setMaximumWidth(targetWidth);
    row.change->setObjectName(QStringLiteral("moveChange%1").arg(axis + 1));
    int column = 0;
    for (QWidget *cell : QWidgetList {row.name, row.now, row.target, row.change, row.unit}) {
        grid->addWidget(cell, axis + 1, column);
        if (column == 1 || column == 3)
            static_cast<QLabel *>(cell)->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        ++column;
    }
    connect(row.target, &QLineEdit::textChanged, this, &MoveCard::showRows);
    m_rows << row;
}

QDoubleSpinBox *MoveCard::speed(const char *name, const QString &title, double most, double usual)
{
    auto *box = named(new QDoubleSpinBox, name, title);
    box->setRange(0.1, most);
    box->setDecimals(1);
    box->setValue(std::min(usual, most));
    connect(box, &QDoubleSpinBox::valueChanged, this, &MoveCard::judge);
    return box;
}

QWidget *MoveCard::speeds()
{
    const motion::Limits limits = m_limits.value_or(motion::Limits {});
    const motion::Speeds usual;
    m_toolSpeed = speed("moveToolSpeed", tr("Speed in mm/s"), limits.toolSpeed, usual.tool);
    m_rotationSpeed = speed("moveRotationSpeed", tr("Rotation speed in °/s"), limits.rotationSpeed, usual.rotation);
    m_jointSpeed = speed("moveJointSpeed", tr("Joint speed in %"), limits.jointSpeed, usual.joint);
    return holding(fields({{tr("mm/s, at most %1").arg(QLocale().toString(limits.toolSpeed)), m_toolSpeed},
        {tr("°/s, at most %1").arg(QLocale().toString(limits.rotationSpeed)), m_rotationSpeed},
        {tr("% of joint speed, at most %1").arg(QLocale().toString(limits.jointSpeed)), m_jointSpeed}}));
}

PositionType MoveCard::frame() const { return PositionType(m_frame->currentData().toUInt()); }
Wish::How MoveCard::how() const { return Wish::How(m_how->currentIndex()); }

/// As it is read now, in what the target is told in.
std::optional<Position> MoveCard::here() const
{
    const auto group = frame() == PositionType::Pulse ? m_group : ControlGroup::robotCartesian(m_group.instance);
    return robot::presentOf(m_state, m_group).at(group);
}

int MoveCard::axisCount() const
{
    const auto position = here();
    return position ? position->axes.count() : frame() == PositionType::Pulse && m_group.instance > 10 ? 3 : 6;
}

void MoveCard::setGroup(ControlGroup group)
{
    m_group = group;
    const QSignalBlocker blocker(m_frame);
    if (group.instance > 8) {
        m_frame->setCurrentIndex(m_frame->findData(quint32(PositionType::Pulse)));
        m_how->setCurrentIndex(int(Wish::How::Joint));
    }
    m_frame->setEnabled(group.instance <= 8);
    m_how->setEnabled(group.instance <= 8);
    onKindChanged();
}

void MoveCard::onKindChanged()
{
    m_points->setFrame(frame(), how() != Wish::How::Increment);
    m_userFrame->setEnabled(frame() == PositionType::User);
    m_track->setEnabled(robot::presentOf(m_state, m_group).hasTrack && frame() != PositionType::Pulse);
    for (int axis = 0; axis < values::maxAxes; ++axis) {
        const auto unit = values::axisUnit(frame(), axis);
        const QString name = variables::axisName(variables::Kind::P, frame(), axis);
        m_rows[axis].name->setText(name);
        m_rows[axis].unit->setText(variables::unitText(unit));
        m_rows[axis].target->setAccessibleName(tr("Target of %1 in %2").arg(name, variables::unitText(unit)));
    }
    if (how() == Wish::How::Increment) {
        for (const Row &row : m_rows)
            row.target->setText(QStringLiteral("0"));
        showRows();
    } else {
        fillWithPresent();
    }
}

void MoveCard::fillWithPresent()
{
    if (const auto position = here())
        fill(*position);
    else
        showRows();
}

void MoveCard::fill(const Position &position)
{
    m_taken = position;
    m_tool->setValue(int(position.tool));
    for (int axis = 0; axis < values::maxAxes; ++axis) {
        const qint32 word = axis < position.axes.count() ? position.axes[axis] : 0;
        const QSignalBlocker blocker(m_rows[axis].target);
        m_rows[axis].target->setText(variables::axisText(word, values::axisUnit(frame(), axis), QLocale()));
    }
    showRows();
}

Result<AxisWords> MoveCard::typed() const
{
    AxisWords words;
    words.resize(axisCount());
    for (int axis = 0; axis < words.count(); ++axis) {
        const auto word = variables::axisFromText(m_rows[axis].target->text(), values::axisUnit(frame(), axis));
        if (!word)
            return values::badInput(tr("%1: %2", "axis: reason").arg(m_rows[axis].name->text(), word.error().detail));
        words[axis] = *word;
    }
    return words;
}

/// "1200; 0; 0": one number for each base axis.
Result<std::array<qint32, 3>> MoveCard::typedTrack() const
{
    const QStringList parts = m_track->text().split(u';');
    std::array<qint32, 3> words {};
    if (parts.size() > int(words.size()))
        return values::badInput(tr("There are three base axes at most."));
    for (qsizetype axis = 0; axis < parts.size(); ++axis) {
        const auto word = variables::axisFromText(parts[axis].trimmed(), values::AxisUnit::Micrometre);
        if (!word)
            return values::badInput(tr("Base axes: %1").arg(word.error().detail));
        words[std::size_t(axis)] = *word;
    }
    return words;
}

Result<motion::Plan> MoveCard::plan() const
{
    if (!m_limits)
        return values::badInput(
            tr("Off: the profile has a motion limit that is no number above 0 (%1).").arg(m_limits.error().detail));
    const auto axes = typed();
    if (!axes)
        return tl::unexpected(axes.error());
    Wish wish {m_group, how(), frame(), *axes, m_taken.form, m_taken.extendedForm, quint32(m_tool->value()),
        quint32(m_userFrame->value()), {}, {m_toolSpeed->value(), m_rotationSpeed->value(), m_jointSpeed->value()}};
    if (!m_track->text().isEmpty() && m_track->isEnabled()) {
        const auto track = typedTrack();
        if (!track)
            return tl::unexpected(track.error());
        wish.track = *track;
    }
    return motion::plan(wish, robot::presentOf(m_state, m_group), *m_limits);
}

void MoveCard::showRows()
{
    const auto position = here();
    const int count = axisCount();
    m_points->setKept(m_group.instance <= 8 ? position : std::nullopt);
    for (int axis = 0; axis < values::maxAxes; ++axis) {
        const Row &row = m_rows[axis];
        const auto unit = values::axisUnit(frame(), axis);
        for (QWidget *cell : QWidgetList {row.name, row.now, row.target, row.change, row.unit})
            cell->setVisible(axis < count);
        const auto word = variables::axisFromText(row.target->text(), unit);
        const bool isKnown = position && axis < position->axes.count();
        const bool isIncrement = how() == Wish::How::Increment;
        row.now->setText(isKnown ? variables::axisText(position->axes[axis], unit, QLocale()) : widgets::dash());
        row.change->setText(!word || (!isKnown && !isIncrement)
                ? widgets::dash()
                : variables::axisText(isIncrement ? *word : *word - position->axes[axis], unit, QLocale()));
    }
    const bool isPulse = frame() == PositionType::Pulse;
    m_form->setText(isPulse ? QString() : tr("Form: %1").arg(ui::formText(m_taken.form, count > 6)));
    m_form->setVisible(!isPulse);
    judge();
}

void MoveCard::judge()
{
    if (m_rows.size() < values::maxAxes || !m_jointSpeed)
        return; // still being built
    const auto made = plan();
    m_move->setComplaint(made ? QString() : made.error().detail);
}

void MoveCard::rehearse()
{
    const auto made = plan();
    if (!made)
        return judge();
    const auto present = robot::presentOf(m_state, m_group);
    if (const auto position = here())
        m_points->remember(*position);
    (new dialogs::MoveSheet(m_orders, *made, present, *m_limits, this))->show();
}

} // namespace pages
