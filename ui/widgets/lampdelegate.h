// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/models/iomodel.h"
#include "ui/widgets/table.h"

namespace widgets {

/// Paints the signals of an IoModel: a square, hollow or filled, with 0 or 1 inside, its address and its name. One
/// painter for all of them; no lamp is a widget.
class LampDelegate : public TableDelegate
{
    Q_OBJECT

public:
    using TableDelegate::TableDelegate;

    static constexpr int rowHeight = 40;

    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override;
};

/// A lamp with its digit, in a square.
void paintSignal(QPainter &painter, const QRect &square, const models::Lamp &lamp, ui::Scheme scheme);

} // namespace widgets
