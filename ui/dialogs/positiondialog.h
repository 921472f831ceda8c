// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/orders.h"
#include "ui/widgets/dialogsheet.h"
#include "variables/text.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace dialogs {

/// Edits a P, BP or EX variable: type, axes in mm, degrees or pulses, and for P tool, user frame and the form in words.
/// What it gives is staged; only "take the present position" asks the controller, and that reads.
class PositionDialog : public widgets::DialogSheet
{
    Q_OBJECT

public:
    /// `orders` must outlive the dialog. `value` is what stands there now; nullopt if it was never taught or read.
    PositionDialog(robot::Orders &orders, const variables::Reference &variable,
        const std::optional<variables::Value> &value, const variables::Format &format, QWidget *parent);

    /// What is live while the dialog is open; it changes nothing that was typed.
    void showLive(const QString &text);

Q_SIGNALS:
    void valueAccepted(const variables::Value &value);

private:
    [[nodiscard]] QWidget *axisFields();
    [[nodiscard]] QWidget *partFields();
    [[nodiscard]] QWidget *takeButtons();
    void addForm(QGridLayout *grid, std::span<const values::FormBit> bits, QList<QComboBox *> &boxes);
    void fill(const values::Position &position);
    void onTypeChanged();
    void take(values::ControlGroup group);
    void judge();
    [[nodiscard]] values::PositionType type() const;
    /// What was typed; BadInput names the first axis that is no number.
    [[nodiscard]] values::Result<values::Position> position() const;

    robot::Orders &m_orders;
    variables::Reference m_variable;
    variables::Format m_format;
    QComboBox *m_type;
    QSpinBox *m_tool = nullptr;
    QSpinBox *m_frame = nullptr;
    QList<QLabel *> m_names;
    QList<QLineEdit *> m_axes;
    QList<QLabel *> m_units;
    QList<QComboBox *> m_form;
    QList<QComboBox *> m_extendedForm;
    QLabel *m_live;
    QLabel *m_sentence;
    QPushButton *m_stage;
};

} // namespace dialogs
