// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QCoreApplication>

namespace cellfiles {

/// The context of the sentences that this folder says to a person.
class Sentences
{
    Q_DECLARE_TR_FUNCTIONS(cellfiles::Sentences)
};

} // namespace cellfiles
