// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "session/statistics.h"
#include <QWidget>

namespace widgets {

/// The round trips of the last minute as a line. A second without an answer is a gap, and a second in which tries were
/// lost carries an amber triangle.
class Sparkline : public QWidget
{
    Q_OBJECT

public:
    explicit Sparkline(QWidget *parent = nullptr);

    /// Oldest first; the last one is drawn at the right edge.
    void show(const std::vector<session::LinkSecond> &seconds);
    using QWidget::show;
    [[nodiscard]] QSize sizeHint() const override { return {240, 58}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 48}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    [[nodiscard]] std::chrono::microseconds longest() const;
    [[nodiscard]] QRectF plot() const;
    [[nodiscard]] qreal xOf(std::size_t index) const;
    void paintLine(QPainter &painter) const;
    void paintMissed(QPainter &painter) const;
    void describe();

    std::vector<session::LinkSecond> m_seconds;
};

} // namespace widgets
