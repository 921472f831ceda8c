// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/theme.h"

class QPainter;
class QRectF;

namespace widgets {

/// The shape before a word. The shape says the same as its colour, so that nobody needs to see colours.
enum class Lamp {
    None,
    Hollow, ///< Off.
    Filled, ///< On.
    Alarm, ///< Filled square, red.
    Diamond, ///< ◆ red: an alarm among several controllers.
    Warning, ///< ▲ amber: held, error, stale, contradictory.
};

/// The colour of the words that stand beside the lamp.
[[nodiscard]] ui::Role roleOf(Lamp lamp);

/// `strength` is 1, or a third for a value that is stale.
void paintLamp(QPainter &painter, const QRectF &square, Lamp lamp, ui::Scheme scheme, qreal strength = 1);

} // namespace widgets
