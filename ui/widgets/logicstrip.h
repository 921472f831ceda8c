// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/namebook.h"
#include "robot/signalwatch.h"
#include <QTimer>
#include <QWidget>

namespace widgets {

/// The watched signals over the last minute, one under the other, as a logic analyser draws them. What was not read is
/// a gap. It moves while it can be seen.
class LogicStrip : public QWidget
{
    Q_OBJECT

public:
    static constexpr auto window = std::chrono::seconds {60};

    /// All of them must outlive the strip.
    LogicStrip(const robot::SignalWatch &watch, const robot::NameBook &book, QWidget *parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {240, sizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void paintTrack(QPainter &painter, const robot::SignalTrace &trace, const QRect &track, robot::Time now) const;
    void paintScale(QPainter &painter, const QRect &room) const;

    const robot::SignalWatch &m_watch;
    const robot::NameBook &m_book;
    QTimer m_pace;
};

} // namespace widgets
