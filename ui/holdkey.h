// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QObject>

class QKeyEvent;

namespace ui {

/// Watches for Pause and Ctrl+Shift+H in every window of the application. A QShortcut would not do: those of a window
/// that a modal dialog covers are silent.
class HoldKey : public QObject
{
    Q_OBJECT

public:
    explicit HoldKey(QObject *parent = nullptr);

    bool eventFilter(QObject *watched, QEvent *event) override;

Q_SIGNALS:
    /// Once for each press; never for a key that repeats because it is held down.
    void pressed();

private:
    [[nodiscard]] static bool isHold(const QKeyEvent &event);
};

} // namespace ui
