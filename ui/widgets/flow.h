// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QLayout>

namespace widgets {

/// A row that goes on in the next line where it is short of room, as words do. What expands, and stretches, take what
/// is left of their line.
class Flow : public QLayout
{
    Q_OBJECT

public:
    explicit Flow(QWidget *parent = nullptr);
    ~Flow() override;

    void insertWidget(int index, QWidget *widget);
    void addLayout(QLayout *layout);
    void addStretch();

    void addItem(QLayoutItem *item) override;
    [[nodiscard]] int count() const override { return int(m_items.size()); }
    [[nodiscard]] QLayoutItem *itemAt(int index) const override { return m_items.value(index); }
    QLayoutItem *takeAt(int index) override;
    [[nodiscard]] QSize sizeHint() const override; ///< Of one line.
    [[nodiscard]] QSize minimumSize() const override; ///< Every item in a line of its own.
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;
    [[nodiscard]] Qt::Orientations expandingDirections() const override { return Qt::Horizontal; }
    void setGeometry(const QRect &rect) override;

private:
    using Line = QList<QLayoutItem *>;

    [[nodiscard]] QList<Line> lines(int width) const;
    [[nodiscard]] int widthOf(const Line &line) const;
    /// What each item of the line gets of it.
    [[nodiscard]] QList<int> widths(const Line &line, int width) const;
    [[nodiscard]] int heightOf(const Line &line, int width) const;
    void place(const Line &line, const QRect &room) const;

    QList<QLayoutItem *> m_items;
};

} // namespace widgets
