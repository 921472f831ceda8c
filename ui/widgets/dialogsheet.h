// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QDialog>
#include <QPointer>

class QPushButton;

namespace widgets {

/// What every dialog of Pendesk is: a sheet that lies inside the window of its owner, over the pages and never over the
/// robot strip, so that HOLD stays in reach of the mouse. It is never modal: see SheetLayer, which it finds by itself
/// when it is shown. Without an owner it is a window.
///
/// It is answered once. From accept(), reject(), done() or close() on it is disabled, so that a second click that
/// already waits in the event queue finds nothing to press; finished() is emitted once. A second sheet of the same
/// owner and object name is not shown while the first is open, but deleted.
class DialogSheet : public QDialog
{
    Q_OBJECT

public:
    /// The sheet is deleted when it is closed, and with its owner, whichever window it lies in.
    explicit DialogSheet(QWidget *owner);

    /// The same as show(): nothing is modal.
    void open() override { show(); }
    void setVisible(bool isVisible) override;
    void done(int result) override;
    [[nodiscard]] bool isAnswered() const { return m_isAnswered; }

private:
    [[nodiscard]] bool isOpenAlready() const;
    void enter();
    void keepDefault();

    QPointer<QWidget> m_owner;
    bool m_isAnswered = false;
};

/// Marks a button that sends, writes, deletes or moves: Return never presses it, whether or not it has the focus.
/// Returns the button.
QPushButton *writing(QPushButton *button);
/// Whether a button is marked so.
[[nodiscard]] bool isWriting(const QPushButton *button);

} // namespace widgets
