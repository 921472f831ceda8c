// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/pages/groupcard.h"

namespace widgets {
class Rows;
}

namespace pages {

/// Where the tool point of a robot stands in the base frame, which HSES alone tells (reference §2.1), and its form in
/// words.
class CartesianCard : public GroupCard
{
    Q_OBJECT

public:
    explicit CartesianCard(const robot::RobotState &state, QWidget *parent = nullptr);

    [[nodiscard]] QString toText() const override;

protected:
    [[nodiscard]] quint16 positionInstance() const override;
    void showAll() override;
    void onChanged(const robot::TopicRange &range) override;

private:
    void showPosition();
    void showForm();

    widgets::ValueGrid *m_grid;
    widgets::Rows *m_form;
};

} // namespace pages
