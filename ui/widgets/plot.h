// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "trend/scale.h"
#include "trend/track.h"
#include <QtCharts/QChartView>
#include <map>

class QValueAxis;

namespace widgets {

class CurvesItem;
struct Curve;

/// Where the cursor of a plot stands: a moment and the pixel it was put on.
struct PlotCursor {
    qreal share = 0; ///< Of the width, 0 left to 1 right.

    bool operator==(const PlotCursor &) const = default;
};

/// Tracks over time, with an axis for each unit. Each track has a letter that stands on its line, and a kind of line of
/// its own, so that nobody needs to see colours. A gap is not drawn over. It shows what it was given last: streaming is
/// giving it the same tracks with a later range, a few times a second.
class Plot : public QChartView
{
    Q_OBJECT

public:
    static constexpr int mostTracks = 8;

    explicit Plot(QWidget *parent = nullptr);
    ~Plot() override;

    /// The tracks must stay until others are shown. The time axis counts seconds from `zero`. More than mostTracks are
    /// left out.
    void show(const std::vector<const trend::Track *> &tracks, const trend::Range &range, trend::Moment zero);
    using QChartView::show;
    [[nodiscard]] const trend::Range &range() const { return m_range; }
    /// The moment under the cursor; nullopt without one.
    [[nodiscard]] std::optional<trend::Moment> cursor() const;
    void setCursor(std::optional<PlotCursor> cursor);
    /// Where a value would be drawn, in the coordinates of the viewport.
    [[nodiscard]] QPointF placeOf(const trend::Track &track, const trend::Sample &sample) const;

    /// 'A' for the first.
    [[nodiscard]] static QChar letter(int index) { return QChar(u'A' + index); }
    /// The line of the track at this place; `widget` tells the scheme.
    [[nodiscard]] static QPen pen(int index, const QWidget *widget);

Q_SIGNALS:
    /// The person moved or removed the cursor; and when the range moved under it.
    void cursorChanged();

protected:
    void mouseMoveEvent(QMouseEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    struct Axis {
        QValueAxis *axis = nullptr;
        trend::Scale scale;
    };

    void dress();
    void redraw();
    void placeAxes();
    [[nodiscard]] trend::Extent extentOf(trend::Unit unit, const std::vector<Curve> &curves) const;
    void scale(Axis &axis, trend::Unit unit, const trend::Extent &extent);
    void describe();
    [[nodiscard]] QString lettersOf(trend::Unit unit) const;

    QValueAxis *m_timeAxis;
    std::map<trend::Unit, Axis> m_axes;
    CurvesItem *m_curves;
    std::vector<const trend::Track *> m_tracks;
    trend::Range m_range {};
    trend::Moment m_zero {};
    std::optional<PlotCursor> m_cursor;
};

} // namespace widgets
