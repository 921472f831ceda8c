// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/linkview.h"
#include <QWidget>

class QHBoxLayout;

namespace widgets {
class HoldButton;
class StateField;
class ValueLabel;
} // namespace widgets

namespace ui {

/// The strip at the top of the window: which controller, its state in big words, its link, and HOLD at the right end.
class RobotStrip : public QWidget
{
    Q_OBJECT

public:
    RobotStrip(const robot::RobotState &state, const settings::Profile &profile, QWidget *parent = nullptr);

    /// Small things beside the name, from left to right: the access level, ARMED.
    void addBadge(QWidget *badge);
    void showLink(const LinkView &link);
    void showStatistics(const session::LinkStatistics &statistics);

    [[nodiscard]] QSize minimumSizeHint() const override;

Q_SIGNALS:
    /// The button was pressed. It works in every state of the link: whoever listens says why not.
    void holdRequested();

protected:
    void paintEvent(QPaintEvent *event) override;
    bool event(QEvent *event) override;

private:
    [[nodiscard]] QWidget *nameCell(const settings::Profile &profile);
    [[nodiscard]] QWidget *jobCell() const;
    void makeRoom();
    void setTight(bool isTight);
    void addStatusCells();
    void onChanged(const robot::TopicRange &range);
    void showStatus();
    void showJob();
    void showLinkCell();

    const robot::RobotState &m_state;
    protocol::Encoding m_encoding;
    QHBoxLayout *m_row;
    QHBoxLayout *m_badges = nullptr;
    QList<widgets::StateField *> m_statusFields; ///< In the order of the table of fields.
    QWidget *m_jobCell = nullptr;
    widgets::ValueLabel *m_job;
    widgets::ValueLabel *m_place; ///< Line, step and override of the job.
    widgets::StateField *m_link;
    widgets::HoldButton *m_hold;
    LinkView m_linkView;
    session::LinkStatistics m_statistics;
    bool m_isTight = false; ///< The window is too narrow for big words.
};

} // namespace ui
