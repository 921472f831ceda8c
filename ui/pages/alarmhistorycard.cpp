// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/alarmhistorycard.h"

#include "protocol/codes.h"
#include "ui/alarmwords.h"
#include "ui/models/alarmhistorymodel.h"
#include "ui/models/codestatisticsmodel.h"
#include "ui/pages/alarmnotes.h"
#include "ui/widgets/table.h"
#include "ui/widgets/tabletools.h"
#include "ui/widgets/text.h"
#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>

namespace pages {

namespace {

constexpr int mostShown = 20'000; ///< Rows that are searched here; the export has all of them.
constexpr int topCount = 10;

} // namespace

AlarmHistoryCard::AlarmHistoryCard(
    robot::AlarmLog &log, journal::Store &store, const settings::Profile &profile, QWidget *parent)
    : Card(tr("History"), parent),
      m_log {log},
      m_store {store},
      m_profile {profile},
      m_model {new models::AlarmHistoryModel(store, profile.name, protocol::TextCodec {profile.encoding}, this)},
      m_filter {new models::AlarmHistoryFilter(this)},
      m_statistics {new models::CodeStatisticsModel(protocol::TextCodec {profile.encoding}, this)},
      m_tabs {new QTabWidget},
      m_table {new widgets::Table},
      m_list {new QComboBox},
      m_search {new QLineEdit},
      m_state {widgets::text({}, ui::Type::Label, ui::Role::Text2)},
      m_exported {widgets::text({}, ui::Type::Label, ui::Role::Text2)},
      m_read {new QPushButton},
      m_copy {new QPushButton(tr("Copy"))},
      m_export {new QPushButton(tr("Export…"))},
      m_notes {new AlarmNotes(store)}
{
    m_filter->setSourceModel(m_model);
    m_tabs->setObjectName(QStringLiteral("historyTabs"));
    m_tabs->setDocumentMode(true);
    m_tabs->addTab(historyTab(), tr("Past alarms"));
    m_tabs->addTab(statisticsTab(), tr("Most frequent"));
    m_tabs->addTab(m_notes, tr("Notes"));
    body()->addWidget(m_tabs, 1);
    connect(&log, &robot::AlarmLog::readingChanged, this, &AlarmHistoryCard::showReading);
    connect(&log, &robot::AlarmLog::historyGrew, this, &AlarmHistoryCard::refresh);
    connect(m_model, &models::RecordModelBase::loadingChanged, this, &AlarmHistoryCard::loadAll);
    refresh();
    showReading();
}

QWidget *AlarmHistoryCard::historyTab()
{
    m_table->setObjectName(QStringLiteral("alarmHistory"));
    m_table->setAccessibleName(tr("Past alarms"));
    m_table->setModel(m_filter);
    m_table->verticalHeader()->hide();
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSortingEnabled(true);
    m_table->horizontalHeader()->setSectionsClickable(true);
    m_table->horizontalHeader()->setSortIndicatorClearable(true);
    m_table->horizontalHeader()->setSortIndicator(-1, Qt::DescendingOrder);
    widgets::fitColumns(m_table,
        {QStringLiteral("2026/01/12 08:30"), ui::title(values::AlarmHistoryClass::UserSystem), QStringLiteral("9999"),
            QStringLiteral("S L U R B T"), {}, QStringLiteral("2026-01-12 08:30:05")});
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex &now) {
        if (now.isValid())
            chooseCode(m_model->at(m_filter->mapToSource(now).row()).alarm.alarm.code);
    });
    auto *result = new QWidget;
    auto *column = new QVBoxLayout(result);
    column->setContentsMargins(0, 10, 0, 0);
    column->addLayout(tools());
    column->addWidget(m_table, 1);
    auto *last = new QHBoxLayout;
    last->addWidget(m_state, 1);
    last->addWidget(m_exported);
    column->addLayout(last);
    return result;
}

