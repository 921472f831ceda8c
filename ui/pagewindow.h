// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QWidget>

namespace pages {
class Page;
}

namespace widgets {
class SheetLayer;
}

namespace ui {

class RobotStrip;

/// A window of its own for one page, for a second screen. It has the robot strip and HOLD like every window.
class PageWindow : public QWidget
{
    Q_OBJECT

public:
    /// Takes the strip and the page; the page is given back when the window closes.
    PageWindow(RobotStrip *strip, pages::Page *page, const QString &title, QWidget *parent);

    [[nodiscard]] pages::Page *page() const { return m_page; }

Q_SIGNALS:
    /// The window is closing, and no sheet is open in it; whoever made it takes the page back now.
    void closed(ui::PageWindow *window);

protected:
    void closeEvent(QCloseEvent *event) override;

private:
    pages::Page *m_page;
    widgets::SheetLayer *m_sheets;
};

} // namespace ui
