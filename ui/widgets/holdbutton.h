// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QAbstractButton>

namespace widgets {

/// The software hold: two bars and a word on a quiet ground. It is no emergency stop and does not look like one.
class HoldButton : public QAbstractButton
{
    Q_OBJECT

public:
    explicit HoldButton(QWidget *parent = nullptr);

    /// The small line under the word: "software hold · Pause key", "HOLD sent…".
    void setCaption(const QString &caption);
    /// Takes as much room as the longest of these needs, so that nothing moves when the caption changes.
    void makeRoomFor(const QStringList &captions);
    [[nodiscard]] const QString &caption() const { return m_caption; }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

Q_SIGNALS:
    /// HOLD was asked for: by the button going down, or by whoever emits this for it, such as the HOLD key.
    void holdRequested();

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void paintWord(QPainter &painter, const QRectF &line) const;

    QString m_caption;
    int m_captionRoom = 0;
};

} // namespace widgets
