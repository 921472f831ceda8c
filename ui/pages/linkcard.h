// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/linkview.h"
#include "ui/widgets/card.h"

namespace widgets {
class Rows;
class Sparkline;
} // namespace widgets

namespace pages {

/// What the link has been like in the last minute.
class LinkCard : public widgets::Card
{
    Q_OBJECT

public:
    explicit LinkCard(const settings::Profile &profile, QWidget *parent = nullptr);

    void showStatistics(const session::LinkStatistics &statistics);

private:
    int m_ceiling; ///< Requests a second.
    widgets::Sparkline *m_sparkline;
    widgets::Rows *m_rows;
};

} // namespace pages
