// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QProxyStyle>

namespace ui {

/// Fusion, and every label in it writes plain text: tool tips, message boxes, cards. Qt takes text that begins like
/// HTML for HTML, and most of what stands in this window comes from outside: an alarm may be called `<img
/// src=/dev/zero>`, which would be read for ever. What views and buttons draw is always plain.
class PlainStyle : public QProxyStyle
{
    Q_OBJECT

public:
    PlainStyle();

    /// Before a label is measured the first time.
    void polish(QWidget *widget) override;
    using QProxyStyle::polish;
};

} // namespace ui
