// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/pages/jobs/ordercard.h"

class QComboBox;

namespace widgets {
class StateField;
}

namespace pages {

/// The cycle mode: what was asked for beside what the status says.
class CycleCard : public OrderCard
{
    Q_OBJECT

public:
    explicit CycleCard(const Context &context, QWidget *parent = nullptr);

private:
    void showStatus();
    void request();

    widgets::StateField *m_actual;
    widgets::StateField *m_requested;
    QComboBox *m_choice;
    widgets::OrderButton *m_select;
};

} // namespace pages
