// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/pages/page.h"

namespace pages {

class LinkCard;
class OptionsCard;

/// Everything about one controller at a glance.
class OverviewPage : public Page
{
    Q_OBJECT

public:
    explicit OverviewPage(const Context &context, QWidget *parent = nullptr);

    [[nodiscard]] QList<robot::TopicRange> topics() const override;
    void showLink(const ui::LinkView &link) override;
    void showStatistics(const session::LinkStatistics &statistics) override;

private:
    LinkCard *m_linkCard;
    OptionsCard *m_optionsCard;
};

} // namespace pages
