// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/iopage.h"

#include "protocol/codes.h"
#include "ui/dialogs/iowritedialog.h"
#include "ui/pages/registerspage.h"
#include "ui/widgets/flow.h"
#include "ui/widgets/gotoedit.h"
#include "ui/widgets/lampdelegate.h"
#include "ui/widgets/logicstrip.h"
#include "ui/widgets/text.h"
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>

namespace pages {

using names::Signal;
using protocol::IoArea;

namespace {

QString title(IoArea area)
{
    switch (area) {
    case IoArea::UserInput: return IoPage::tr("User in");
    case IoArea::UserOutput: return IoPage::tr("User out");
    case IoArea::ExternalInput: return IoPage::tr("External in");
    case IoArea::NetworkInput: return IoPage::tr("Network in");
    case IoArea::ExternalOutput: return IoPage::tr("External out");
    case IoArea::NetworkOutput: return IoPage::tr("Network out");
    case IoArea::SystemInput: return IoPage::tr("System in");
    case IoArea::SystemOutput: return IoPage::tr("System out");
    case IoArea::PanelInput: return IoPage::tr("Panel");
    case IoArea::AuxiliaryRelay: return IoPage::tr("Relays");
    case IoArea::ControlStatus: return IoPage::tr("Control");
    case IoArea::PseudoInput: return IoPage::tr("Pseudo in");
    }
    return {};
}

} // namespace

IoPage::IoPage(const Context &context, QWidget *parent)
    : Page(context, parent),
      m_context {context},
      m_dialect {context.station.profile().dialect()},
      m_watch {context.station.watch},
      m_bar {new QTabBar},
      m_goTo {new widgets::GoToEdit(this)},
      m_sentence {widgets::sentence({}, ui::Role::Text2)},
      m_complaint {widgets::text({}, ui::Type::Body, ui::Role::Amber)},
      m_stack {new QStackedWidget},
      m_table {new widgets::Table},
      m_watchTable {new widgets::Table}
{
    m_table->setObjectName(QStringLiteral("ioTable"));
    m_table->setAccessibleName(tr("Signals"));
    m_table->setItemDelegate(new widgets::LampDelegate(this));
    m_table->setEditTriggers(QAbstractItemView::EditKeyPressed);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->verticalHeader()->setDefaultSectionSize(widgets::LampDelegate::rowHeight);
    m_table->verticalHeader()->setFixedWidth(84);
    m_table->setContextMenuPolicy(Qt::CustomContextMenu);
    m_table->installEventFilter(this);
    m_sentence->setObjectName(QStringLiteral("sentence"));
    m_complaint->setObjectName(QStringLiteral("complaint"));
    auto *content = new QWidget;
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(head());
    column->addWidget(m_sentence);
    column->addWidget(m_stack, 1);
    m_stack->addWidget(m_table);
    m_stack->addWidget(watchTab(context));
    addAreas(context);
    setContent(sheetCard(content));
    connect(m_bar, &QTabBar::currentChanged, this, &IoPage::showTab);
    connect(m_table, &widgets::Table::rowsInViewChanged, this, &Page::topicsChanged);
    connect(m_table, &QTableView::doubleClicked, this, &IoPage::act);
    connect(m_table, &QWidget::customContextMenuRequested, this, &IoPage::openMenu);
    connect(&m_watch, &robot::SignalWatch::listChanged, this, &Page::topicsChanged);
    connect(&context.station.names, &robot::NameBook::fetchChanged, this, &IoPage::showSentence);
    showTab(0);
}

QWidget *IoPage::head()
{
    m_bar->setObjectName(QStringLiteral("tabs"));
    m_bar->setAccessibleName(tr("Area of signals"));
    m_bar->setDrawBase(false);
    m_bar->setExpanding(false);
    m_bar->setUsesScrollButtons(true);
    connect(m_goTo, &QLineEdit::returnPressed, this, &IoPage::onGoTo);
    auto *result = new QWidget;
    auto *row = new widgets::Flow(result);
    row->addWidget(m_bar);
    row->addStretch();
    row->addWidget(m_complaint);
    row->addWidget(m_goTo);
    return result;
}

QWidget *IoPage::watchTab(const Context &context)
{
    m_watchTable->setObjectName(QStringLiteral("watchTable"));
    m_watchTable->setAccessibleName(tr("Watched signals"));
    m_watchTable->setModel(
        new models::WatchModel(context.station.state(), m_watch, context.station.names, m_dialect, this));
    m_watchTable->verticalHeader()->hide();
    m_watchTable->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_watchTable->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_watchTable->horizontalHeader()->setStretchLastSection(true);
    m_watchTable->setColumnWidth(models::WatchModel::Name, 240);
    m_watchTable->installEventFilter(this);
    auto *reset = new QPushButton(tr("Count from 0"));
    reset->setObjectName(QStringLiteral("resetCounters"));
    connect(reset, &QPushButton::clicked, &m_watch, &robot::SignalWatch::reset);
    auto *scroll = new QScrollArea;
    scroll->setWidget(new widgets::LogicStrip(m_watch, context.station.names));
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->viewport()->setAutoFillBackground(false);
    scroll->widget()->setAutoFillBackground(false);
    auto *result = new QWidget;
    auto *column = new QVBoxLayout(result);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_watchTable, 1);
    column->addWidget(reset, 0, Qt::AlignLeft);
    column->addWidget(scroll, 1);
    return result;
}

void IoPage::addAreas(const Context &context)
{
    for (const auto &[area, groups] : m_dialect.io) {
        auto *model = new models::IoModel(context.station.state(), context.station.names, m_dialect, groups, this);
        connect(model, &models::IoModel::refusedRowsChanged, this, &IoPage::showSentence);
        m_models << model;
        m_bar->addTab(title(area));
    }
    m_bar->addTab(tr("Watch"));
}

