// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/orders.h"
#include "ui/linkview.h"
#include "ui/widgets/card.h"

class QGridLayout;

namespace pages {

/// "What can I do now?": what people order most, whether it can be ordered, and the first reason why not.
class OptionsCard : public widgets::Card
{
    Q_OBJECT

public:
    /// `orders` must outlive the card.
    explicit OptionsCard(robot::Orders &orders, QWidget *parent = nullptr);

    void showLink(const ui::LinkView &link);

private:
    struct Row {
        QLabel *mark;
        widgets::Line *reason;
    };

    Row addRow(QGridLayout *grid, const QString &name, const QString &title);
    void showRow(const Row &row, bool isPossible, const QString &reason) const;
    void showActs();

    robot::Orders &m_orders;
    Row m_hold;
    QList<Row> m_acts; ///< In the order of the table of acts.
};

} // namespace pages
