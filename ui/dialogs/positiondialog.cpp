// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/positiondialog.h"

#include "protocol/codes.h"
#include "ui/widgets/text.h"
#include "values/form.h"
#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

namespace dialogs {

using values::ControlGroup;
using values::Position;
using values::PositionType;
using values::Result;
using variables::Kind;

namespace {

constexpr int mostFrames = 63;
constexpr int firstFormRow = 3; ///< Under tool and frame and a heading.

QLabel *label(const QString &words) { return widgets::text(words, ui::Type::Label, ui::Role::Text2); }

QSpinBox *spin(const QString &name, const QString &title)
{
    auto *box = new QSpinBox;
    box->setRange(0, mostFrames);
    box->setObjectName(name);
    box->setAccessibleName(title);
    return box;
}

quint32 bitsOf(const QList<QComboBox *> &boxes)
{
    quint32 bits = 0;
    for (qsizetype bit = 0; bit < boxes.size(); ++bit)
        bits |= quint32(boxes[bit]->currentIndex() == 1) << bit;
    return bits;
}

void setBits(const QList<QComboBox *> &boxes, quint32 bits)
{
    for (qsizetype bit = 0; bit < boxes.size(); ++bit)
        boxes[bit]->setCurrentIndex(int(bits >> bit & 1));
}

} // namespace

PositionDialog::PositionDialog(robot::Orders &orders, const variables::Reference &variable,
    const std::optional<variables::Value> &value, const variables::Format &format, QWidget *parent)
    : DialogSheet(parent),
      m_orders {orders},
      m_variable {variable},
      m_format {format},
      m_type {new QComboBox},
      m_live {label({})},
      m_sentence {widgets::sentence({}, ui::Role::Amber)}
{
    setObjectName(QStringLiteral("positionDialog"));
    setWindowTitle(tr("%1 — %2").arg(toString(variable), orders.controller().profile().name));
    m_type->setObjectName(QStringLiteral("type"));
    m_type->setAccessibleName(tr("Type"));
    m_live->setObjectName(QStringLiteral("live"));
    m_sentence->setObjectName(QStringLiteral("sentence"));
    for (const PositionType one : variables::positionTypes(variable.kind))
        m_type->addItem(values::toString(one), quint32(one));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Cancel)->setObjectName(QStringLiteral("cancelButton"));
    m_stage = buttons->addButton(tr("Stage"), QDialogButtonBox::AcceptRole);
    m_stage->setObjectName(QStringLiteral("stageButton"));
    m_stage->setProperty("primary", true);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(ui::space::page, ui::space::page, ui::space::page, ui::space::page);
    column->setSpacing(ui::space::gap);
    column->addWidget(widgets::text(toString(variable), ui::Type::State, ui::Role::Text1));
    column->addWidget(m_live);
    auto *row = new QHBoxLayout;
    row->setSpacing(2 * ui::space::gap);
    row->addWidget(axisFields(), 1);
    row->addWidget(partFields(), 1);
    column->addLayout(row);
    column->addWidget(takeButtons());
    column->addWidget(m_sentence);
    column->addWidget(buttons);
    connect(m_type, &QComboBox::currentIndexChanged, this, &PositionDialog::onTypeChanged);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        if (const auto typed = position()) {
            accept();
            Q_EMIT valueAccepted(variables::valueWith(m_variable.kind, *typed));
        }
    });
    fill(value ? *variables::positionOf(*value) : Position {});
}

QWidget *PositionDialog::axisFields()
{
    auto *result = new QWidget;
    auto *grid = new QGridLayout(result);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(label(tr("Type")), 0, 0);
    grid->addWidget(m_type, 0, 1, 1, 2);
    for (int axis = 0; axis < values::maxAxes; ++axis) {
        m_names << widgets::text({}, ui::Type::Body, ui::Role::Text2);
        m_axes << new QLineEdit;
        m_units << widgets::text({}, ui::Type::Body, ui::Role::Text3);
        m_axes.last()->setObjectName(QStringLiteral("axis%1").arg(axis + 1));
        m_axes.last()->setAlignment(Qt::AlignRight);
        grid->addWidget(m_names.last(), axis + 1, 0);
        grid->addWidget(m_axes.last(), axis + 1, 1);
        grid->addWidget(m_units.last(), axis + 1, 2);
        connect(m_axes.last(), &QLineEdit::textChanged, this, &PositionDialog::judge);
    }
    grid->setRowStretch(values::maxAxes + 1, 1);
    return result;
}

void PositionDialog::addForm(QGridLayout *grid, std::span<const values::FormBit> bits, QList<QComboBox *> &boxes)
{
    const auto word = [](const char *text) { return QCoreApplication::translate("values", text); };
    const QString prefix = &boxes == &m_form ? QStringLiteral("form") : QStringLiteral("extended");
    for (const values::FormBit &bit : bits) {
        auto *box = new QComboBox;
        box->addItems({word(bit.off), word(bit.on)});
        box->setObjectName(prefix + QString::number(boxes.size()));
        box->setAccessibleName(tr("%1 or %2").arg(word(bit.off), word(bit.on)));
        boxes << box;
        const int row = firstFormRow + int(boxes.size() - 1);
        grid->addWidget(box, row, &boxes == &m_form ? 0 : 1);
    }
}

