// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/movesheet.h"

#include "motion/geometry.h"
#include "ui/conditionwords.h"
#include "ui/widgets/line.h"
#include "ui/widgets/rows.h"
#include "ui/widgets/startbutton.h"
#include "ui/widgets/text.h"
#include "ui/words.h"
#include "variables/reference.h"
#include <QKeyEvent>
#include <QLineEdit>
#include <QVBoxLayout>

using namespace std::chrono_literals;
using motion::BoxCheck;
using robot::Act;
using robot::Kind;
using robot::Move;
using values::Position;
using values::PositionType;

namespace dialogs {

namespace {

enum Row { Controller, Group, From, To, Way, Time, Cap, Box, Near };
constexpr int nearestCount = 3;

QString number(double value, int decimals) { return QLocale().toString(value, 'f', decimals); }

/// "812.500, -12.001, 688.004 mm · 180.0000, 0.0000, 12.4410°", or pulses.
QString placeText(const Position &position)
{
    QStringList lengths;
    QStringList angles;
    for (int axis = 0; axis < position.axes.count(); ++axis) {
        const bool isAngle = values::axisUnit(position.type, axis) == values::AxisUnit::TenThousandthDegree;
        (isAngle ? angles : lengths) << ui::axisText(position.type, axis, position.axes[axis]);
    }
    if (position.type == PositionType::Pulse)
        return MoveSheet::tr("%1 pulses").arg(lengths.join(QStringLiteral("  ")));
    return MoveSheet::tr("%1 mm · %2°").arg(lengths.join(QStringLiteral("  ")), angles.join(QStringLiteral("  ")));
}

const values::Speed &speedOf(const motion::MoveOrder &order)
{
    return std::visit([](const auto &one) -> const values::Speed & { return one.target.speed; }, order);
}

values::ControlGroup groupOf(values::ControlGroup watched)
{
    return watched.isCartesian() ? values::ControlGroup::robotPulse(watched.instance - 100) : watched;
}

} // namespace

MoveSheet::MoveSheet(robot::Orders &orders, const motion::Plan &plan, const motion::Present &present,
    const motion::Limits &limits, QWidget *parent)
    : DialogSheet(parent),
      m_orders {orders},
      m_present {present},
      m_move {new Move(orders, plan, present, this)},
      m_rows {new widgets::Rows(Qt::AlignLeft)},
      m_reason {new widgets::Line(ui::Role::Amber, ui::Type::Body)},
      m_outcome {new widgets::Line(ui::Role::Text1, ui::Type::Body)},
      m_name {new QLineEdit},
      m_go {new widgets::StartButton(tr("Move"))},
      m_stop {new QPushButton(tr("Stop: HOLD"))},
      m_close {new QPushButton(tr("Cancel"))}
{
    setObjectName(QStringLiteral("moveSheet"));
    setWindowTitle(tr("Move at %1").arg(orders.controller().profile().name));
    setMinimumWidth(680); // a place in one line
    makeWidgets();
    showPlan(present, limits);
    const int points = orders.controller().profile().dialect().positionVariables;
    m_points = orders.controller().poller().wantOnce({robot::TopicRange(Kind::PositionVariable, 0, points - 1)});
    m_guard.setSingleShot(true);
    m_guard.setInterval(1s);
    m_guard.setTimerType(Qt::PreciseTimer);
    connect(&m_guard, &QTimer::timeout, this, [this] {
        m_isGuarded = false;
        update();
    });
    connect(m_go, &QPushButton::clicked, this, &MoveSheet::move);
    connect(m_stop, &QPushButton::clicked, this, [this] { m_orders.hold(); });
    connect(m_close, &QPushButton::clicked, this, &QDialog::close);
    connect(m_name, &QLineEdit::textChanged, this, &MoveSheet::update);
    connect(m_move, &Move::changed, this, &MoveSheet::showOutcome);
    connect(&orders, &robot::Orders::situationChanged, this, &MoveSheet::update);
    connect(&orders.controller().state(), &robot::RobotState::changed, this, [this](const robot::TopicRange &range) {
        if (range.kind == Kind::PositionVariable)
            showNearest();
        else if (range.kind == Kind::Position)
            update();
    });
    showNearest();
    update();
}

void MoveSheet::makeWidgets()
{
    m_rows->add(QStringLiteral("sheetController"), tr("Controller"));
    m_rows->add(QStringLiteral("sheetGroup"), tr("Control group"));
    m_rows->add(QStringLiteral("sheetFrom"), tr("From"));
    m_rows->add(QStringLiteral("sheetTo"), tr("To"));
    m_rows->add(QStringLiteral("sheetWay"), tr("Way"));
    m_rows->add(QStringLiteral("sheetTime"), tr("Time"));
    m_rows->add(QStringLiteral("sheetCap"), tr("Speed"));
    m_rows->add(QStringLiteral("sheetBox"), tr("Box"));
    m_rows->add(QStringLiteral("sheetNear"), tr("Stored points near the target"));
    m_reason->setObjectName(QStringLiteral("sheetReason"));
    m_outcome->setObjectName(QStringLiteral("sheetOutcome"));
    m_name->setObjectName(QStringLiteral("sheetName"));
    m_go->setObjectName(QStringLiteral("sheetMove"));
    m_stop->setObjectName(QStringLiteral("sheetStop"));
    m_close->setObjectName(QStringLiteral("sheetClose"));
    m_stop->setAutoDefault(false);
    widgets::reserveWidth(m_close, {tr("Cancel"), tr("Close")});
    m_close->setDefault(true);
    const QString name = m_orders.controller().profile().name;
    m_name->setPlaceholderText(m_move->plan().isLong()
            ? tr("A long move, or one that nobody can measure: type %1").arg(name)
            : tr("With the keyboard: type %1, then F9").arg(name));
    m_name->setAccessibleName(m_name->placeholderText());
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(m_stop);
    buttons->addWidget(widgets::text(tr("HOLD stays on until it is released"), ui::Type::Label, ui::Role::Text2));
    buttons->addStretch();
    buttons->addWidget(m_close);
    buttons->addWidget(m_go);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(ui::space::page, ui::space::page, ui::space::page, ui::space::page);
    column->setSpacing(10);
    column->addWidget(widgets::text(tr("The robot will move"), ui::Type::State, ui::Role::Text1));
    column->addWidget(m_rows);
    column->addWidget(m_name);
    column->addWidget(m_reason);
    column->addWidget(m_outcome);
    column->addLayout(buttons);
    m_close->setFocus();
}

void MoveSheet::showPlan(const motion::Present &present, const motion::Limits &limits)
{
    const motion::Plan &plan = m_move->plan();
    const auto &from = present.at(plan.watched);
    m_rows->showText(Controller, m_orders.controller().profile().name);
    m_rows->showText(Group, values::toString(groupOf(plan.watched)));
    m_rows->showText(From, from ? placeText(*from) : tr("not known"));
    m_rows->showText(To, plan.target ? placeText(*plan.target) : tr("cannot be foretold in this frame"));
    m_rows->showText(Way, wayText());
    m_rows->showText(Time,
        plan.time ? tr("about %1 s").arg(number(double(plan.time->count()) / 1000, 1))
                  : tr("not known: a percentage of joint speed"));
    m_rows->showText(Cap, capText(limits));
    m_rows->showText(Box, boxText());
}

QString MoveSheet::wayText() const
{
    const motion::Plan &plan = m_move->plan();
    if (!plan.length || !plan.angle)
        return tr("not known: the target is in pulses");
    const auto *cartesian = std::get_if<motion::CartesianOrder>(&plan.order);
    const bool isJoint = cartesian && cartesian->how == values::CartesianMove::JointAbsolute;
    const QString length = number(*plan.length, 1);
    const QString angle = number(*plan.angle, 1);
    return isJoint ? tr("%1 mm and %2° between the ends; a joint move does not go straight").arg(length, angle)
                   : tr("%1 mm straight, turning %2°").arg(length, angle);
}

QString MoveSheet::boxText() const
{
    switch (m_move->plan().box) {
    case BoxCheck::NoBox: return tr("none is set for this controller");
    case BoxCheck::WholeWay: return tr("the whole way is inside");
    case BoxCheck::BothEnds: return tr("both ends are inside; the way between is not known");
    }
    return {};
}

QString MoveSheet::capText(const motion::Limits &limits) const
{
    const values::Speed &speed = speedOf(m_move->plan().order);
    switch (speed.kind) {
    case values::SpeedClass::Percent: return tr("%1, at most %2 %").arg(speed.toString(), number(limits.jointSpeed, 1));
    case values::SpeedClass::ToolPoint:
        return tr("%1, at most %2 mm/s").arg(speed.toString(), number(limits.toolSpeed, 0));
    case values::SpeedClass::Rotation:
        return tr("%1, at most %2 °/s").arg(speed.toString(), number(limits.rotationSpeed, 0));
    }
    return speed.toString();
}

/// Points in the base frame that were read by now; others cannot be compared.
void MoveSheet::showNearest()
{
    const auto &target = m_move->plan().target;
    const auto to = target ? motion::poseOf(*target) : values::failure(values::ErrorKind::BadInput);
    if (!to)
        return m_rows->showText(Near, tr("cannot be compared"));
    std::multimap<double, int> near;
    const auto &state = m_orders.controller().state();
    const int count = m_orders.controller().profile().dialect().positionVariables;
    for (int number = 0; number < count; ++number) {
        const auto &point = state.reading<Kind::PositionVariable>(number).value;
        if (!point || point->position.type != PositionType::Base)
            continue;
        if (const auto pose = motion::poseOf(point->position))
            near.emplace(motion::distance(*pose, *to), number);
    }
    QStringList words;
    for (const auto &[distance, number] : near) {
        if (words.size() < nearestCount)
            words << tr("%1 at %2 mm")
                         .arg(toString(variables::Reference {variables::Kind::P, number}),
                             QLocale().toString(distance, 'f', 1));
    }
    m_rows->showText(Near, words.isEmpty() ? tr("none in the base frame was read") : words.join(QStringLiteral(" · ")));
}

bool MoveSheet::isNamed() const { return m_name->text() == m_orders.controller().profile().name; }

/// The robot is no longer where the plan begins, as far as it was read just now.
bool MoveSheet::hasMovedAway() const
{
    const auto watched = m_move->plan().watched;
    const auto present = robot::presentOf(m_orders.controller().state(), groupOf(watched));
    const auto &now = present.at(watched);
    return now && !isWherePlanned(*now);
}

bool MoveSheet::isWherePlanned(const Position &position) const
{
    const auto &planned = m_present.at(m_move->plan().watched);
    return planned && motion::isSamePlace(position, *planned);
}

void MoveSheet::update()
{
    if (m_isStarted)
        return;
    const auto obstacle = m_orders.obstacle(Act::Move);
    const bool isAway = !obstacle && hasMovedAway();
    m_reason->setWords(obstacle ? ui::reason(*obstacle, m_orders.controller().profile().model)
            : isAway            ? tr("The robot is no longer where this move begins: close, and rehearse again.")
                                : QString());
    const bool isPossible = !obstacle && !isAway;
    if (std::exchange(m_isPossible, isPossible) != isPossible) {
        m_isGuarded = true;
        if (isPossible)
            m_guard.start();
        else
            m_guard.stop();
    }
    m_go->setEnabled(isPossible && !m_isGuarded && (isNamed() || !m_move->plan().isLong()));
}

void MoveSheet::keyPressEvent(QKeyEvent *event)
{
    const bool isMove = event->key() == Qt::Key_F9 && event->modifiers() == Qt::NoModifier && !event->isAutoRepeat();
    if (!isMove)
        return QDialog::keyPressEvent(event);
    if (m_go->isEnabled() && isNamed())
        move();
}

/// The place is read once more, so that the move begins where it was rehearsed.
void MoveSheet::move()
{
    if (!m_go->isEnabled() || std::exchange(m_isStarted, true))
        return;
    m_go->setEnabled(false);
    m_orders.read(
        protocol::ReadPosition {m_move->plan().watched}, this,
        [this](const values::Result<Position> &position) { onPlace(position); }, session::Priority::Control);
}

void MoveSheet::onPlace(const values::Result<Position> &position)
{
    if (!position || !isWherePlanned(*position)) {
        m_isStarted = false;
        m_isPossible = false; // another second
        m_outcome->setWords(position ? QString() : tr("Not sent: the place could not be read."));
        return update();
    }
    m_name->setEnabled(false);
    m_reason->setWords({});
    m_close->setText(tr("Close"));
    m_move->start();
    showOutcome();
}

void MoveSheet::showOutcome()
{
    if (!m_isStarted)
        return;
    m_outcome->setWords(outcomeText());
    const auto outcome = m_move->outcome();
    const bool isFine = outcome == Move::Outcome::UnderWay || outcome == Move::Outcome::Arrived;
    m_outcome->setRole(isFine ? ui::Role::Text1 : ui::Role::Amber);
}

QString MoveSheet::outcomeText() const
{
    const auto position = m_move->position();
    const QString place = position ? placeText(*position) : tr("a place that was not read");
    switch (m_move->outcome()) {
    case Move::Outcome::UnderWay: return position ? tr("Under way: %1").arg(place) : tr("Move sent…");
    case Move::Outcome::Arrived: return tr("Arrived: %1").arg(place);
    case Move::Outcome::Stopped: return tr("Stopped at %1. That is not the target.").arg(place);
    case Move::Outcome::Rested:
        return tr("At rest at %1. Whether that is the target cannot be told in this frame.").arg(place);
    case Move::Outcome::Refused:
        return ui::explain(
            Act::Move, m_move->error().value_or(values::Error {}), m_orders.controller().profile().model);
    case Move::Outcome::Unknown: break;
    }
    return m_move->error()
        ? tr("No answer to the move: whether it was begun is unknown. It was sent once. Look at the robot.")
        : tr("The outcome is unknown: communication was lost, or it does not come to rest. Look at the robot.");
}

} // namespace dialogs
