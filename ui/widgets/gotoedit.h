// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QLineEdit>

namespace widgets {

/// Where a person types what to go to; Ctrl+G leads here from anywhere in `owner`.
class GoToEdit : public QLineEdit
{
    Q_OBJECT

public:
    explicit GoToEdit(QWidget *owner);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }
};

} // namespace widgets
