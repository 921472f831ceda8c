// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/widgets/shown.h"
#include <QList>
#include <QWidget>

class QGridLayout;

namespace widgets {

class ValueLabel;

/// Labels at the left, values beside them.
class Rows : public QWidget
{
    Q_OBJECT

public:
    explicit Rows(Qt::Alignment valueAlignment, QWidget *parent = nullptr);

    /// `name` becomes the objectName of the value.
    void add(const QString &name, const QString &title);
    void show(int row, const Shown &shown);
    /// A number or text that is this computer's own knowledge and never stale.
    void showText(int row, const QString &text);
    using QWidget::show;
    /// "Model: YR-1-06VXH12-A00", a line for each row.
    [[nodiscard]] QString toText() const;

private:
    Qt::Alignment m_alignment;
    QGridLayout *m_grid;
    QList<QString> m_titles;
    QList<ValueLabel *> m_values;
};

} // namespace widgets
