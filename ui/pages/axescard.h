// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "settings/profile.h"
#include "ui/pages/groupcard.h"

namespace pages {

/// The axes of a control group: pulses, degrees where the profile knows the arm, how far they lag, torque, temperature.
class AxesCard : public GroupCard
{
    Q_OBJECT

public:
    AxesCard(const robot::RobotState &state, const settings::Profile &profile, QWidget *parent = nullptr);

    [[nodiscard]] QString toText() const override;

protected:
    [[nodiscard]] quint16 positionInstance() const override { return group().instance; }
    void showAll() override;
    void onChanged(const robot::TopicRange &range) override;

private:
    template <robot::Kind kind, typename Text> void showColumn(int column, Text text);
    void showPosition();
    void showErrors();
    void showTorques();
    void showTemperatures();
    void showConverters();
    void showReason();
    [[nodiscard]] double pulsesPerDegree(int axis) const;

    const settings::Profile &m_profile;
    bool m_hasTemperatures;
    widgets::ValueGrid *m_grid;
    QLabel *m_converters;
};

} // namespace pages
