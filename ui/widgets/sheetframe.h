// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QFrame>
#include <QPointer>

class QLabel;
class QScrollArea;

namespace widgets {

class DialogSheet;
class SheetLayer;

/// The border, the title and, where the window is too small, the scroll bars of one sheet. It grows with the words of
/// the sheet, downwards only, and never shrinks by itself. Deletes itself with the sheet.
class SheetFrame : public QFrame
{
    Q_OBJECT

public:
    SheetFrame(DialogSheet *sheet, SheetLayer *layer);
    ~SheetFrame() override;

    [[nodiscard]] DialogSheet *sheet() const { return m_sheet; }
    /// Puts the frame into the middle of the layer.
    void place();
    /// Gives the keys to the widget of the sheet that had them last, or to its first.
    void takeFocus();
    void scrollTo(QWidget *widget);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    [[nodiscard]] QSize needed(int width) const;

    SheetLayer *m_layer;
    QPointer<DialogSheet> m_sheet;
    QPointer<QWidget>
        m_first; ///< What the dialog gave the focus to while it was made; it forgets that in a new window.
    QLabel *m_title;
    QScrollArea *m_scroll;
    QSize m_wanted; ///< The size that the dialog asked for, or has grown to.
};

} // namespace widgets
