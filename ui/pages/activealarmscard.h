// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/alarmlog.h"
#include "ui/models/activealarmmodel.h"
#include "ui/widgets/card.h"

class QPushButton;

namespace widgets {
class OrderButton;
class Table;
} // namespace widgets

namespace pages {

/// The active alarms, their acknowledgement, and the two orders that clear something at the controller.
class ActiveAlarmsCard : public widgets::Card
{
    Q_OBJECT

public:
    /// All of them must outlive the card.
    ActiveAlarmsCard(robot::AlarmLog &log, robot::Orders &orders, QWidget *parent = nullptr);

Q_SIGNALS:
    /// The person looks at an alarm with this code.
    void codeChosen(quint32 code);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    [[nodiscard]] QWidget *acknowledging();
    [[nodiscard]] QWidget *clearing();
    void refresh();
    void showRefusal();
    void showTargets();
    void acknowledgeSelected();
    void acknowledgeAll();
    void reset();
    void cancelError();
    void onReset(const values::Result<void> &result);
    void checkReset();
    void say(const QString &sentence, ui::Role role);
    [[nodiscard]] QString activeNames() const;
    [[nodiscard]] QString stateSentence() const;

    robot::AlarmLog &m_log;
    robot::Orders &m_orders;
    protocol::TextCodec m_codec;
    models::ActiveAlarmModel *m_model;
    widgets::Table *m_table;
    widgets::Line *m_sentence; ///< What the table says as a whole; also read to assistive technology.
    QPushButton *m_acknowledge;
    QPushButton *m_acknowledgeAll;
    widgets::OrderButton *m_reset;
    widgets::OrderButton *m_cancel;
    widgets::Line *m_resetTarget;
    widgets::Line *m_cancelTarget;
    widgets::Line *m_outcome;
    QTimer m_resetPatience; ///< From the acceptance of a reset until alarms count as still active.
};

} // namespace pages
