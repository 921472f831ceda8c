// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QAbstractItemView>
#include <QStyledItemDelegate>

namespace widgets {

/// Rows of the height that all tables have, and the view as a flat part of its card.
class RowDelegate : public QStyledItemDelegate
{
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    static void dress(QAbstractItemView *view)
    {
        view->setItemDelegate(new RowDelegate(view));
        view->setFrameShape(QFrame::NoFrame);
    }

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        constexpr int height = 26;
        return {QStyledItemDelegate::sizeHint(option, index).width(), height};
    }
};

} // namespace widgets
