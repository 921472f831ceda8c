// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/widgets/dialogsheet.h"

class QCheckBox;

namespace dialogs {

/// What to do with a file whose name is taken where it is to go.
class OverwriteDialog : public widgets::DialogSheet
{
    Q_OBJECT

public:
    enum class Choice { Skip, Replace, KeepBoth, Compare };

    /// `where` as in "on CELL 4". Only on this computer can both be kept.
    OverwriteDialog(
        const QString &name, const QString &where, bool canKeepBoth, int remaining, QWidget *parent = nullptr);

    /// Skip until a person chooses something else.
    [[nodiscard]] Choice choice() const { return m_choice; }
    [[nodiscard]] bool isForAll() const;

private:
    void addButton(
        class QHBoxLayout *row, const QString &text, const char *name, Choice choice, bool isDefault = false);

    Choice m_choice = Choice::Skip;
    QCheckBox *m_forAll;
};

} // namespace dialogs
