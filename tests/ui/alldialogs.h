// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/harness.h"

#include <QDialog>
#include <span>

/// A dialog of the program and how it comes about, over a live window that has seen its motion page.
struct DialogRow {
    const char *name;
    QDialog *(*create)(Harness &harness);
};

/// Every dialog that shows more than a sentence and two buttons.
[[nodiscard]] std::span<const DialogRow> allDialogs();
