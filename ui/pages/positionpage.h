// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/pages/page.h"

class QTabBar;
class QLabel;

namespace pages {

class AxesCard;
class CartesianCard;
class ToolPathCard;

/// Where everything stands that the controller moves: a tab for each control group that answers, and of that group its
/// tool point, its axes and its path. Which groups there are is asked once for each link; refused ones have no tab.
class PositionPage : public Page
{
    Q_OBJECT

public:
    explicit PositionPage(const Context &context, QWidget *parent = nullptr);

    [[nodiscard]] QList<robot::TopicRange> topics() const override;
    void showLink(const ui::LinkView &link) override;
    /// Everything on this page as words, for a mail or a log.
    [[nodiscard]] QString toText() const;

private:
    [[nodiscard]] QWidget *header();
    void onChanged(const robot::TopicRange &range);
    void showGroups();
    void openTab(int tab);
    void reset();

    const robot::RobotState &m_state;
    const settings::Profile &m_profile;
    QTabBar *m_tabs;
    bool m_isLive = false;
    CartesianCard *m_cartesian;
    AxesCard *m_axes;
    ToolPathCard *m_path;
    QList<values::ControlGroup> m_groups; ///< Of the tabs.
    values::ControlGroup m_group; ///< The one that is shown.
};

} // namespace pages
