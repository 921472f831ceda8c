// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/widgets/valuelabel.h"

namespace widgets {

/// One line of words that always takes its height, with words or without, so that what stands below it stands still. It
/// asks for no width: short of room the words end in "…", and the tool tip has all of them.
class Line : public ValueLabel
{
    Q_OBJECT

public:
    explicit Line(ui::Role role, ui::Type type = ui::Type::Label, QWidget *parent = nullptr);

    void setWords(const QString &words);
};

/// Keeps the room of `widget` while it is hidden, so that its neighbours stand still.
void keepRoom(QWidget *widget);

} // namespace widgets
