// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/pages/jobs/ordercard.h"

class QLineEdit;

namespace pages {

/// What reaches the person at the pendant: a message, and HLOCK.
class PendantCard : public OrderCard
{
    Q_OBJECT

public:
    explicit PendantCard(const Context &context, QWidget *parent = nullptr);

private:
    void onEdited();
    void showText();
    void showLock();

    QLineEdit *m_text;
    QLabel *m_counter;
    widgets::OrderButton *m_show;
    QLabel *m_lock;
    widgets::OrderButton *m_lockOn;
    widgets::OrderButton *m_lockOff;
};

} // namespace pages
