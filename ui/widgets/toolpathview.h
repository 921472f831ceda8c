// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "trend/toolpath.h"
#include <QWidget>

namespace widgets {

/// The way of the tool point, seen along one axis of the base frame. Lengths are the same in both directions. It marks
/// where the way began and where the tool point was read last.
class ToolPathView : public QWidget
{
    Q_OBJECT

public:
    enum class Side {
        Top, ///< From above: X to the right, Y up.
        Front, ///< From the front of the robot: Y to the right, Z up.
        Side, ///< From its right: X to the right, Z up.
    };

    explicit ToolPathView(Side side, QWidget *parent = nullptr);

    /// `path` must outlive the view or be replaced. Showing it again after it grew is enough.
    void show(const trend::ToolPath &path);
    using QWidget::show;
    /// What the last point is worth: an empty note while it is live, else "Last seen 12:03:04", and the way is drawn as
    /// stale.
    void setStale(const QString &note);
    [[nodiscard]] bool isStale() const { return !m_staleNote.isEmpty(); }
    /// Where a point is drawn, in pixels.
    [[nodiscard]] QPointF placeOf(const trend::PathPoint &point) const;
    [[nodiscard]] double pixelsPerMillimetre() const { return m_scale; }
    [[nodiscard]] QSize sizeHint() const override { return {280, 220}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 140}; }

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void fit();
    void describe();
    [[nodiscard]] QRectF plot() const;
    [[nodiscard]] QPointF millimetres(const trend::PathPoint &point) const;
    void paintFrame(QPainter &painter) const;
    void paintPath(QPainter &painter) const;
    void paintMarks(QPainter &painter) const;
    void paintScale(QPainter &painter) const;

    Side m_side;
    const trend::ToolPath *m_path = nullptr;
    QString m_staleNote;
    double m_scale = 1; ///< Pixels a millimetre.
    QPointF m_centre; ///< In millimetres.
};

} // namespace widgets
