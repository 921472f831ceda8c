// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/widgets/dialogsheet.h"
#include "variables/sheet.h"

namespace dialogs {

/// What a file or a pasted block would change, and what is wrong with it. Accepting stages the differences; nothing of
/// it is taken while anything is wrong.
class ImportDialog : public widgets::DialogSheet
{
    Q_OBJECT

public:
    ImportDialog(
        const variables::Preview &preview, const QString &controller, const variables::Format &format, QWidget *parent);

Q_SIGNALS:
    void differencesAccepted(const QList<variables::Difference> &differences);
};

} // namespace dialogs
