// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/variablespage.h"

#include "ui/dialogs/numberingdialog.h"
#include "ui/pages/registerspage.h"
#include "ui/widgets/question.h"
#include "ui/widgets/text.h"
#include <QJsonArray>
#include <QMenu>
#include <QPushButton>
#include <QTabBar>

namespace pages {

using variables::Reference;

namespace {

const QString watchPagesSubject = QStringLiteral("watchPages");
const QString pagesKey = QStringLiteral("pages");
const QString nameKey = QStringLiteral("name");
const QString variablesKey = QStringLiteral("variables");

} // namespace

VariablesPage::VariablesPage(const Context &context, QWidget *parent)
    : Page(context, parent),
      m_store {context.store},
      m_notes {context.station.notes()},
      m_orders {context.station.orders},
      m_guard {context.station.numbering},
      m_format {robot::formatOf(context.station.profile())},
      m_desk {context.station.state(), context.station.history, context.station.edits, context.station.names, m_format,
          context.station.profile().dialect()},
      m_sheet {new VariableSheet(context, m_desk, robot::Act::WriteVariable)},
      m_bar {new QTabBar},
      m_test {new QPushButton(tr("Verify…"))}
{
    m_bar->setObjectName(QStringLiteral("tabs"));
    m_bar->setAccessibleName(tr("Kind of variable"));
    m_bar->setDrawBase(false);
    m_bar->setExpanding(false);
    m_bar->setContextMenuPolicy(Qt::CustomContextMenu);
    m_test->setObjectName(QStringLiteral("numberingButton"));
    m_test->setToolTip(tr("Compares two variables with the pendant. It only reads."));
    for (const variables::Kind kind : variables::allKinds) {
        if (kind != variables::Kind::M)
            addTab(letters(kind), allOf(kind, m_desk.dialect), false);
    }
    loadWatchPages();
    auto *add = new QPushButton(tr("New watch page…"));
    add->setObjectName(QStringLiteral("newWatchPage"));
    add->setProperty("link", true);
    m_sheet->addToHead(m_bar);
    m_sheet->addToHead(add);
    m_sheet->addToFoot(m_test);
    m_sheet->table()->setContextMenuPolicy(Qt::CustomContextMenu);
    setContent(sheetCard(m_sheet));
    connect(m_bar, &QTabBar::currentChanged, this, [this](int tab) { m_sheet->show(m_tabs[tab].model); });
    connect(m_bar, &QWidget::customContextMenuRequested, this, &VariablesPage::openTabMenu);
    connect(m_sheet->table(), &QWidget::customContextMenuRequested, this, &VariablesPage::openMenu);
    connect(m_sheet, &VariableSheet::topicsChanged, this, &Page::topicsChanged);
    connect(m_sheet, &VariableSheet::wanted, this, &VariablesPage::goTo);
    connect(m_test, &QPushButton::clicked, this, &VariablesPage::openNumberingTest);
    connect(&m_orders, &robot::Orders::situationChanged, this, &VariablesPage::showNumbering);
    connect(add, &QPushButton::clicked, this, [this] {
        widgets::askForLine("watchPageName", tr("New watch page"), tr("Name of the page"), this,
            [this](const QString &name) { addWatchPage(name); });
    });
    m_sheet->show(m_tabs.first().model);
    showNumbering();
}

QList<robot::TopicRange> VariablesPage::topics() const { return m_sheet->topics(); }

void VariablesPage::addTab(const QString &name, const QList<Reference> &variables, bool isWatch)
{
    m_tabs << Tab {name, new models::VariableModel(m_desk, variables, this), isWatch};
    m_bar->addTab(isWatch ? tr("Watch: %1").arg(name) : name);
}

void VariablesPage::goTo(const Reference &variable)
{
    for (int tab = 0; tab < m_tabs.size(); ++tab) {
        if (!m_tabs[tab].isWatch && m_tabs[tab].model->rowOf(variable) >= 0) {
            m_bar->setCurrentIndex(tab);
            m_sheet->select(variable);
            return;
        }
    }
}

void VariablesPage::loadWatchPages()
{
    const QJsonArray pages = m_notes.read(watchPagesSubject)[pagesKey].toArray();
    for (const QJsonValue page : pages) {
        QList<Reference> variables;
        for (const QJsonValue text : page[variablesKey].toArray()) {
            if (const auto variable = variables::referenceFromText(text.toString(), m_desk.dialect))
                variables << *variable;
        }
        addTab(page[nameKey].toString(), variables, true);
    }
}

void VariablesPage::keepWatchPages()
{
    QJsonArray pages;
    for (const Tab &tab : m_tabs) {
        if (!tab.isWatch)
            continue;
        QJsonArray list;
        for (const Reference &variable : tab.model->variables())
            list << toString(variable);
        pages << QJsonObject {{nameKey, tab.name}, {variablesKey, list}};
    }
    const QJsonObject json = pages.isEmpty() ? QJsonObject {} : QJsonObject {{pagesKey, pages}};
    m_notes.write(watchPagesSubject, json);
}

void VariablesPage::addWatchPage(const QString &name)
{
    addTab(name, {}, true);
    keepWatchPages();
    m_bar->setCurrentIndex(m_bar->count() - 1);
}

void VariablesPage::openTabMenu(const QPoint &at)
{
    const int tab = m_bar->tabAt(at);
    if (tab < 0 || !m_tabs[tab].isWatch)
        return;
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Delete this watch page"), this, [this, tab] {
        const Tab gone = m_tabs.takeAt(tab);
        m_bar->setCurrentIndex(0);
        m_bar->removeTab(tab);
        gone.model->deleteLater();
        keepWatchPages();
    });
    menu->popup(m_bar->mapToGlobal(at));
}

