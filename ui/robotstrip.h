// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/linkview.h"
#include <QWidget>

class QHBoxLayout;

namespace widgets {
class HoldButton;
class StateField;
} // namespace widgets

namespace ui {

/// The strip at the top of the window: which controller, its state in big words, its link, and HOLD at the right end.
class RobotStrip : public QWidget
{
    Q_OBJECT

public:
    RobotStrip(const robot::RobotState &state, const settings::Profile &profile, QWidget *parent = nullptr);

    /// A small thing above the name: the access level.
    void addBadge(QWidget *badge);
    /// One beside the name, which gives way while it is there: ARMED.
    void addMark(QWidget *mark);
    void showLink(const LinkView &link);
    void showStatistics(const session::LinkStatistics &statistics);

    [[nodiscard]] QSize minimumSizeHint() const override;

Q_SIGNALS:
    /// The button was pressed. It works in every state of the link: whoever listens says why not.
    void holdRequested();

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    [[nodiscard]] QWidget *nameCell(const settings::Profile &profile);
    void useFittingType();
    void addStatusCells();
    void onChanged(const robot::TopicRange &range);
    void showStatus();
    void showJob();
    void showLinkCell();

    const robot::RobotState &m_state;
    protocol::Encoding m_encoding;
    QHBoxLayout *m_row;
    QHBoxLayout *m_badges = nullptr;
    QHBoxLayout *m_nameLine = nullptr;
    QList<widgets::StateField *> m_statusFields; ///< In the order of the table of fields.
    QWidget *m_name;
    widgets::StateField *m_job;
    widgets::StateField *m_link;
    widgets::HoldButton *m_hold;
    LinkView m_linkView;
    session::LinkStatistics m_statistics;
};

} // namespace ui
