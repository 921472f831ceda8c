// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/board.h"

#include "ui/theme.h"
#include <QEvent>
#include <QGridLayout>
#include <numeric>

namespace widgets {

Board::Board(std::span<const Arrangement> arrangements, QWidget *parent)
    : QScrollArea(parent), m_arrangements {arrangements}
{
    auto *content = new QWidget;
    m_grid = new QGridLayout(content);
    m_grid->setContentsMargins(ui::space::page, 0, ui::space::page, ui::space::page);
    m_grid->setSpacing(ui::space::gap);
    setWidget(content);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
}

void Board::add(QWidget *card)
{
    m_cards << card;
    card->setParent(widget());
    m_current = nullptr;
}

int Board::columns() const { return m_current ? m_current->columns : 0; }

void Board::resizeEvent(QResizeEvent *event)
{
    QScrollArea::resizeEvent(event);
    arrange();
}

/// A card that grew may need a narrower arrangement at once; a wider one waits for the next resize, so that changing
/// words never make the page flicker.
bool Board::eventFilter(QObject *watched, QEvent *event)
{
    const bool isGrowth = watched == widget() && event->type() == QEvent::LayoutRequest;
    if (isGrowth && m_current && !fits(*m_current))
        arrange();
    return QScrollArea::eventFilter(watched, event);
}

bool Board::fits(const Arrangement &arrangement) const { return leastWidth(arrangement) <= viewport()->width(); }

int Board::leastWidth(const Arrangement &arrangement) const
{
    QList<int> widths(arrangement.columns);
    for (std::size_t i = 0; i < arrangement.places.size(); ++i) {
        const Place &place = arrangement.places[i];
        if (place.columnSpan == 1)
            widths[place.column] = std::max(widths[place.column], m_cards[qsizetype(i)]->minimumSizeHint().width());
    }
    return std::accumulate(
        widths.begin(), widths.end(), 2 * ui::space::page + (arrangement.columns - 1) * ui::space::gap);
}

void Board::arrange()
{
    for (const Arrangement &arrangement : m_arrangements) {
        if (fits(arrangement) || &arrangement == &m_arrangements.back())
            return use(arrangement);
    }
}

void Board::use(const Arrangement &arrangement)
{
    if (m_current == &arrangement)
        return;
    m_current = &arrangement;
    while (m_grid->count() > 0)
        delete m_grid->takeAt(0);
    int rows = 0;
    for (qsizetype i = 0; i < m_cards.size(); ++i) {
        const Place &place = arrangement.places[std::size_t(i)];
        m_grid->addWidget(m_cards[i], place.row, place.column, place.rowSpan, place.columnSpan);
        m_cards[i]->show();
        rows = std::max(rows, place.row + place.rowSpan);
    }
    for (int row = 0; row < m_grid->rowCount(); ++row)
        m_grid->setRowStretch(row, 0);
    m_grid->setRowStretch(rows, 1);
}

} // namespace widgets
