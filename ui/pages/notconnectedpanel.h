// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/pages/page.h"

class QLabel;

namespace pages {

/// What to do while there is no link. A page shows it instead of its cards.
class NotConnectedPanel : public QWidget
{
    Q_OBJECT

public:
    explicit NotConnectedPanel(const Context &context, QWidget *parent = nullptr);
};

} // namespace pages
