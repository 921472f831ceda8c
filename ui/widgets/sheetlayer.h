// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QPointer>
#include <QTimer>
#include <QWidget>

namespace widgets {

class DialogSheet;
class SheetFrame;

/// Lies over everything of a window below its robot strip while sheets are open, and shows the newest on top. What is
/// underneath takes neither mouse nor keys meanwhile; the strip above stays live. Keys stay with the newest sheet: Tab
/// goes round in it, shortcuts of the window wait, Escape closes it.
///
/// After the last sheet is gone the layer still catches the mouse for the time of a double click: a second click that
/// was meant for the sheet presses nothing on the page.
class SheetLayer : public QWidget
{
    Q_OBJECT

public:
    /// Covers `window` from `top` pixels down to its lower edge.
    SheetLayer(QWidget *window, int top);
    ~SheetLayer() override;

    /// The layer of this window; one that covers all of it is made if there is none.
    [[nodiscard]] static SheetLayer *of(QWidget *window);

    /// Takes a sheet that is about to be shown.
    void take(DialogSheet *sheet);
    /// The open sheets, the newest last.
    [[nodiscard]] QList<DialogSheet *> sheets() const;
    [[nodiscard]] bool isOpen() const { return !sheets().isEmpty(); }
    /// Rejects all sheets, the newest first. Returns whether none is left: one that is at work may stay.
    bool closeAll();
    /// Rejects all sheets and deletes those that stay.
    void clear();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;

private:
    friend class SheetFrame;
    [[nodiscard]] SheetFrame *front() const;
    [[nodiscard]] bool covers(const QWidget *widget) const;
    void cover();
    void onShown(SheetFrame *frame);
    void onHidden(SheetFrame *frame);
    void onFocusChanged(QWidget *now);

    int m_top;
    QList<SheetFrame *> m_frames; ///< Of the sheets that are shown, the newest last.
    QPointer<QWidget> m_focusBefore; ///< Where the keys went before the first sheet.
    QTimer m_shield; ///< Runs while the layer catches a late click.
};

} // namespace widgets