/// Tool, frame and form, which only P has.
QWidget *PositionDialog::partFields()
{
    auto *result = new QWidget;
    if (m_variable.kind != Kind::P)
        result->hide();
    auto *grid = new QGridLayout(result);
    grid->setContentsMargins(0, 0, 0, 0);
    m_tool = spin(QStringLiteral("tool"), tr("Tool"));
    m_frame = spin(QStringLiteral("frame"), tr("User frame"));
    grid->addWidget(label(tr("Tool")), 0, 0);
    grid->addWidget(label(tr("User frame")), 0, 1);
    grid->addWidget(m_tool, 1, 0);
    grid->addWidget(m_frame, 1, 1);
    grid->addWidget(label(tr("Form")), firstFormRow - 1, 0);
    grid->addWidget(label(tr("Extended form")), firstFormRow - 1, 1);
    addForm(grid, values::formBits(), m_form);
    addForm(grid, values::extendedFormBits(), m_extendedForm);
    grid->setRowStretch(grid->rowCount(), 1);
    return result;
}

QWidget *PositionDialog::takeButtons()
{
    auto *result = new QWidget;
    auto *row = new QHBoxLayout(result);
    row->setContentsMargins(0, 0, 0, 0);
    const auto add = [&](const char *name, const QString &words, ControlGroup group) {
        auto *button = new QPushButton(words);
        button->setObjectName(QLatin1String(name));
        button->setAutoDefault(false);
        connect(button, &QPushButton::clicked, this, [this, group] { take(group); });
        row->addWidget(button);
    };
    switch (m_variable.kind) {
    case Kind::P:
        add("takeBase", tr("Take the present position of R1 (base frame)"), ControlGroup::robotCartesian(1));
        add("takePulse", tr("Take R1 in pulses"), ControlGroup::robotPulse(1));
        break;
    case Kind::BP:
        add("takeBase", tr("Take the present position of B1 (base frame)"), ControlGroup::baseCartesian(1));
        add("takePulse", tr("Take B1 in pulses"), ControlGroup::basePulse(1));
        break;
    default: add("takePulse", tr("Take the present position of S1"), ControlGroup::stationPulse(1)); break;
    }
    row->addStretch();
    return result;
}

PositionType PositionDialog::type() const { return PositionType(m_type->currentData().toUInt()); }

void PositionDialog::showLive(const QString &text) { m_live->setText(tr("live: %1").arg(text)); }

void PositionDialog::fill(const Position &position)
{
    const int row = m_type->findData(quint32(position.type));
    m_type->setCurrentIndex(std::max(row, 0));
    m_tool->setValue(int(position.tool));
    m_frame->setValue(int(position.userFrame));
    setBits(m_form, position.form);
    setBits(m_extendedForm, position.extendedForm);
    for (int axis = 0; axis < values::maxAxes; ++axis) {
        const qint32 word = axis < position.axes.count() ? position.axes[axis] : 0;
        m_axes[axis]->setText(variables::axisText(word, axisUnit(type(), axis), m_format.locale));
    }
    onTypeChanged();
}

/// The numbers stay as they were typed, under other names and units.
void PositionDialog::onTypeChanged()
{
    const bool isPulse = type() == PositionType::Pulse;
    for (int axis = 0; axis < values::maxAxes; ++axis) {
        m_names[axis]->setText(variables::axisName(m_variable.kind, type(), axis));
        m_units[axis]->setText(variables::unitText(axisUnit(type(), axis)));
        m_axes[axis]->setAccessibleName(tr("%1 in %2").arg(m_names[axis]->text(), m_units[axis]->text()));
    }
    for (auto *box : m_form + m_extendedForm)
        box->setEnabled(!isPulse);
    m_frame->setEnabled(type() == PositionType::User);
    judge();
}

Result<Position> PositionDialog::position() const
{
    Position result;
    result.type = type();
    result.tool = quint32(m_tool->value());
    if (result.type == PositionType::User)
        result.userFrame = quint32(m_frame->value());
    if (result.type != PositionType::Pulse) {
        result.form = bitsOf(m_form);
        result.extendedForm = bitsOf(m_extendedForm);
    }
    result.axes.resize(values::maxAxes);
    for (int axis = 0; axis < values::maxAxes; ++axis) {
        const auto word = variables::axisFromText(m_axes[axis]->text(), axisUnit(result.type, axis));
        if (!word)
            return values::badInput(tr("%1: %2", "axis: reason").arg(m_names[axis]->text(), word.error().detail));
        result.axes[axis] = *word;
    }
    if (result.type == PositionType::User && result.userFrame == 0)
        return values::badInput(tr("A user-frame position needs a user frame from 1 to 63."));
    return result;
}

void PositionDialog::judge()
{
    if (m_axes.size() < values::maxAxes || !m_tool)
        return; // still being built
    const auto typed = position();
    const bool isFrame = type() == PositionType::User || type() == PositionType::Tool;
    m_sentence->setText(!typed ? typed.error().detail
            : isFrame ? tr("Sources disagree which code means user and which means tool frame: check on the pendant "
                           "before a job uses this position.")
                      : QString());
    m_stage->setEnabled(typed.has_value());
}

void PositionDialog::take(ControlGroup group)
{
    m_sentence->setText(tr("The position is being read…"));
    m_orders.read(protocol::ReadPosition {group}, this, [this](const Result<Position> &position) {
        if (position)
            fill(*position);
        else
            m_sentence->setText(tr("The position could not be read: %1.").arg(protocol::explain(position.error())));
    });
}

} // namespace dialogs
