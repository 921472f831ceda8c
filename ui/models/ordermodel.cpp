// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/models/ordermodel.h"

#include "ui/alarmwords.h"
#include "ui/orderwords.h"
#include "ui/widgets/table.h"
#include <QLocale>

namespace models {

using journal::OrderRecord;

namespace {

struct ColumnRow {
    const char *title;
    QString (*text)(const OrderRecord &);
};

// One row a column, in the order of OrderModel::Column.
const ColumnRow table[] {
    {QT_TRANSLATE_NOOP("models::OrderModel", "Time"), [](const OrderRecord &order) { return ui::tableTime(order.at); }},
    {QT_TRANSLATE_NOOP("models::OrderModel", "Controller"), [](const OrderRecord &order) { return order.controller; }},
    {QT_TRANSLATE_NOOP("models::OrderModel", "What"),
        [](const OrderRecord &order) { return ui::actionTitle(order.action); }},
    {QT_TRANSLATE_NOOP("models::OrderModel", "Of"), [](const OrderRecord &order) { return order.subject; }},
    {QT_TRANSLATE_NOOP("models::OrderModel", "Change"), ui::changeText},
    {QT_TRANSLATE_NOOP("models::OrderModel", "Outcome"),
        [](const OrderRecord &order) { return ui::word(order.outcome); }},
    {QT_TRANSLATE_NOOP("models::OrderModel", "Reply"), ui::replyText},
    {QT_TRANSLATE_NOOP("models::OrderModel", "Person"), [](const OrderRecord &order) { return order.user; }},
    {QT_TRANSLATE_NOOP("models::OrderModel", "Computer"), [](const OrderRecord &order) { return order.host; }},
    {QT_TRANSLATE_NOOP("models::OrderModel", "Level"), [](const OrderRecord &order) { return order.level; }},
    {QT_TRANSLATE_NOOP("models::OrderModel", "ms"),
        [](const OrderRecord &order) { return QLocale().toString(qint64(order.duration.count())); }},
};
static_assert(std::size(table) == OrderModel::columns);

int orderAlignment(int column)
{
    return int((column == OrderModel::Duration ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
}

QVariant sortKey(const OrderRecord &order, int column)
{
    switch (column) {
    case OrderModel::Time: return order.at;
    case OrderModel::Outcome: return int(order.outcome);
    case OrderModel::Duration: return qint64(order.duration.count());
    default: return table[column].text(order);
    }
}

} // namespace

OrderModel::OrderModel(journal::Store &store, QObject *parent) : RecordModel(parent), m_store {store} { setFilter({}); }

void OrderModel::setFilter(const journal::OrderFilter &filter)
{
    m_filter = filter;
    load([this](qint64 newerThan, const journal::Cursor &from, int count, QObject *context,
             journal::Store::Handler<journal::Page<OrderRecord>> handler) {
        journal::OrderFilter asked = m_filter;
        asked.newerThan = newerThan;
        m_store.orders(asked, from, count, context, std::move(handler));
    });
}

int OrderModel::columnCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : int(columns); }

QVariant OrderModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::DisplayRole)
        return tr(table[section].title);
    return role == Qt::TextAlignmentRole ? QVariant(orderAlignment(section)) : QVariant();
}

QVariant OrderModel::data(const QModelIndex &index, int role) const
{
    const OrderRecord &order = at(index.row());
    const int column = index.column();
    switch (role) {
    case Qt::DisplayRole:
    case Qt::ToolTipRole: return table[column].text(order);
    case Qt::TextAlignmentRole: return orderAlignment(column);
    case SortRole: return sortKey(order, column);
    case widgets::BoldRole: return column == Outcome && order.outcome != journal::Outcome::Done;
    case widgets::InkRole: return column == Outcome ? QVariant(int(ui::roleOf(order.outcome))) : QVariant();
    default: return {};
    }
}

} // namespace models
