// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/widgets/shown.h"
#include <QLabel>

namespace widgets {

/// A value or state in one line, drawn as far as it can be trusted: live, stale (text 3 on a diagonal hatch, lamp at a
/// third), unknown or refused ("—"). Showing the same again costs nothing.
class ValueLabel : public QLabel
{
    Q_OBJECT

public:
    explicit ValueLabel(ui::Type type, QWidget *parent = nullptr);

    void show(const Shown &shown);
    using QLabel::show;
    [[nodiscard]] const Shown &shown() const { return m_shown; }
    /// What assistive technology reads before the value: "Servo".
    void setTitle(const QString &title);
    /// The colour of a live value without a lamp; text 1 unless told otherwise.
    void setRole(ui::Role role);
    /// Every digit as wide as the widest, so that a changing number stands still.
    void setTabular(bool tabular) { m_isTabular = tabular; }
    /// Keeps room for this text, so that the neighbours stand still.
    void setReserve(const QString &text);
    /// Short of room, the text ends in "…" and the tool tip has all of it.
    void setElided(bool elided) { m_isElided = elided; }

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    [[nodiscard]] int lampSpace() const;
    [[nodiscard]] qreal lampSide() const;
    [[nodiscard]] qreal advance(QChar character) const;
    [[nodiscard]] qreal textWidth(const QString &text) const;
    [[nodiscard]] ui::Role inkRole() const;
    void drawText(QPainter &painter, const QRectF &room) const;
    void describe();

    Shown m_shown;
    QString m_title;
    QString m_reserve;
    ui::Role m_role = ui::Role::Text1;
    bool m_isTabular = false;
    bool m_isElided = false;
};

} // namespace widgets
