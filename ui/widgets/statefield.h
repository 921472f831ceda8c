// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/widgets/line.h"

namespace widgets {

/// A small label over a big word.
class StateField : public QWidget
{
    Q_OBJECT

public:
    StateField(const QString &title, ui::Type type, QWidget *parent = nullptr);

    void show(const Shown &shown) { m_value->show(shown); }
    using QWidget::show;
    void setTitle(const QString &title);
    [[nodiscard]] ValueLabel *value() const { return m_value; }

private:
    Line *m_title;
    ValueLabel *m_value;
};

} // namespace widgets
