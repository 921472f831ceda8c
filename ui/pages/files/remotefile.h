// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/pages/page.h"
#include "values/filename.h"

namespace pages {

/// A name of the controller as a person reads it.
[[nodiscard]] QString text(const Context &context, const values::FileName &name);

/// Reads what the controller has of a file. Where it cannot, a box above `window` says why instead; without a link
/// nothing happens. `window` is the context of the handler.
void readRemote(const Context &context, const values::FileName &name, QWidget *window,
    const std::function<void(const QByteArray &)> &handler);

} // namespace pages
