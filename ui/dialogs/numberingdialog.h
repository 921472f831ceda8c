// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/numbering.h"
#include "ui/widgets/dialogsheet.h"

class QLabel;
class QPushButton;
class QSpinBox;

namespace dialogs {

/// The guided test of the variable numbering (RS022): the person reads two B variables on the pendant, Pendesk compares
/// them with what stands on the wire. It only reads.
class NumberingDialog : public widgets::DialogSheet
{
    Q_OBJECT

public:
    /// `orders` must outlive the dialog.
    NumberingDialog(robot::Orders &orders, QWidget *parent);

Q_SIGNALS:
    /// The test told the numbering, and the person accepted the result.
    void verified(protocol::Numbering numbering);

private:
    void read(void (NumberingDialog::*then)());
    void propose();
    void judge();
    void say(const QString &sentence, bool isTrouble);

    robot::Orders &m_orders;
    QList<values::ByteVariable> m_instances;
    std::array<QSpinBox *, 2> m_numbers;
    std::array<QSpinBox *, 2> m_values;
    QLabel *m_sentence;
    QPushButton *m_compare;
    QPushButton *m_accept;
    std::optional<protocol::Numbering> m_result;
};

} // namespace dialogs