bool IoPage::isWatchTab() const { return m_bar->currentIndex() >= m_models.size(); }

models::IoModel *IoPage::model() const { return isWatchTab() ? nullptr : m_models[m_bar->currentIndex()]; }

IoArea IoPage::area() const { return m_dialect.io[std::size_t(m_bar->currentIndex())].area; }

void IoPage::showTab(int)
{
    m_complaint->clear();
    if (models::IoModel *shown = model()) {
        m_table->setModel(shown);
        m_table->setCurrentIndex(shown->index(0, 0));
    }
    m_stack->setCurrentIndex(isWatchTab() ? 1 : 0);
    showSentence();
    Q_EMIT topicsChanged();
}

QList<robot::TopicRange> IoPage::topics() const
{
    QList<robot::TopicRange> result = m_watch.topics();
    const auto rows = m_table->rowsInView();
    if (const auto *shown = model(); shown && rows.count() > 0)
        result << shown->groups(rows.first, std::min(rows.last, shown->rowCount() - 1));
    return result;
}

void IoPage::goTo(const Signal &signal)
{
    for (int tab = 0; tab < m_models.size(); ++tab) {
        if (const QModelIndex index = m_models[tab]->indexOf(signal); index.isValid()) {
            m_bar->setCurrentIndex(tab);
            m_table->setCurrentIndex(index);
            m_table->scrollTo(index, QAbstractItemView::PositionAtCenter);
            m_table->setFocus();
            return;
        }
    }
}

/// A signal in either notation, or the words of its name.
void IoPage::onGoTo()
{
    auto signal = names::signalFromText(m_goTo->text(), m_dialect);
    if (!signal && !m_goTo->text().trimmed().isEmpty()) {
        if (const auto found = m_context.station.names.names().findSignals(m_goTo->text(), 1); !found.isEmpty())
            signal = found.first();
    }
    m_complaint->setText(signal ? QString() : signal.error().detail);
    if (signal)
        goTo(*signal);
}

void IoPage::act(const QModelIndex &index)
{
    if (!index.isValid())
        return;
    if (area() != IoArea::NetworkInput) {
        m_complaint->setText(tr("Over HSES only network inputs can be written: this lamp only shows."));
        return;
    }
    const Signal signal = model()->signalAt(index);
    const QString name = m_context.station.names.names().of(signal).text;
    (new dialogs::IoWriteDialog(m_context.station.orders, signal, name, this))->show();
}

bool IoPage::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::KeyPress)
        return Page::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent *>(event)->key();
    const bool isEnter = key == Qt::Key_Return || key == Qt::Key_Enter;
    const bool isEditing = m_table->viewport()->isAncestorOf(QApplication::focusWidget()); // Return is the editor's own
    if (watched == m_table && !isEditing && (isEnter || key == Qt::Key_Space))
        return act(m_table->currentIndex()), true;
    if (watched == m_watchTable && key == Qt::Key_Delete && m_watchTable->currentIndex().isValid()) {
        m_watch.remove(m_watch.traces()[m_watchTable->currentIndex().row()].signal);
        return true;
    }
    return Page::eventFilter(watched, event);
}

void IoPage::openMenu(const QPoint &at)
{
    const QModelIndex index = m_table->indexAt(at);
    if (!index.isValid())
        return;
    const Signal signal = model()->signalAt(index);
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Write…"), this, [this, index] { act(index); });
    menu->addAction(tr("Name it here…"), this, [this, index] { m_table->edit(index); });
    if (m_context.station.names.names().of(signal).isLocal)
        menu->addAction(
            tr("Take the local name away"), this, [this, signal] { m_context.station.names.setLocalName(signal, {}); });
    if (m_watch.isWatched(signal))
        menu->addAction(tr("Watch no longer"), this, [this, signal] { m_watch.remove(signal); });
    else
        menu->addAction(tr("Watch"), this, [this, signal] { m_watch.add(signal); });
    menu->addAction(
        tr("Copy the address"), this, [signal] { QGuiApplication::clipboard()->setText(toString(signal)); });
    menu->popup(m_table->viewport()->mapToGlobal(at));
}

/// What can be done here, and what the controller refuses: each reason once.
void IoPage::showSentence()
{
    QStringList sentences;
    if (isWatchTab())
        sentences << tr("Edges are counted from what is read four times a second; shorter pulses are not seen.");
    else if (area() == IoArea::NetworkInput)
        sentences << tr("Network inputs can be written: press Enter on a lamp.");
    else
        sentences << tr("These lamps only show: over HSES only network inputs can be written.");
    const auto refused = model() ? model()->refusedRows() : QList<int> {};
    if (!refused.isEmpty()) {
        const Signal first = model()->signalAt(model()->index(refused.first(), 0));
        const auto &reading = m_context.station.state().reading<robot::Kind::IoGroup>(first.group);
        sentences << tr("%n group(s) from %1 on are refused: %2.", nullptr, int(refused.size()))
                         .arg(toString(first), reading.refusal ? protocol::explain(*reading.refusal) : QString());
    }
    const auto &fetch = m_context.station.names.signalFetch();
    if (fetch.error)
        sentences << tr("The controller's names are not known: %1.").arg(protocol::explain(*fetch.error));
    else if (!fetch.warnings.isEmpty())
        sentences << tr("%n line(s) of IONAME.DAT could not be read.", nullptr, fetch.warnings.count());
    m_sentence->setText(sentences.join(u' '));
    widgets::setTextRole(m_sentence, refused.isEmpty() ? ui::Role::Text2 : ui::Role::Amber);
}

} // namespace pages
