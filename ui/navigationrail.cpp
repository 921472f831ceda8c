// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/navigationrail.h"

#include "ui/icons.h"
#include "ui/pagecatalog.h"
#include "ui/stationlist.h"
#include "ui/widgets/scrollcolumn.h"
#include "ui/widgets/text.h"
#include <QButtonGroup>
#include <QFocusEvent>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui {

namespace {

QLabel *heading(const QString &words)
{
    QLabel *label = widgets::text(words, Type::Heading, Role::Text2);
    label->setContentsMargins(8, 8, 8, 2);
    return label;
}

/// Of an entry with its words in bold, as they are while its page is open.
int leastWidth(const QString &words)
{
    QFont bold = font(Type::Body);
    bold.setWeight(QFont::DemiBold);
    constexpr int margins = 2 * 9; // of the style sheet, with the border
    constexpr int gap = 6; // between icon and words
    return margins + space::icon + gap + QFontMetrics(bold).horizontalAdvance(words);
}

QPushButton *entry(const QString &name, const QString &words, const QIcon &icon)
{
    auto *button = new QPushButton(icon, words);
    button->setObjectName(name);
    button->setProperty("rail", true);
    button->setIconSize({space::icon, space::icon});
    button->setMinimumWidth(leastWidth(words));
    return button;
}

QPushButton *actionEntry(QAction *action)
{
    auto *button = entry(action->objectName() + QStringLiteral("Entry"), action->text(), action->icon());
    const auto follow = [button, action] {
        button->setEnabled(action->isEnabled());
        button->setToolTip(action->toolTip());
    };
    QObject::connect(action, &QAction::changed, button, follow);
    QObject::connect(button, &QPushButton::clicked, action, &QAction::trigger);
    follow();
    return button;
}

} // namespace

NavigationRail::NavigationRail(
    const station::Fleet &fleet, const settings::Profile &shown, const Actions &actions, QWidget *parent)
    : QWidget(parent), m_stations {new StationList(fleet, shown)}, m_pages {new QButtonGroup(this)}
{
    auto *entries = new QWidget;
    auto *column = new QVBoxLayout(entries);
    column->setContentsMargins(10, 8, 10, 10);
    column->setSpacing(2);
    column->addWidget(heading(tr("CONTROLLERS")));
    column->addWidget(m_stations);
    addPages(column);
    column->addStretch();
    addActions(column, actions);
    addScroll(entries);
    connect(m_stations, &StationList::chosen, this, [&actions](const QUuid &id) { Q_EMIT actions.stationChosen(id); });
    connect(m_stations, &StationList::moreWanted, this, [this] {
        const auto catalog = pageCatalog();
        const auto fleetPage = std::ranges::find_if(
            catalog, [](const PageRow &row) { return QLatin1String(row.id) == QLatin1String("fleet"); });
        Q_EMIT pageChosen(int(fleetPage - catalog.begin()));
    });
}

/// In a low window the entries are scrolled.
void NavigationRail::addScroll(QWidget *entries)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 1, 0); // the line at the right
    auto *area = new widgets::ScrollColumn(entries);
    column->addWidget(area);
    setFixedWidth(std::max(space::rail, area->minimumSizeHint().width() + 1));
}

void NavigationRail::addPages(QVBoxLayout *column)
{
    column->addWidget(heading(tr("PAGES")));
    int row = 0;
    for (const PageRow &page : pageCatalog()) {
        QPushButton *button =
            entry(QLatin1String(page.id) + QStringLiteral("Entry"), title(page), icon(QLatin1String(page.icon)));
        button->setCheckable(true);
        button->setChecked(row == 0);
        button->setShortcut(QKeySequence(QLatin1String(page.shortcut)));
        m_pages->addButton(button, row++);
        column->addWidget(button);
    }
    connect(m_pages, &QButtonGroup::idClicked, this, &NavigationRail::pageChosen);
}

void NavigationRail::addActions(QVBoxLayout *column, const Actions &actions)
{
    column->addWidget(heading(tr("CONNECTION")));
    for (const ActionId id : {ActionId::Connect, ActionId::Disconnect, ActionId::Diagnose})
        column->addWidget(actionEntry(actions.action(id)));
    auto *menu = new QMenu(this);
    for (const ActionRow &row : actionCatalog())
        menu->addAction(actions.action(row.id));
    QPushButton *more = entry(QStringLiteral("menuEntry"), tr("Menu"), icon(QStringLiteral("menu")));
    connect(more, &QPushButton::clicked, menu, [more, menu] {
        menu->popup(more->mapToGlobal(QPoint(more->width(), more->height() - menu->sizeHint().height())));
    });
    more->setShortcut(QKeySequence(QStringLiteral("F10")));
    column->addWidget(more);
}

void NavigationRail::showPage(int row) { m_pages->button(row)->setChecked(true); }

void NavigationRail::showBackup(const widgets::Word &age) { m_stations->showBackup(age); }

/// Not a focus proxy: Tab would go from before the rail to the proxy, past the controllers above the pages.
void NavigationRail::focusInEvent(QFocusEvent *event) { m_pages->button(0)->setFocus(event->reason()); }

void NavigationRail::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setPen(color(Role::Border, this));
    painter.drawLine(width() - 1, 0, width() - 1, height());
}

} // namespace ui
