// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/pages/page.h"

namespace pages {

/// What is wrong with the robot now, and what was.
class AlarmsPage : public Page
{
    Q_OBJECT

public:
    explicit AlarmsPage(const Context &context, QWidget *parent = nullptr);

    [[nodiscard]] QList<robot::TopicRange> topics() const override;

protected:
    void showEvent(QShowEvent *event) override;
    /// The history is this computer's own.
    [[nodiscard]] bool needsLink() const override { return false; }

private:
    robot::AlarmLog &m_log;
};

} // namespace pages
