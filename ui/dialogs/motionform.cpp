// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/motionform.h"

#include "ui/widgets/tickbox.h"
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QScopedValueRollback>

namespace dialogs {

namespace {

constexpr double farAway = 100'000; ///< mm
constexpr char axes[] = "XYZ";

} // namespace

MotionForm::MotionForm(QWidget *parent)
    : QWidget(parent),
      m_hasBox {new widgets::TickBox(tr("The tool point must stay in this box (base frame, mm)"))},
      m_framesChecked {new widgets::TickBox(tr("User and tool frames were checked on this robot"))}
{
    using motion::Wishes;
    auto *form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    addLimit(form, "limitToolSpeed", tr("Speed, mm/s"), motion::ceiling::toolSpeed, &Wishes::toolSpeed);
    addLimit(
        form, "limitRotationSpeed", tr("Rotation speed, °/s"), motion::ceiling::rotationSpeed, &Wishes::rotationSpeed);
    addLimit(form, "limitJointSpeed", tr("Joint speed, %"), motion::ceiling::jointSpeed, &Wishes::jointSpeed);
    addLimit(form, "limitStepLength", tr("Jog step, mm"), motion::ceiling::stepLength, &Wishes::stepLength);
    addLimit(form, "limitStepAngle", tr("Jog step, °"), motion::ceiling::stepAngle, &Wishes::stepAngle);
    addLimit(form, "limitStepPulses", tr("Jog step, pulses"), motion::ceiling::stepPulses, &Wishes::stepPulses);
    addBox(form);
    m_framesChecked->setObjectName(QStringLiteral("framesChecked"));
    m_framesChecked->setToolTip(
        tr("Descriptions disagree which code means the user and which the tool frame. Tick this only after a small "
           "move in both was watched at the robot."));
    form->addRow(m_framesChecked);
    connect(m_hasBox, &QCheckBox::toggled, this, &MotionForm::onEdited);
    connect(m_framesChecked, &QCheckBox::toggled, this, &MotionForm::onEdited);
}

void MotionForm::addLimit(
    QFormLayout *form, const char *name, const QString &label, double most, std::optional<double> motion::Wishes::*wish)
{
    auto *box = new QDoubleSpinBox;
    box->setObjectName(QLatin1String(name));
    box->setAccessibleName(label);
    box->setDecimals(1);
    box->setRange(0, most);
    box->setSpecialValueText(tr("%1, as the program").arg(locale().toString(most)));
    form->addRow(label, box);
    m_limits << Field {box, wish};
    connect(box, &QDoubleSpinBox::valueChanged, this, &MotionForm::onEdited);
}

QDoubleSpinBox *MotionForm::corner(const QString &name, const QString &title)
{
    auto *box = new QDoubleSpinBox;
    box->setObjectName(name);
    box->setAccessibleName(title);
    box->setDecimals(1);
    box->setRange(-farAway, farAway);
    connect(box, &QDoubleSpinBox::valueChanged, this, &MotionForm::onEdited);
    return box;
}

void MotionForm::addBox(QFormLayout *form)
{
    m_hasBox->setObjectName(QStringLiteral("hasBox"));
    form->addRow(m_hasBox);
    for (const char *axis = axes; *axis; ++axis) {
        const QChar letter = QLatin1Char(*axis);
        m_least << corner(QStringLiteral("boxLeast%1").arg(letter), tr("Least %1").arg(letter));
        m_most << corner(QStringLiteral("boxMost%1").arg(letter), tr("Most %1").arg(letter));
        auto *row = new QHBoxLayout;
        row->addWidget(m_least.last());
        row->addWidget(m_most.last());
        form->addRow(tr("%1 from, to").arg(letter), row);
    }
}

void MotionForm::onEdited()
{
    for (auto *box : m_least + m_most)
        box->setEnabled(m_hasBox->isChecked());
    if (m_isFilling)
        return;
    m_isEdited = true;
    Q_EMIT edited();
}

void MotionForm::setWishes(const motion::Wishes &wishes)
{
    const QScopedValueRollback filling(m_isFilling, true);
    m_original = wishes;
    m_isEdited = false;
    for (const Field &field : m_limits)
        field.box->setValue((wishes.*field.wish).value_or(0));
    const motion::Box box = wishes.box.value_or(motion::Box {});
    m_hasBox->setChecked(wishes.box.has_value());
    for (int axis = 0; axis < 3; ++axis) {
        m_least[axis]->setValue(box.least[std::size_t(axis)]);
        m_most[axis]->setValue(box.most[std::size_t(axis)]);
    }
    m_framesChecked->setChecked(wishes.areFramesChecked);
    onEdited();
}

motion::Wishes MotionForm::wishes() const
{
    if (!m_isEdited)
        return m_original;
    motion::Wishes wishes;
    for (const Field &field : m_limits) {
        if (field.box->value() > 0)
            wishes.*field.wish = field.box->value();
    }
    if (m_hasBox->isChecked()) {
        motion::Box box;
        for (int axis = 0; axis < 3; ++axis) {
            box.least[std::size_t(axis)] = m_least[axis]->value();
            box.most[std::size_t(axis)] = m_most[axis]->value();
        }
        wishes.box = box;
    }
    wishes.areFramesChecked = m_framesChecked->isChecked();
    return wishes;
}

} // namespace dialogs
