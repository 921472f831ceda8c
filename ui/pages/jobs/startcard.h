// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/pages/jobs/ordercard.h"

namespace pages {

/// Arming, and the way to the start sheet.
class StartCard : public OrderCard
{
    Q_OBJECT

public:
    explicit StartCard(const Context &context, QWidget *parent = nullptr);
};

} // namespace pages
