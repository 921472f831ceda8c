// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/fleetpage.h"

#include "ui/actioncatalog.h"
#include "ui/pages/fleet/tiledelegate.h"
#include "ui/widgets/flow.h"
#include "ui/widgets/holdbutton.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/table.h"
#include "ui/widgets/text.h"
#include <QHBoxLayout>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QStackedWidget>

namespace pages {

using models::FleetModel;
using models::FleetRow;

namespace {

/// Troubled first, then the fleet's own order: nothing changes its place because a word has changed.
class TroubledFirst : public QSortFilterProxyModel
{
public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

protected:
    [[nodiscard]] bool lessThan(const QModelIndex &left, const QModelIndex &right) const override
    {
        const int a = left.data(FleetModel::TroubleRole).toInt();
        const int b = right.data(FleetModel::TroubleRole).toInt();
        return a != b ? a < b : left.row() < right.row();
    }
    [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex &parent) const override
    {
        if (filterRegularExpression().pattern().isEmpty())
            return true;
        for (int column = 0; column < sourceModel()->columnCount(parent); ++column) {
            if (sourceModel()->index(row, column, parent).data().toString().contains(filterRegularExpression()))
                return true;
        }
        return false;
    }
};

QPushButton *fleetButton(const char *name, const QString &words)
{
    auto *button = new QPushButton(words);
    button->setObjectName(QLatin1String(name));
    button->setAutoDefault(false);
    return button;
}

} // namespace

FleetPage::FleetPage(const Context &context, QWidget *parent)
    : Page(context, parent),
      m_context {context},
      m_model {new FleetModel(context.fleet, this)},
      m_sorted {new TroubledFirst(this)},
      m_board {new QListView},
      m_tiles {new TileDelegate(this)},
      m_table {new widgets::Table},
      m_views {new QStackedWidget},
      m_view {new widgets::Segments(QStringLiteral("fleetView"), tr("View"))},
      m_size {new widgets::Segments(QStringLiteral("fleetSize"), tr("Size of the tiles"))},
      m_filter {new QLineEdit},
      m_hold {new widgets::HoldButton},
      m_counts {widgets::text({}, ui::Type::Body, ui::Role::Text2)},
      m_held {widgets::sentence({}, ui::Role::Text1)}
{
    m_sorted->setSourceModel(m_model);
    m_sorted->setDynamicSortFilter(true);
    m_sorted->sort(FleetModel::Name);
    makeBoard();
    makeTable();
    m_views->addWidget(m_board);
    m_views->addWidget(m_table);
    auto *content = new QWidget;
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(ui::space::page, ui::space::page, ui::space::page, ui::space::page);
    column->setSpacing(ui::space::gap);
    column->addWidget(head());
    column->addWidget(m_held);
    column->addWidget(tools());
    column->addWidget(m_views, 1);
    setContent(content);
    for (const auto signal : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
        connect(m_model, signal, this, &FleetPage::showCounts);
    connect(m_model, &QAbstractItemModel::dataChanged, this, &FleetPage::showCounts);
    connect(&context.fleet, &station::Fleet::holdTold, this, &FleetPage::showHold);
    showCounts();
    showHold();
}

QWidget *FleetPage::head()
{
    m_counts->setObjectName(QStringLiteral("fleetCounts"));
    m_held->setObjectName(QStringLiteral("holdAllOutcome"));
    m_held->setMinimumHeight(2 * m_held->fontMetrics().height()); // always, so that nothing below it moves
    m_hold->setObjectName(QStringLiteral("holdAll"));
    m_hold->setText(tr("HOLD ALL"));
    m_hold->setAccessibleName(tr("HOLD all controllers (software)"));
    m_hold->setCaption(tr("every station that is not off"));
    connect(m_hold, &QAbstractButton::pressed, &m_context.fleet, &station::Fleet::holdAll);
    auto *connectButton = fleetButton("connectAll", tr("Connect all"));
    auto *backUpButton = fleetButton("backUpAll", tr("Back up all"));
    connect(connectButton, &QPushButton::clicked, this, &FleetPage::connectAll);
    connect(backUpButton, &QPushButton::clicked, this, &FleetPage::backUpAll);
    auto *result = new QWidget;
    auto *row = new widgets::Flow(result);
    row->addWidget(m_counts);
    row->addStretch();
    row->addWidget(connectButton);
    row->addWidget(backUpButton);
    row->addWidget(m_hold);
    return result;
}

QWidget *FleetPage::tools()
{
    m_filter->setObjectName(QStringLiteral("fleetFilter"));
    m_filter->setAccessibleName(tr("Filter"));
    m_filter->setPlaceholderText(tr("Filter"));
    m_filter->setClearButtonEnabled(true);
    connect(m_filter, &QLineEdit::textChanged, this, [this](const QString &text) {
        m_sorted->setFilterRegularExpression(
            QRegularExpression {QRegularExpression::escape(text.trimmed()), QRegularExpression::CaseInsensitiveOption});
    });
    m_view->setChoices({tr("Board"), tr("Table")});
    m_size->setChoices({tr("S"), tr("M"), tr("L")}, int(TileDelegate::Size::Medium));
    connect(m_view, &widgets::Segments::changed, m_views, &QStackedWidget::setCurrentIndex);
    connect(m_size, &widgets::Segments::changed, this, &FleetPage::setSize);
    auto *result = new QWidget;
    auto *row = new widgets::Flow(result);
    row->addWidget(m_filter);
    row->addStretch();
    row->addWidget(m_view);
    row->addWidget(m_size);
    return result;
}

void FleetPage::makeBoard()
{
    m_board->setObjectName(QStringLiteral("fleetBoard"));
    m_board->setAccessibleName(tr("Controllers"));
    m_board->setModel(m_sorted);
    m_board->setItemDelegate(m_tiles);
    m_board->setViewMode(QListView::IconMode);
    m_board->setResizeMode(QListView::Adjust);
    m_board->setMovement(QListView::Static);
    m_board->setUniformItemSizes(true);
    m_board->setFrameShape(QFrame::NoFrame);
    m_board->setSelectionMode(QAbstractItemView::SingleSelection);
    m_board->viewport()->setAutoFillBackground(false);
    connect(m_board, &QAbstractItemView::activated, this, &FleetPage::open);
    connect(m_board, &QAbstractItemView::clicked, this, &FleetPage::open);
}

void FleetPage::makeTable()
{
    m_table->setObjectName(QStringLiteral("fleetTable"));
    m_table->setAccessibleName(tr("Controllers"));
    m_table->setModel(m_sorted);
    m_table->verticalHeader()->hide();
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->setColumnWidth(FleetModel::Name, 180);
    m_table->setColumnWidth(FleetModel::Reason, 280);
    connect(m_table, &QAbstractItemView::activated, this, &FleetPage::open);
}

void FleetPage::open(const QModelIndex &index)
{
    Q_EMIT m_context.actions.stationChosen(m_model->row(m_sorted->mapToSource(index).row()).id);
}

void FleetPage::setSize(int size)
{
    m_tiles->setSize(TileDelegate::Size(size));
    m_board->doItemsLayout();
}

/// Reading only, as every connection.
void FleetPage::connectAll()
{
    for (const auto &entry : m_context.fleet.roster())
        m_context.fleet.open(entry.profile);
}

void FleetPage::backUpAll()
{
    for (const auto &station : m_context.fleet.stations())
        station->backups.backUp(); // does nothing without a link
}

void FleetPage::showCounts()
{
    const auto &rows = m_model->rows();
    const auto count = [&rows](auto isSo) { return int(std::ranges::count_if(rows, isSo)); };
    const int open = count([](const FleetRow &row) { return row.isOpen; });
    const int lost = count([](const FleetRow &row) { return row.trouble == models::Trouble::NoLink; });
    m_counts->setText(QStringList {tr("%n controller(s)", nullptr, int(rows.size())),
        tr("%n connected", nullptr, open - lost), tr("%n without link", nullptr, lost)}
                          .join(QStringLiteral(" · ")));
    m_hold->setCaption(tr("%n station(s) that are not off", nullptr, open));
}

/// Each of them, in words: what was not confirmed first.
void FleetPage::showHold()
{
    QStringList unknown;
    QStringList asked;
    int confirmed = 0;
    for (const auto &[id, outcome] : m_context.fleet.holdOutcomes()) {
        const auto station = m_context.fleet.find(id);
        const QString name = station ? station->profile().name : QString();
        if (!outcome)
            asked << name;
        else if (*outcome == journal::Outcome::Done)
            ++confirmed;
        else
            unknown << name;
    }
    QStringList sentences;
    if (!unknown.isEmpty())
        sentences << tr("▲ HOLD was not confirmed by %1: look at the robot.").arg(unknown.join(QStringLiteral(", ")));
    if (!asked.isEmpty())
        sentences << tr("HOLD is being asked of %1.").arg(asked.join(QStringLiteral(", ")));
    if (confirmed > 0)
        sentences << tr("HOLD was confirmed by %n controller(s).", nullptr, confirmed);
    m_held->setText(sentences.join(u' '));
    widgets::setTextRole(m_held, unknown.isEmpty() ? ui::Role::Text1 : ui::Role::Amber);
}

} // namespace pages
