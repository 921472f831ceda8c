// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/models/fleetmodel.h"
#include <QStyledItemDelegate>

namespace pages {

/// Paints a controller of the fleet as a tile: tag, name and mode; its state in one big word, since when, and why; job
/// and place; servo, link and alarms.
class TileDelegate : public QStyledItemDelegate
{
    Q_OBJECT

public:
    enum class Size { Small, Medium, Large }; ///< Large can be read from two metres.

    using QStyledItemDelegate::QStyledItemDelegate;

    void setSize(Size size) { m_size = size; }

    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;

private:
    [[nodiscard]] qreal scale() const;
    [[nodiscard]] QFont font(ui::Type type, bool isBold = false) const;
    void paintGround(QPainter &painter, const QRect &tile, const models::FleetRow &row, ui::Scheme scheme) const;

    Size m_size = Size::Medium;
};

} // namespace pages
