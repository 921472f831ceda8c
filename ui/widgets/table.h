// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/theme.h"
#include <QHeaderView>
#include <QStyledItemDelegate>
#include <QTableView>

namespace widgets {

/// How a cell is to look, for TableDelegate. Each takes a ui::Role as int, but for Hatched.
enum CellRole {
    InkRole = Qt::UserRole + 100, ///< Colour of the text; text 1 without it.
    GroundRole, ///< Colour behind it; none without it.
    HatchedRole, ///< bool: a stale value.
    BoldRole, ///< bool: a value.
};

/// Flat column heads: small words over a line.
class TableHeader : public QHeaderView
{
    Q_OBJECT

public:
    explicit TableHeader(Qt::Orientation orientation, QWidget *parent = nullptr);

protected:
    void paintSection(QPainter *painter, const QRect &rect, int section) const override;
};

/// Paints cells by their CellRoles: no grid but a hairline under each row, the selection on the accent ground.
class TableDelegate : public QStyledItemDelegate
{
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override;

protected:
    /// Ground, hatch, hairline and the frame of the current cell: everything but what stands in it.
    static void paintGround(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index);
};

/// Rows first..last; none if last is before first.
struct RowSpan {
    int first = 0;
    int last = -1;

    [[nodiscard]] int count() const { return last - first + 1; }
    bool operator==(const RowSpan &) const = default;
};

/// A table in the house's look, which tells which of its rows can be seen.
class Table : public QTableView
{
    Q_OBJECT

public:
    static constexpr int rowHeight = 26;

    explicit Table(QWidget *parent = nullptr);

    using QTableView::edit;

    void setModel(QAbstractItemModel *model) override;
    [[nodiscard]] RowSpan rowsInView() const;
    /// A cell is being edited. Keys that its editor leaves alone reach the table.
    [[nodiscard]] bool isEditing() const { return state() == EditingState; }
    /// How high a row is while one of its cells is edited; the others move down. Without it rows keep their height.
    void setEditingHeight(int column, int height);

Q_SIGNALS:
    void rowsInViewChanged();

protected:
    bool edit(const QModelIndex &index, EditTrigger trigger, QEvent *event) override;
    void closeEditor(QWidget *editor, QAbstractItemDelegate::EndEditHint hint) override;
    void resizeEvent(QResizeEvent *event) override;
    void updateGeometries() override;

private:
    void look();

    RowSpan m_rowsInView;
    int m_editingColumn = -1;
    int m_editingHeight = rowHeight;
    QPersistentModelIndex m_edited;
};

} // namespace widgets
