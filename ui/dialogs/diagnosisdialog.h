// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "settings/profile.h"
#include "ui/widgets/dialogsheet.h"

class QPushButton;

namespace dialogs {

class LadderView;

/// Why does this controller not answer? Not modal; deletes itself when closed.
class DiagnosisDialog : public widgets::DialogSheet
{
    Q_OBJECT

public:
    explicit DiagnosisDialog(const settings::Profile &profile, QWidget *parent = nullptr);

    /// Copies the text as soon as the last rung is told.
    void copyWhenFinished();

private:
    void copy();

    LadderView *m_ladder;
    QPushButton *m_copy;
};

} // namespace dialogs
