// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/journalpage.h"

#include "journal/store.h"
#include "ui/alarmwords.h"
#include "ui/models/ordermodel.h"
#include "ui/orderwords.h"
#include "ui/widgets/card.h"
#include "ui/widgets/table.h"
#include "ui/widgets/tabletools.h"
#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSortFilterProxyModel>

namespace pages {

using journal::Outcome;
using models::OrderModel;

namespace {

struct Period {
    const char *title;
    int days; ///< 0: all.
};
constexpr Period periods[] {
    {QT_TRANSLATE_NOOP("pages::JournalPage", "At any time"), 0},
    {QT_TRANSLATE_NOOP("pages::JournalPage", "Today"), 1},
    {QT_TRANSLATE_NOOP("pages::JournalPage", "Last 7 days"), 7},
    {QT_TRANSLATE_NOOP("pages::JournalPage", "Last 30 days"), 30},
};
constexpr Outcome outcomes[] {Outcome::Done, Outcome::Refused, Outcome::Unknown, Outcome::Withheld, Outcome::Cancelled};

/// The first moment of today and the days before it, in UTC.
QDateTime beginOf(int days) { return QDate::currentDate().addDays(1 - days).startOfDay().toUTC(); }

QComboBox *choice(const char *name, const QString &title, const QString &all)
{
    auto *box = new QComboBox;
    box->setObjectName(QLatin1String(name));
    box->setAccessibleName(title);
    box->addItem(all);
    box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    return box;
}

/// Puts names in that are not there yet; what is chosen stays chosen.
void addNames(QComboBox *box, const QStringList &wanted, QString (*title)(const QString &))
{
    for (const QString &name : wanted) {
        if (!name.isEmpty() && box->findData(name) < 0)
            box->addItem(title(name), name);
    }
}

constexpr int wideEnoughForAll = 1100;

QString itself(const QString &name) { return name; }

} // namespace

JournalPage::JournalPage(const Context &context, QWidget *parent)
    : Page(context, parent),
      m_store {context.station.shared.journal},
      m_model {new OrderModel(context.station.shared.journal, this)},
      m_card {new widgets::Card(tr("Journal"))},
      m_table {new widgets::Table},
      m_period {new QComboBox},
      m_controller {choice("journalController", tr("Controller"), tr("All controllers"))},
      m_action {choice("journalAction", tr("What"), tr("Everything"))},
      m_outcome {choice("journalOutcome", tr("Outcome"), tr("Any outcome"))},
      m_search {new QLineEdit},
      m_copy {new QPushButton(tr("Copy"))},
      m_export {new QPushButton(tr("Export…"))},
      m_state {widgets::text({}, ui::Type::Label, ui::Role::Text2)},
      m_detail {widgets::sentence({}, ui::Role::Text1)}
{
    constexpr int besideWords = 44; // frame and arrow
    m_controller->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon); // later names move nothing
    m_controller->setMinimumWidth(m_controller->fontMetrics().horizontalAdvance(tr("All controllers")) + besideWords);
    m_table->setObjectName(QStringLiteral("journalTable"));
    m_table->setAccessibleName(tr("Journal"));
    m_table->setModel(m_model);
    m_table->verticalHeader()->hide();
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    widgets::fitColumns(m_table,
        {QStringLiteral("2026-01-12 08:30:05"), QStringLiteral("CELL 4 · Weld"), QStringLiteral("Switch servo power"),
            QStringLiteral("WELD_A12.JBI"), QStringLiteral("12345 → 12345"),
            ui::word(Outcome::Unknown) + QStringLiteral("00"), {}, QStringLiteral("operator"),
            QStringLiteral("desk-12"), QStringLiteral("Engineer"), QStringLiteral("99999")});
    m_state->setObjectName(QStringLiteral("journalState"));
    m_detail->setObjectName(QStringLiteral("journalDetail"));
    m_detail->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_card->body()->addLayout(filters());
    m_card->body()->addWidget(m_table, 1);
    m_card->body()->addWidget(m_detail);
    m_card->body()->addLayout(tools());
    auto *content = new QWidget;
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(ui::space::page, 0, ui::space::page, ui::space::page);
    column->addWidget(m_card);
    setContent(content);
    connect(m_model, &models::RecordModelBase::loadingChanged, this, &JournalPage::showState);
    connect(&m_store, &journal::Store::failed, this, &JournalPage::showState);
    connect(&m_store, &journal::Store::recovered, this, &JournalPage::showState);
    connect(&m_store, &journal::Store::written, this, [this] {
        if (isVisible())
            m_model->refresh();
    });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &JournalPage::showRecord);
    showRecord({});
    showState();
}

