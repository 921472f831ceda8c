// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/robotstate.h"
#include "trend/extremes.h"
#include "ui/widgets/card.h"
#include <map>

namespace widgets {
class ValueGrid;
}

namespace pages {

/// What the cards of the position page have in common: they show one control group of several, and keep the lowest and
/// the highest place of each of them since the last reset.
class GroupCard : public widgets::Card
{
    Q_OBJECT

public:
    GroupCard(const QString &title, const robot::RobotState &state, QWidget *parent = nullptr);

    /// By its pulse instance: R1 is 1, B1 11, S1 21.
    void setGroup(values::ControlGroup group);
    void resetExtremes();
    [[nodiscard]] virtual QString toText() const = 0;

protected:
    [[nodiscard]] values::ControlGroup group() const { return m_group; }
    /// The instance whose position this card shows; 0 if the group has none of that kind.
    [[nodiscard]] virtual quint16 positionInstance() const = 0;
    /// Shows everything anew.
    virtual void showAll() = 0;
    virtual void onChanged(const robot::TopicRange &range) = 0;
    [[nodiscard]] const trend::Extremes &extremes() { return m_extremes[positionInstance()]; }
    [[nodiscard]] const robot::Reading<values::Position> &position() const
    {
        return m_state.reading<robot::Kind::Position>(positionInstance());
    }
    [[nodiscard]] robot::Topic positionTopic() const { return {robot::Kind::Position, positionInstance()}; }
    /// Rows for the axes that the controller sent; as many as usual until then.
    [[nodiscard]] int axisCount() const;
    void nameRows(widgets::ValueGrid &grid, bool withUnits) const;
    void showExtremes(widgets::ValueGrid &grid, int lowestColumn);

    const robot::RobotState &m_state;

private:
    void take(const robot::TopicRange &range);

    values::ControlGroup m_group;
    std::map<quint16, trend::Extremes> m_extremes; ///< By instance of the position.
};

} // namespace pages
