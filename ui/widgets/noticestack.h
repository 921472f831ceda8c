// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/widgets/messagebar.h"

namespace widgets {

/// Messages over the lower right edge of a window, above each other. They lie over what is there and push nothing.
class NoticeStack : public QWidget
{
    Q_OBJECT

public:
    explicit NoticeStack(QWidget *host);

    [[nodiscard]] MessageBar *add(const QString &name);
    /// Moves to another window, or follows the one it is over.
    void layOver(QWidget *host);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void place();
};

} // namespace widgets
