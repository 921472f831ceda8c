// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/pages/page.h"
#include "ui/widgets/card.h"

class QPushButton;

namespace widgets {
class Rows;
}

namespace pages {

/// Where the sub tasks stand. They are read only while the card is open.
class TasksCard : public widgets::Card
{
    Q_OBJECT

public:
    explicit TasksCard(const Context &context, QWidget *parent = nullptr);

    /// The sub tasks while the card is open, else nothing.
    [[nodiscard]] QList<robot::TopicRange> topics() const;

Q_SIGNALS:
    void topicsChanged();

private:
    void onToggled(bool isOpen);
    void showTasks();

    const robot::RobotState &m_state;
    protocol::Encoding m_encoding;
    int m_count; ///< Sub tasks of the model.
    QPushButton *m_open;
    widgets::Rows *m_rows;
};

} // namespace pages
