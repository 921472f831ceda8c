// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "settings/appearance.h"
#include "ui/widgets/dialogsheet.h"

class QComboBox;

namespace dialogs {

/// Language, and light or dark. Deletes itself when it is closed.
class AppearanceDialog : public widgets::DialogSheet
{
    Q_OBJECT

public:
    explicit AppearanceDialog(const settings::Appearance &now, QWidget *parent);

Q_SIGNALS:
    /// The person chose and confirmed; the dialog is closed already.
    void chosen(const settings::Appearance &wanted);

private:
    QComboBox *m_language;
    QComboBox *m_scheme;
};

} // namespace dialogs
