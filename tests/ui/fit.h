// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QStringList>

class QWidget;

/// Whether what stands in a window has room there, measured on the widgets that a person sees.
namespace fit {

/// The words that one widget shows or tells: its text, tool tip, placeholder, tabs, heads and choices.
[[nodiscard]] QStringList words(const QWidget &widget);

/// The visible widgets below `root`, and itself; without the insides of Qt's own widgets.
[[nodiscard]] QList<const QWidget *> visibleWidgets(const QWidget &root);

/// Texts that are cut off or shortened without a way to read them whole, widgets squeezed below their least size,
/// siblings that overlap, and what sticks out of its parent: a line each, with object name and text.
[[nodiscard]] QStringList findings(const QWidget &root);

/// Areas that must be scrolled sideways.
[[nodiscard]] QStringList sidewaysScrolled(const QWidget &root);

/// "overviewPage/QLabel 'messageText'": where the widget is.
[[nodiscard]] QString nameOf(const QWidget &widget);

} // namespace fit
