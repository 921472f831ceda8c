// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/pages/jobs/ordercard.h"

namespace widgets {
class StateField;
}

namespace pages {

/// Servo power: how it is, on (armed and confirmed) and off (always).
class ServoCard : public OrderCard
{
    Q_OBJECT

public:
    explicit ServoCard(const Context &context, QWidget *parent = nullptr);

private:
    void showStatus();
    void confirmOn();
    void switchOn();
    void switchOff();

    widgets::StateField *m_servo;
    widgets::OrderButton *m_on;
    widgets::OrderButton *m_off;
    QLabel *m_warning;
};

} // namespace pages