QLayout *AlarmHistoryCard::tools()
{
    m_list->setObjectName(QStringLiteral("historyList"));
    m_list->setAccessibleName(tr("List"));
    m_list->addItem(tr("All lists"));
    for (const auto list : values::allAlarmHistoryClasses)
        m_list->addItem(ui::title(list), int(list));
    m_search->setObjectName(QStringLiteral("historySearch"));
    m_search->setAccessibleName(tr("Search"));
    m_search->setPlaceholderText(tr("Search code, text or time"));
    m_search->setClearButtonEnabled(true);
    m_state->setObjectName(QStringLiteral("historyState"));
    m_exported->setObjectName(QStringLiteral("historyExported"));
    m_read->setObjectName(QStringLiteral("readHistory"));
    widgets::reserveWidth(m_read, {tr("Stop reading"), tr("Read now")});
    m_copy->setObjectName(QStringLiteral("copyHistory"));
    m_export->setObjectName(QStringLiteral("exportHistory"));
    auto *row = new QHBoxLayout;
    row->addWidget(m_list);
    row->addWidget(m_search, 1);
    row->addWidget(m_read);
    row->addWidget(m_copy);
    row->addWidget(m_export);
    widgets::copyFrom(m_table, m_copy);
    connect(m_list, &QComboBox::currentIndexChanged, this, [this] { m_filter->setList(chosenList()); });
    connect(m_search, &QLineEdit::textChanged, m_filter, &models::AlarmHistoryFilter::setSearch);
    connect(m_read, &QPushButton::clicked, this,
        [this] { m_log.isReading() ? m_log.cancelReading() : m_log.readHistory(); });
    connect(m_export, &QPushButton::clicked, this, &AlarmHistoryCard::exportHistory);
    return row;
}

QWidget *AlarmHistoryCard::statisticsTab()
{
    auto *table = new widgets::Table;
    table->setObjectName(QStringLiteral("alarmStatistics"));
    table->setAccessibleName(tr("Most frequent alarms"));
    table->setModel(m_statistics);
    table->verticalHeader()->hide();
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    widgets::fitColumns(table,
        {QStringLiteral("9999"), {}, QStringLiteral("99999"), QStringLiteral("999 d 23 h"),
            QStringLiteral("2026/01/12 08:30")});
    connect(table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex &now) {
        if (now.isValid())
            chooseCode(m_statistics->at(now.row()).code);
    });
    auto *result = new QWidget;
    auto *column = new QVBoxLayout(result);
    column->setContentsMargins(0, 10, 0, 0);
    column->addWidget(table, 1);
    column->addWidget(widgets::sentence(
        tr("Counted in everything this journal has of the controller. The times between are by the controller's clock; "
           "steps of that clock are left out."),
        ui::Role::Text2));
    return result;
}

void AlarmHistoryCard::chooseCode(quint32 code)
{
    m_notes->chooseCode(code);
    m_tabs->setTabText(2, tr("Note on %1").arg(code));
}

void AlarmHistoryCard::refresh()
{
    m_model->refresh();
    m_store.statistics(
        {m_profile.name, {}, 0}, topCount, this, [this](const values::Result<QList<journal::CodeStatistics>> &top) {
            if (top)
                m_statistics->show(*top);
        });
}

void AlarmHistoryCard::showReading()
{
    m_read->setText(m_log.isReading() ? tr("Stop reading") : tr("Read now"));
    const auto &error = m_log.readingError();
    const int shown = m_model->rowCount();
    if (m_log.isReading())
        m_state->setText(
            tr("Reading the history from the controller: %n entry(s) read.", nullptr, m_log.entriesRead()));
    else if (!m_model->trouble().isEmpty())
        m_state->setText(tr("The journal cannot be read: %1.").arg(m_model->trouble()));
    else if (error && error->kind == values::ErrorKind::Cancelled)
        m_state->setText(tr("Reading was stopped. %n entry(s) in the journal.", nullptr, shown));
    else if (error)
        m_state->setText(tr("The history could not be read to its end: %1.").arg(protocol::explain(*error)));
    else if (shown >= mostShown)
        m_state->setText(tr("The newest %n entry(s) of the journal; the export has all of them.", nullptr, shown));
    else
        m_state->setText(tr("%n entry(s) in the journal, kept for ever.", nullptr, shown));
}

/// The search looks at every row, so all of them are loaded.
void AlarmHistoryCard::loadAll()
{
    if (m_model->canFetchMore({}) && m_model->rowCount() < mostShown)
        m_model->fetchMore({});
    else
        showReading();
}

std::optional<values::AlarmHistoryClass> AlarmHistoryCard::chosenList() const
{
    if (m_list->currentIndex() == 0)
        return std::nullopt;
    return values::AlarmHistoryClass(m_list->currentData().toInt());
}

void AlarmHistoryCard::exportHistory()
{
    const journal::AlarmFilter filter {m_profile.name, chosenList(), 0};
    widgets::askForFile(this, tr("Export past alarms"), QStringLiteral("alarms.csv"),
        [this, filter](const QString &path, journal::Format format) {
            m_store.exportAlarms(filter, protocol::TextCodec {m_profile.encoding}, path, format, this,
                [this](const values::Result<qint64> &count) {
                    m_exported->setText(count ? tr("%n entry(s) exported.", nullptr, int(*count))
                                              : tr("Not exported: %1.").arg(count.error().detail));
                });
        });
}

} // namespace pages
