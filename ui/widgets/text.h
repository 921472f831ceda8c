// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/theme.h"
#include <QAbstractButton>
#include <QLabel>

namespace widgets {

/// Makes `widget` write in the colour of `role`, in the present scheme and the next. Text roles only.
void setTextRole(QWidget *widget, ui::Role role);

/// A label with the type and the colour of the theme.
[[nodiscard]] QLabel *text(const QString &words, ui::Type type, ui::Role role, QWidget *parent = nullptr);

/// The same for sentences, which wrap.
[[nodiscard]] QLabel *sentence(const QString &words, ui::Role role, QWidget *parent = nullptr);

/// Makes the button as wide as the widest of these texts needs, so that its neighbours stand still.
void reserveWidth(QAbstractButton *button, const QStringList &texts);

} // namespace widgets
