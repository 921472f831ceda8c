// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QObject>

class QWidget;

namespace widgets {

/// Makes a window bigger when its words need more room than it has; it never gets smaller by itself.
class FitWindow : public QObject
{
    Q_OBJECT

public:
    /// Lives as long as the window.
    explicit FitWindow(QWidget *window);

    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void fit();

    QWidget *m_window;
};

} // namespace widgets
