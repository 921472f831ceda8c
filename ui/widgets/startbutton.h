// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QKeyEvent>
#include <QPushButton>

namespace widgets {

/// A button that only a pointer presses: Enter, Space and keys that repeat pass it by, and it is never the default.
class StartButton : public QPushButton
{
    Q_OBJECT

public:
    explicit StartButton(const QString &text, QWidget *parent = nullptr);

protected:
    void keyPressEvent(QKeyEvent *event) override { event->ignore(); }
    void keyReleaseEvent(QKeyEvent *event) override { event->ignore(); }
};

} // namespace widgets
