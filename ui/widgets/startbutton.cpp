// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/startbutton.h"

namespace widgets {

StartButton::StartButton(const QString &text, QWidget *parent) : QPushButton(text, parent)
{
    setAutoDefault(false);
    setDefault(false);
    setAutoRepeat(false);
    setFocusPolicy(Qt::NoFocus);
    setShortcut({}); // no mnemonic
}

} // namespace widgets
