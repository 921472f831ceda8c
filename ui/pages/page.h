// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/linkview.h"
#include <QWidget>

namespace ui {
class Actions;
}

namespace pages {

/// What a page is made of. All of it outlives the page: a window makes new pages for another controller.
struct Context {
    const robot::RobotState &state;
    const settings::Profile &profile;
    const ui::Actions &actions;
};

/// One page of the window. It shows what it is told and never asks the controller for anything itself.
class Page : public QWidget
{
    Q_OBJECT

public:
    using QWidget::QWidget;

    /// What must be read while the page is visible.
    [[nodiscard]] virtual QList<robot::Topic> topics() const = 0;
    virtual void showLink(const ui::LinkView &link) = 0;
    virtual void showStatistics(const session::LinkStatistics &) { }
};

} // namespace pages