QLayout *JournalPage::filters()
{
    m_period->setObjectName(QStringLiteral("journalPeriod"));
    m_period->setAccessibleName(tr("Time"));
    for (const Period &period : periods)
        m_period->addItem(tr(period.title), period.days);
    for (const Outcome outcome : outcomes)
        m_outcome->addItem(ui::word(outcome), int(outcome));
    m_search->setObjectName(QStringLiteral("journalSearch"));
    m_search->setAccessibleName(tr("Search"));
    m_search->setPlaceholderText(tr("Search in all texts"));
    m_search->setClearButtonEnabled(true);
    auto *row = new QHBoxLayout;
    for (QComboBox *box : {m_period, m_controller, m_action, m_outcome}) {
        box->setMinimumContentsLength(8);
        row->addWidget(box);
        connect(box, &QComboBox::currentIndexChanged, this, &JournalPage::applyFilter);
    }
    row->addWidget(m_search, 1);
    connect(m_search, &QLineEdit::textChanged, this, &JournalPage::applyFilter);
    return row;
}

QLayout *JournalPage::tools()
{
    m_copy->setObjectName(QStringLiteral("copyJournal"));
    m_export->setObjectName(QStringLiteral("exportJournal"));
    auto *row = new QHBoxLayout;
    row->addWidget(m_state, 1);
    row->addWidget(m_copy);
    row->addWidget(m_export);
    widgets::copyFrom(m_table, m_copy);
    connect(m_export, &QPushButton::clicked, this, &JournalPage::exportOrders);
    return row;
}

void JournalPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    fillChoices();
    m_model->refresh();
}

/// Where there is no room for all columns, the sentence under the table has the rest.
void JournalPage::resizeEvent(QResizeEvent *event)
{
    Page::resizeEvent(event);
    for (const int column : {OrderModel::Host, OrderModel::Level, OrderModel::Duration, OrderModel::User})
        m_table->setColumnHidden(column, width() < wideEnoughForAll);
}

void JournalPage::fillChoices()
{
    m_store.orderActions(this, [this](const values::Result<QStringList> &names) {
        if (names)
            addNames(m_action, *names, ui::actionTitle);
    });
    m_store.orderControllers(this, [this](const values::Result<QStringList> &names) {
        if (names)
            addNames(m_controller, *names, itself);
    });
}

void JournalPage::applyFilter()
{
    journal::OrderFilter filter;
    if (const int days = m_period->currentData().toInt(); days > 0)
        filter.from = beginOf(days);
    filter.controller = m_controller->currentData().toString();
    filter.action = m_action->currentData().toString();
    if (m_outcome->currentIndex() > 0)
        filter.outcome = Outcome(m_outcome->currentData().toInt());
    filter.text = m_search->text().trimmed();
    m_model->setFilter(filter);
}

void JournalPage::showState()
{
    m_card->setReason(m_store.trouble());
    const int shown = m_model->rowCount();
    if (m_model->isLoading() && shown == 0)
        m_state->setText(tr("Reading the journal…"));
    else if (!m_model->trouble().isEmpty())
        m_state->setText(tr("The journal cannot be read: %1.").arg(m_model->trouble()));
    else if (shown == 0)
        m_state->setText(tr("Nothing was tried that fits this filter."));
    else if (m_model->canFetchMore({}))
        m_state->setText(tr("The newest %n record(s). Scroll down for older ones.", nullptr, shown));
    else
        m_state->setText(tr("%n record(s)", nullptr, shown));
}

/// All of it in a sentence or two, since a table cuts long texts.
void JournalPage::showRecord(const QModelIndex &index)
{
    if (!index.isValid())
        return m_detail->setText(tr("Choose a record to read all of it here."));
    const journal::OrderRecord &order = m_model->at(index.row());
    QStringList parts {
        tr("%1: %2 at %3.").arg(ui::tableTime(order.at), ui::actionTitle(order.action), order.controller),
        tr("Outcome: %1.").arg(ui::word(order.outcome))};
    const QString by = tr("By %1 at %2, level %3.").arg(order.user, order.host, order.level);
    for (const QString &part : {order.subject, ui::changeText(order), ui::replyText(order), by}) {
        if (!part.isEmpty())
            parts += part;
    }
    m_detail->setText(parts.join(QStringLiteral("  ")));
}

void JournalPage::exportOrders()
{
    widgets::askForFile(this, tr("Export the journal"), QStringLiteral("journal.csv"),
        [this](const QString &path, journal::Format format) {
            m_store.exportOrders(m_model->filter(), path, format, this, [this](const values::Result<qint64> &count) {
                m_state->setText(count ? tr("%n record(s) exported.", nullptr, int(*count))
                                       : tr("Not exported: %1.").arg(count.error().detail));
            });
        });
}

} // namespace pages
