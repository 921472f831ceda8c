// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/iowrite.h"
#include "ui/widgets/dialogsheet.h"

class QLabel;

namespace widgets {
class OrderButton;
}

namespace dialogs {

/// Switches one network input: shows the eight signals that travel together, before and after, writes once and shows
/// what was read back.
class IoWriteDialog : public widgets::DialogSheet
{
    Q_OBJECT

public:
    /// `orders` must outlive the dialog; `name` may be empty.
    IoWriteDialog(robot::Orders &orders, const names::Signal &signal, const QString &name, QWidget *parent);

private:
    void showStep();
    [[nodiscard]] QString sentence() const;

    protocol::Model m_model;
    robot::IoWrite m_write;
    QLabel *m_before;
    QLabel *m_after;
    QLabel *m_sentence;
    widgets::OrderButton *m_button;
};

} // namespace dialogs
