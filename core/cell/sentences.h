// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QCoreApplication>

namespace cell {

/// The context of the sentences that this folder says to a person.
class Sentences
{
    Q_DECLARE_TR_FUNCTIONS(cell::Sentences)
};

} // namespace cell
