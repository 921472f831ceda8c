// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/orders.h"
#include <QTimer>
#include <QWidget>
#include <functional>

class QPushButton;

namespace widgets {

class Line;

/// A button for everything that changes something at a controller. It is enabled while the conditions of its act are
/// met; else the first reason stands under it, and "Why not?" beside it opens all of them.
///
///     auto *reset = new widgets::OrderButton(context.station.orders, robot::Act::ResetAlarm);
///     connect(reset, &OrderButton::clicked, this, [this, reset] {
///         m_orders.send(protocol::ResetAlarm {}, {Act::ResetAlarm}, this, [this](const auto &result) { … });
///         reset->expect([](const Situation &s) { return s.status && !s.status->hasAlarm(); }); // "Pending…" until
///         then
///     });
///
/// The order itself is checked once more by Orders, so a click that comes too late does no harm. Object names are made
/// of robot::key(act): "reset-alarm" the button, "why-reset-alarm", "reason-reset-alarm".
class OrderButton : public QWidget
{
    Q_OBJECT

public:
    enum class Reason { Below, InToolTip };
    using Agrees = std::function<bool(const robot::Situation &)>;

    /// `orders` must outlive the button. Its text is the act's title unless told otherwise.
    OrderButton(robot::Orders &orders, robot::Act act, Reason place = Reason::Below, QWidget *parent = nullptr);

    void setText(const QString &text);
    /// What this page itself finds wanting ("Choose a job first."); it disables the button too. Empty: nothing.
    void setComplaint(const QString &complaint);
    /// Says "Pending…" in place of a reason and takes no click until the situation agrees, or 10 s have passed.
    void expect(Agrees agrees);
    /// The order was refused or withheld: nothing is pending any more.
    void stopExpecting();
    [[nodiscard]] bool isPending() const { return bool(m_agrees); }
    [[nodiscard]] QPushButton *button() const { return m_button; }

Q_SIGNALS:
    void clicked();

private:
    void update();
    void setPressable(bool isPressable);
    void openConditions();

    robot::Orders &m_orders;
    robot::Act m_act;
    QString m_complaint;
    Agrees m_agrees;
    QTimer m_patience;
    QPushButton *m_button;
    QPushButton *m_why;
    Line *m_reason;
};

} // namespace widgets
