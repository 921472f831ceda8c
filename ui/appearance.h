// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "settings/appearance.h"

class QApplication;

namespace ui {

/// Speaks and looks as wanted, from now on; where nothing is wanted that exists, as the desktop does. What is so
/// already is left alone: dressing all widgets anew takes a while.
void wear(QApplication &application, const settings::Appearance &wanted);

} // namespace ui
