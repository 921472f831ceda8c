// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/table.h"

#include <QPainter>
#include <QScrollBar>

namespace widgets {

namespace {

constexpr int padding = 8;

ui::Role role(const QModelIndex &index, int of, ui::Role otherwise)
{
    const QVariant value = index.data(of);
    return value.isValid() ? ui::Role(value.toInt()) : otherwise;
}

} // namespace

TableHeader::TableHeader(Qt::Orientation orientation, QWidget *parent) : QHeaderView(orientation, parent)
{
    QFont head = ui::font(ui::Type::Label);
    head.setWeight(QFont::DemiBold);
    setFont(head);
    setHighlightSections(false);
    setSectionsClickable(false);
    viewport()->setAutoFillBackground(false);
}

void TableHeader::paintSection(QPainter *painter, const QRect &rect, int section) const
{
    const QVariant alignment = model()->headerData(section, orientation(), Qt::TextAlignmentRole);
    const QString words = model()->headerData(section, orientation()).toString();
    const QRect room = rect.adjusted(padding, 0, -padding, -1);
    painter->save();
    painter->setFont(font());
    painter->setPen(ui::color(ui::Role::Text2, this));
    const int where = alignment.isValid() ? alignment.toInt() : int(defaultAlignment());
    painter->drawText(
        room, where | Qt::AlignVCenter, painter->fontMetrics().elidedText(words, Qt::ElideRight, room.width()));
    painter->setPen(ui::color(orientation() == Qt::Horizontal ? ui::Role::Border : ui::Role::Hairline, this));
    painter->drawLine(rect.bottomLeft(), rect.bottomRight());
    painter->restore();
}

void TableDelegate::paintGround(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index)
{
    const ui::Scheme scheme = ui::schemeOf(option.palette);
    const QRect cell = option.rect;
    const bool isSelected = option.state & QStyle::State_Selected;
    if (const QVariant ground = index.data(GroundRole); ground.isValid())
        painter->fillRect(cell, ui::color(ui::Role(ground.toInt()), scheme));
    else if (isSelected)
        painter->fillRect(cell, ui::color(ui::Role::AccentGround, scheme));
    if (index.data(HatchedRole).toBool())
        painter->fillRect(cell.adjusted(2, 2, -2, -3), QBrush(ui::color(ui::Role::Border, scheme), Qt::BDiagPattern));
    painter->setPen(ui::color(ui::Role::Hairline, scheme));
    painter->drawLine(cell.bottomLeft(), cell.bottomRight());
    if (option.state & QStyle::State_HasFocus) {
        painter->setPen(ui::color(ui::Role::Accent, scheme));
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(cell.adjusted(0, 0, -1, -1));
    }
}

void TableDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    QStyleOptionViewItem cell = option;
    initStyleOption(&cell, index);
    painter->save();
    paintGround(painter, option, index);
    cell.font.setWeight(index.data(BoldRole).toBool() ? QFont::DemiBold : QFont::Normal);
    painter->setFont(cell.font);
    painter->setPen(ui::color(role(index, InkRole, ui::Role::Text1), ui::schemeOf(option.palette)));
    const QRect room = option.rect.adjusted(padding, 0, -padding, -1);
    const QString words = QFontMetrics(cell.font).elidedText(cell.text, Qt::ElideRight, room.width());
    painter->drawText(room, int(cell.displayAlignment) | Qt::TextSingleLine, words);
    painter->restore();
}

Table::Table(QWidget *parent) : QTableView(parent)
{
    setFrameShape(QFrame::NoFrame);
    setShowGrid(false);
    setHorizontalHeader(new TableHeader(Qt::Horizontal, this));
    setVerticalHeader(new TableHeader(Qt::Vertical, this));
    horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    horizontalHeader()->setMinimumHeight(rowHeight);
    verticalHeader()->setDefaultSectionSize(rowHeight);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    setItemDelegate(new TableDelegate(this));
    viewport()->setAutoFillBackground(false);
    setHorizontalScrollMode(ScrollPerPixel);
    setTabKeyNavigation(false); // Tab leaves the table
    connect(verticalScrollBar(), &QScrollBar::valueChanged, this, &Table::look);
}

void Table::setModel(QAbstractItemModel *model)
{
    QTableView::setModel(model);
    look();
}

RowSpan Table::rowsInView() const
{
    if (!model() || model()->rowCount(rootIndex()) == 0)
        return {};
    const int first = std::max(rowAt(0), 0);
    const int last = rowAt(viewport()->height() - 1);
    return {first, last < 0 ? model()->rowCount(rootIndex()) - 1 : last};
}

void Table::setEditingHeight(int column, int height)
{
    m_editingColumn = column;
    m_editingHeight = height;
}

bool Table::edit(const QModelIndex &index, EditTrigger trigger, QEvent *event)
{
    const bool isOpen = QTableView::edit(index, trigger, event);
    if (isOpen && state() == EditingState && index.column() == m_editingColumn) {
        m_edited = index;
        setRowHeight(index.row(), m_editingHeight);
        scrollTo(index);
    }
    return isOpen;
}

void Table::closeEditor(QWidget *editor, QAbstractItemDelegate::EndEditHint hint)
{
    if (const QPersistentModelIndex edited = std::exchange(m_edited, {}); edited.isValid())
        setRowHeight(edited.row(), rowHeight);
    QTableView::closeEditor(editor, hint);
}

void Table::look()
{
    if (const RowSpan rows = rowsInView(); rows != std::exchange(m_rowsInView, rows))
        Q_EMIT rowsInViewChanged();
}

/// The current row stays in view when the table gets lower.
void Table::resizeEvent(QResizeEvent *event)
{
    const int row = currentIndex().row();
    const bool wasInView = currentIndex().isValid() && row >= m_rowsInView.first && row <= m_rowsInView.last;
    QTableView::resizeEvent(event);
    if (wasInView && event->size().height() < event->oldSize().height())
        scrollTo(currentIndex());
    look();
}

/// Also after rows came or went.
void Table::updateGeometries()
{
    QTableView::updateGeometries();
    look();
}

} // namespace widgets
