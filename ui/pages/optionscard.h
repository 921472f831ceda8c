// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/linkview.h"
#include "ui/widgets/card.h"

namespace pages {

/// "What can I do now?": each order that exists, whether it can be given, and why not.
class OptionsCard : public widgets::Card
{
    Q_OBJECT

public:
    explicit OptionsCard(QWidget *parent = nullptr);

    void showLink(const ui::LinkView &link);

private:
    QLabel *m_mark;
    QLabel *m_condition;
};

} // namespace pages
