// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QScrollArea>
#include <span>

class QGridLayout;

namespace widgets {

/// Where one card stands.
struct Place {
    int row;
    int column;
    int rowSpan = 1;
    int columnSpan = 1;
};

/// One way to lay the cards out: a place for each, in the order in which they were added.
struct Arrangement {
    int columns;
    std::span<const Place> places;
};

/// Cards on a page that scrolls. It takes the first arrangement whose columns fit the width, measured by what the cards
/// need in the present language and font, else the last one.
class Board : public QScrollArea
{
    Q_OBJECT

public:
    /// `arrangements` from wide to narrow; they must outlive the board.
    explicit Board(std::span<const Arrangement> arrangements, QWidget *parent = nullptr);

    void add(QWidget *card);
    [[nodiscard]] int columns() const;
    [[nodiscard]] QSize minimumSizeHint() const override { return {320, 240}; }

    bool eventFilter(QObject *watched, QEvent *event) override;

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    [[nodiscard]] int leastWidth(const Arrangement &arrangement) const;
    [[nodiscard]] bool fits(const Arrangement &arrangement) const;
    void arrange();
    void use(const Arrangement &arrangement);

    std::span<const Arrangement> m_arrangements;
    const Arrangement *m_current = nullptr;
    QList<QWidget *> m_cards;
    QGridLayout *m_grid;
};

} // namespace widgets