void VariablesPage::openMenu(const QPoint &at)
{
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (int tab = 0; tab < m_tabs.size(); ++tab) {
        if (m_tabs[tab].isWatch && tab != m_bar->currentIndex())
            menu->addAction(tr("Show on the watch page “%1”").arg(m_tabs[tab].name), this, [this, tab] { watch(tab); });
    }
    if (m_tabs[m_bar->currentIndex()].isWatch)
        menu->addAction(tr("Take off this watch page"), this, &VariablesPage::unwatch);
    if (menu->isEmpty())
        menu->addAction(tr("There is no watch page yet."))->setEnabled(false);
    menu->popup(m_sheet->table()->viewport()->mapToGlobal(at));
}

void VariablesPage::watch(int page)
{
    for (const QModelIndex &row : m_sheet->table()->selectionModel()->selectedRows())
        m_tabs[page].model->append(m_sheet->model()->at(row.row()));
    keepWatchPages();
}

void VariablesPage::unwatch()
{
    if (const QModelIndex current = m_sheet->table()->currentIndex(); current.isValid())
        m_sheet->model()->removeAt(current.row());
    keepWatchPages();
}

void VariablesPage::openNumberingTest()
{
    auto *dialog = new dialogs::NumberingDialog(m_orders, this);
    connect(dialog, &dialogs::NumberingDialog::verified, this, &VariablesPage::onVerified);
    dialog->show();
}

void VariablesPage::onVerified(protocol::Numbering numbering)
{
    m_guard.keep(numbering, m_store);
    showNumbering();
}

void VariablesPage::showNumbering()
{
    const settings::Profile &profile = m_orders.controller().profile();
    const bool isVerified = m_orders.situation().isNumberingVerified;
    const QString first =
        profile.numbering == protocol::Numbering::FromZero ? QStringLiteral("0") : QStringLiteral("1");
    const QString date = QLocale().toString(profile.numberingVerified.toLocalTime().date(), QLocale::ShortFormat);
    m_sheet->setNote(!isVerified
            ? tr("Numbering not verified: nothing is written before it was compared with the pendant.")
            : profile.isSimulation ? tr("Simulation: number %1 on the network is B000.").arg(first)
                                   : tr("Numbering verified %1: number %2 on the network is B000.").arg(date, first));
    m_test->setVisible(!profile.isSimulation);
}

} // namespace pages
