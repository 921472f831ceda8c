// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/edits.h"
#include "ui/widgets/dialogsheet.h"

namespace dialogs {

/// What Apply would write, old and new, before anything leaves the computer.
class ApplyDialog : public widgets::DialogSheet
{
    Q_OBJECT

public:
    /// `edits` must outlive the dialog.
    /// `variables` are those of the edits that are written.
    ApplyDialog(robot::Edits &edits, const QList<variables::Reference> &variables, const QString &controller,
        const variables::Format &format, QWidget *parent);
};

} // namespace dialogs
