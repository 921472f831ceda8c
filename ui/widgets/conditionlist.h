// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/orders.h"
#include <QWidget>

class QLabel;

namespace widgets {

class Line;

/// Every condition of an act, one under the other and followed live: ✓ met, ✗ not met with what helps, … not read yet,
/// ? cannot be read over HSES.
class ConditionList : public QWidget
{
    Q_OBJECT

public:
    /// `orders` must outlive the list.
    ConditionList(robot::Orders &orders, robot::Act act, QWidget *parent = nullptr);

private:
    struct Row {
        QLabel *mark;
        Line *words;
        QLabel *remedy;
    };

    void addRow();
    void showFindings();
    void showFinding(const Row &row, const robot::Finding &finding) const;

    robot::Orders &m_orders;
    robot::Act m_act;
    QList<Row> m_rows;
};

} // namespace widgets
