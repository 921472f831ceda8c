// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/trendpage.h"

#include "disk/durable.h"
#include "protocol/codes.h"
#include "trend/csv.h"
#include "trend/moment.h"
#include "ui/dialogs/signalpicker.h"
#include "ui/models/incidentmodel.h"
#include "ui/models/trackmodel.h"
#include "ui/widgets/card.h"
#include "ui/widgets/filesheet.h"
#include "ui/widgets/plot.h"
#include <QComboBox>
#include <QDragEnterEvent>
#include <QHeaderView>
#include <QListView>
#include <QMimeData>
#include <QPushButton>
#include <QShortcut>
#include <QTableView>
#include <algorithm>

namespace pages {

using namespace std::chrono_literals;
using trend::Track;

namespace {

constexpr auto trendPace = 250ms;
constexpr int rowHeight = 26;

constexpr std::chrono::seconds spans[] {30s, 60s, 300s, 900s, 3600s};
constexpr int usualSpan = 1;

QString spanText(std::chrono::seconds span)
{
    return span < 60s ? TrendPage::tr("%1 s").arg(span.count()) : TrendPage::tr("%1 min").arg(span.count() / 60);
}

/// A view without a ground of its own.
void setOnCard(QAbstractItemView *view) { view->viewport()->setAutoFillBackground(false); }

QPushButton *trendButton(const char *name, const QString &words)
{
    auto *result = new QPushButton(words);
    result->setObjectName(QLatin1String(name));
    return result;
}

std::vector<const Track *> tracksOf(const trend::Incident &incident)
{
    std::vector<const Track *> result;
    for (const Track &track : incident.tracks)
        result.push_back(&track);
    return result;
}

std::vector<const Track *> tracksOf(const trend::Recorder &recorder)
{
    std::vector<const Track *> result;
    for (const auto &track : recorder.tracks())
        result.push_back(track.get());
    return result;
}

} // namespace

TrendPage::TrendPage(const Context &context, QWidget *parent)
    : Page(context, parent),
      m_recorder {context.station.recorder},
      m_profile {context.station.profile()},
      m_model {new models::TrackModel(this)},
      m_incidents {new models::IncidentModel(this)},
      m_plot {new widgets::Plot}
{
    setAcceptDrops(true);
    auto *content = new QWidget;
    auto *grid = new QGridLayout(content);
    grid->setContentsMargins(ui::space::page, 0, ui::space::page, ui::space::page);
    grid->setSpacing(ui::space::gap);
    grid->addWidget(toolBar(), 0, 0, 1, 2);
    grid->addWidget(plotCard(), 1, 0, 1, 2);
    grid->addWidget(trackCard(), 2, 0);
    grid->addWidget(incidentCard(), 2, 1);
    grid->setRowStretch(1, 5);
    grid->setRowStretch(2, 3);
    grid->setColumnStretch(0, 3);
    grid->setColumnStretch(1, 2);
    setContent(content);
    follow();
    setTracks();
}

TrendPage::~TrendPage() = default;

QWidget *TrendPage::toolBar()
{
    auto *result = new QWidget;
    auto *row = new QHBoxLayout(result);
    row->setContentsMargins(0, 0, 0, 0);
    auto *addButton = trendButton("addSignal", tr("Add signal…"));
    auto *exportButton = trendButton("exportCsv", tr("Export CSV…"));
    m_pause = trendButton("pauseTrend", tr("Pause"));
    m_pause->setCheckable(true);
    m_pause->setToolTip(tr("Freezes the view; recording goes on."));
    m_live = trendButton("backToLive", tr("Back to live"));
    m_live->setProperty("primary", true);
    m_live->hide();
    m_span = new QComboBox;
    m_span->setObjectName(QStringLiteral("trendSpan"));
    m_span->setAccessibleName(tr("Time in view"));
    for (const auto span : spans)
        m_span->addItem(spanText(span));
    m_span->setCurrentIndex(usualSpan);
    for (QWidget *widget : std::initializer_list<QWidget *> {addButton, m_pause, m_live, m_span})
        row->addWidget(widget);
    row->addStretch();
    row->addWidget(exportButton);
    connect(addButton, &QPushButton::clicked, this, &TrendPage::pick);
    connect(exportButton, &QPushButton::clicked, this, &TrendPage::chooseFile);
    connect(m_pause, &QPushButton::toggled, this, &TrendPage::setPaused);
    connect(m_live, &QPushButton::clicked, this, &TrendPage::backToLive);
    connect(m_span, &QComboBox::currentIndexChanged, this, &TrendPage::refresh);
    return result;
}

QWidget *TrendPage::plotCard()
{
    m_card = new widgets::Card(tr("Trend"));
    m_card->setObjectName(QStringLiteral("trendCard"));
    m_plot->setObjectName(QStringLiteral("trendPlot"));
    m_plot->setAcceptDrops(false); // drops are the page's
    m_plot->viewport()->setAcceptDrops(false);
    m_hint = widgets::sentence(tr("Nothing is plotted yet. Drag a number here from any page, choose “Add to trend” in "
                                  "its menu, or add a signal."),
        ui::Role::Text2);
    m_hint->setObjectName(QStringLiteral("trendHint"));
    m_card->body()->addWidget(m_hint);
    m_card->body()->addWidget(m_plot, 1);
    return m_card;
}

QWidget *TrendPage::trackCard()
{
    auto *card = new widgets::Card(tr("Signals"));
    m_table = new QTableView;
    m_table->setObjectName(QStringLiteral("trackTable"));
    m_table->setAccessibleName(tr("Signals"));
    m_table->setModel(m_model);
    m_table->setShowGrid(false);
    m_table->setFrameShape(QFrame::NoFrame);
    setOnCard(m_table);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setTabKeyNavigation(false);
    m_table->setMinimumHeight(3 * rowHeight);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(rowHeight);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(models::TrackModel::Label, QHeaderView::Stretch);
    m_table->horizontalHeader()->setHighlightSections(false);
    auto *removeButton = trendButton("removeSignal", tr("Remove from trend"));
    removeButton->setToolTip(QKeySequence(Qt::Key_Delete).toString(QKeySequence::NativeText));
    card->body()->addWidget(m_table, 1);
    card->body()->addWidget(removeButton, 0, Qt::AlignLeft);
    connect(removeButton, &QPushButton::clicked, this, &TrendPage::removeSelected);
    auto *shortcut = new QShortcut(QKeySequence(Qt::Key_Delete), m_table);
    shortcut->setContext(Qt::WidgetShortcut);
    connect(shortcut, &QShortcut::activated, this, &TrendPage::removeSelected);
    return card;
}

QWidget *TrendPage::incidentCard()
{
    auto *card = new widgets::Card(tr("Incidents"));
    card->setNote(tr("60 s before an alarm, 20 s after"));
    m_list = new QListView;
    m_list->setObjectName(QStringLiteral("incidentList"));
    m_list->setAccessibleName(tr("Incidents"));
    m_list->setModel(m_incidents);
    m_list->setFrameShape(QFrame::NoFrame);
    setOnCard(m_list);
    m_list->setMinimumHeight(3 * rowHeight);
    auto *openButton = trendButton("openIncident", tr("Open incident"));
    auto *none = widgets::sentence(tr("No alarm has been recorded yet."), ui::Role::Text2);
    none->setObjectName(QStringLiteral("noIncidents"));
    const auto showNone = [this, none] { none->setVisible(m_incidents->rowCount() == 0); };
    connect(m_incidents, &QAbstractItemModel::rowsInserted, none, showNone);
    card->body()->addWidget(none);
    showNone();
    card->body()->addWidget(m_list, 1);
    card->body()->addWidget(openButton, 0, Qt::AlignLeft);
    const auto open = [this] {
        if (m_list->currentIndex().isValid())
            openIncident(m_incidents->entry(m_list->currentIndex().row()));
    };
    connect(openButton, &QPushButton::clicked, this, open);
    connect(m_list, &QListView::activated, this, open);
    return card;
}

void TrendPage::follow()
{
    connect(&m_recorder, &trend::Recorder::tracksChanged, this, [this] {
        setTracks();
        Q_EMIT topicsChanged();
    });
    m_disk.run(
        this, [folder = m_recorder.archive().folder()] { return trend::Archive {folder}.incidents(); },
        [this](const QList<trend::IncidentEntry> &entries) { m_incidents->addOlder(entries); });
    connect(&m_recorder, &trend::Recorder::incidentKept, m_incidents, &models::IncidentModel::add);
    connect(&m_recorder, &trend::Recorder::writingFailed, this,
        [this](const values::Error &error) { m_card->setReason(tr("It could not be saved: %1").arg(error.detail)); });
    connect(m_model, &models::TrackModel::shownChanged, this, &TrendPage::refresh);
    connect(
        m_plot, &widgets::Plot::cursorChanged, this, [this] { m_model->refresh(m_plot->range(), m_plot->cursor()); });
    connect(&m_pace, &QTimer::timeout, this, &TrendPage::refresh);
    m_pace.setInterval(trendPace);
}

/// The axes' names are wanted too: labels are made of them.
QList<robot::TopicRange> TrendPage::topics() const
{
    QList<robot::TopicRange> result {robot::topics::status};
    for (const trend::Signal &signal : m_recorder.signalSet()) {
        result << signal.topic;
        if (const auto names = trend::namesOf(signal))
            result << *names;
    }
    return result;
}

void TrendPage::showLink(const ui::LinkView &link)
{
    Page::showLink(link);
    m_isLinkUp = link.state == robot::LinkState::Monitoring;
    refreshNote();
}

void TrendPage::setTracks()
{
    m_model->setTracks(m_incident ? tracksOf(*m_incident) : tracksOf(m_recorder));
    refresh();
}

trend::Range TrendPage::range() const
{
    if (m_incident)
        return m_incident->range;
    const trend::Moment to = m_pausedAt.value_or(trend::now());
    return {to - spans[std::max(0, m_span->currentIndex())], to};
}

void TrendPage::refresh()
{
    const trend::Range view = range();
    const auto tracks = m_model->shown();
    m_plot->show(tracks, view, m_incident ? m_incident->at : view.to);
    m_model->refresh(view, m_plot->cursor());
    m_hint->setVisible(m_model->rowCount() == 0);
    refreshNote();
}

void TrendPage::refreshNote()
{
    const auto clock = [](trend::Moment at) { return trend::toLocalTime(at).toString(u"HH:mm:ss"); };
    const auto cursor = m_plot->cursor();
    if (m_incident)
        m_card->setNote(
            tr("Incident of %1: %2")
                .arg(trend::toLocalTime(m_incident->at).toString(u"yyyy-MM-dd HH:mm:ss"), m_incident->title));
    else if (m_pausedAt)
        m_card->setNote(tr("Paused at %1; recording goes on").arg(clock(*m_pausedAt)));
    else if (!m_isLinkUp)
        m_card->setNote(tr("Nothing is recorded: no communication"));
    else if (cursor)
        m_card->setNote(tr("Live; values of %1").arg(clock(*cursor)));
    else
        m_card->setNote(tr("Live"));
    const auto refusal = [&]() -> QString {
        for (const Track *track : m_model->shown()) {
            if (!m_incident && m_recorder.state().freshness(track->signal.topic) == robot::Freshness::Refused)
                return tr("%1 is refused by the controller.").arg(track->label);
        }
        return {};
    }();
    m_card->setReason(refusal);
}

void TrendPage::setPaused(bool paused)
{
    m_pausedAt = paused ? std::optional(trend::now()) : std::nullopt;
    m_pause->setText(paused ? tr("Go on") : tr("Pause"));
    refresh();
}

void TrendPage::openIncident(const trend::IncidentEntry &entry)
{
    using Loaded = std::shared_ptr<values::Result<trend::Incident>>;
    m_disk.run(
        this,
        [folder = m_recorder.archive().folder(), entry]() -> Loaded {
            return std::make_shared<values::Result<trend::Incident>>(trend::Archive {folder}.load(entry));
        },
        [this](const Loaded &loaded) {
            if (*loaded)
                showIncident(std::move(**loaded));
            else
                m_card->setReason(tr("This incident cannot be read: %1").arg(loaded->error().detail));
        });
}

void TrendPage::showIncident(trend::Incident incident)
{
    m_model->setTracks({}); // before its tracks go
    m_incident = std::move(incident);
    m_live->show();
    m_pause->setEnabled(false);
    m_span->setEnabled(false);
    setTracks();
}

void TrendPage::backToLive()
{
    m_model->setTracks({});
    m_incident.reset();
    m_live->hide();
    m_pause->setEnabled(true);
    m_span->setEnabled(true);
    setTracks();
}

void TrendPage::pick() { (new dialogs::SignalPicker(m_recorder, m_profile.dialect(), this))->show(); }

void TrendPage::removeSelected()
{
    QList<trend::Signal> gone;
    for (const QModelIndex &index : m_table->selectionModel()->selectedRows())
        gone << m_model->signalOf(index.row());
    if (m_incident)
        return;
    for (const trend::Signal &signal : gone)
        m_recorder.remove(signal);
}

void TrendPage::chooseFile()
{
    const QString name =
        QStringLiteral("%1 %2.csv")
            .arg(m_profile.name, trend::toLocalTime(range().to).toUTC().toString(u"yyyyMMdd'T'HHmmss'Z'"));
    widgets::askForPath({"trendExportDialog", widgets::PathKind::NewFile, tr("Export what is in view"), name,
                            {tr("CSV files (*.csv)")}, QStringLiteral("csv")},
        this, [this](const QString &path) {
            if (const auto written = exportTo(path); !written)
                m_card->setReason(tr("The file could not be written: %1").arg(written.error().detail));
        });
}

values::Result<void> TrendPage::exportTo(const QString &path) const
{
    return disk::replaceFile(path, trend::toCsv(m_model->shown(), m_plot->range()));
}

void TrendPage::dragEnterEvent(QDragEnterEvent *event)
{
    if (event->mimeData()->hasFormat(QLatin1String(trend::mimeType)))
        event->acceptProposedAction();
}

void TrendPage::dropEvent(QDropEvent *event)
{
    for (const trend::Signal &signal : trend::fromMime(event->mimeData()->data(QLatin1String(trend::mimeType))))
        m_recorder.add(signal);
    event->acceptProposedAction();
}

void TrendPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    m_pace.start();
    refresh();
}

void TrendPage::hideEvent(QHideEvent *event)
{
    Page::hideEvent(event);
    m_pace.stop();
}

} // namespace pages
