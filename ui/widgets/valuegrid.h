// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/theme.h"
#include "ui/widgets/shown.h"
#include <QList>
#include <QWidget>

class QGridLayout;
class QLabel;

namespace widgets {

class ValueLabel;

/// What stands in one column of a ValueGrid.
struct ValueColumn {
    QString name; ///< objectName of the values, which the row's number from 1 follows: "pulse3".
    QString title;
    QString reserve; ///< The widest text that is usual.
    ui::Type type = ui::Type::Body;
    ui::Role role = ui::Role::Text1;
    QString toolTip = {}; ///< Of the head.
};

/// A table of values with a head: a row for each axis, a column for each thing that is read of it. Hairlines between
/// the rows.
class ValueGrid : public QWidget
{
    Q_OBJECT

public:
    ValueGrid(const QList<ValueColumn> &columns, int rows, QWidget *parent = nullptr);

    /// `unit` stands small behind the name; it may be empty.
    void setRowName(int row, const QString &name, const QString &unit = {});
    /// Rows from `count` on are hidden.
    void setRowCount(int count);
    void setColumnVisible(int column, bool isVisible);
    void show(int row, int column, const Shown &shown);
    using QWidget::show;
    [[nodiscard]] ValueLabel *value(int row, int column) const { return m_rows[row].values[column]; }
    /// The visible rows and columns, separated by tabs, with their heads.
    [[nodiscard]] QString toText() const;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    struct Row {
        QLabel *name = nullptr;
        QLabel *unit = nullptr;
        QList<ValueLabel *> values;
    };

    void addHead(const QList<ValueColumn> &columns);
    void addRow(const QList<ValueColumn> &columns, int row);
    void updateVisibility();

    QGridLayout *m_grid;
    QList<QLabel *> m_heads;
    QList<Row> m_rows;
    QList<bool> m_isColumnVisible;
    int m_rowCount;
};

} // namespace widgets
