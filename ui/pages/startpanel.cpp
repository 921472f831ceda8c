// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/startpanel.h"

#include "settings/profilestore.h"
#include "ui/actioncatalog.h"
#include "ui/backupage.h"
#include "ui/pages/start/recenttile.h"
#include "ui/pages/start/setupcard.h"
#include "ui/widgets/card.h"
#include <QHBoxLayout>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcut>

namespace pages {

using settings::RecentProfile;

namespace {

constexpr int widest = 860;
constexpr int mostRecent = 5;

/// The controller that the window offers comes first, whether the store knows it or not.
QList<RecentProfile> controllers(const Context &context)
{
    QList<RecentProfile> found = context.store.recent(mostRecent);
    if (context.station.profile().host.isEmpty())
        return found;
    RecentProfile offered {context.station.profile(), {}};
    found.removeIf([&offered](const RecentProfile &one) {
        if (one.profile.name != offered.profile.name)
            return false;
        offered.connected = one.connected;
        return true;
    });
    found.prepend(offered);
    return found.mid(0, mostRecent);
}

QWidget *offer(const QString &title, const QString &sentence, QPushButton *button)
{
    auto *card = new widgets::Card(title);
    card->body()->addWidget(widgets::sentence(sentence, ui::Role::Text2));
    card->body()->addStretch();
    card->body()->addWidget(button, 0, Qt::AlignLeft);
    return card;
}

} // namespace

StartPanel::StartPanel(const Context &context, QWidget *parent) : QWidget(parent), m_context {context}
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter})
        connect(new QShortcut(QKeySequence(key), this), &QShortcut::activated, this, &StartPanel::press);
}

void StartPanel::showEvent(QShowEvent *event)
{
    make();
    QWidget::showEvent(event);
}

void StartPanel::make()
{
    if (QLayoutItem *old = layout()->takeAt(0)) {
        old->widget()->deleteLater(); // it may be one of its buttons that led here
        old->widget()->hide();
        old->widget()->setParent(nullptr);
        delete old;
    }
    auto *scroll = new QScrollArea;
    scroll->setObjectName(QStringLiteral("startScroll"));
    scroll->setAccessibleName(tr("Start"));
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(makeContent());
    layout()->addWidget(scroll);
    scroll->show();
}

QWidget *StartPanel::makeContent()
{
    auto *inner = new QWidget;
    inner->setMaximumWidth(widest);
    auto *column = new QVBoxLayout(inner);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(ui::space::gap);
    column->addWidget(widgets::text(tr("Not connected"), ui::Type::Hold, ui::Role::Text1));
    column->addWidget(widgets::sentence(
        tr("Nothing is read and nothing is shown. Connecting only reads: nothing is written, started or moved by it."),
        ui::Role::Text2));
    const bool isFirstRun = controllers(m_context).isEmpty();
    if (isFirstRun)
        addOffers(column);
    else
        addRecent(column);
    column->addWidget(new start::SetupCard(m_context.station.profile().model));
    auto *result = new QWidget;
    auto *centre = new QVBoxLayout(result);
    centre->setContentsMargins(ui::space::page, ui::space::page, ui::space::page, ui::space::page);
    centre->addStretch(2);
    auto *row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(inner, 100);
    row->addStretch(1);
    centre->addLayout(row);
    centre->addStretch(3);
    return result;
}

QPushButton *StartPanel::actionButton(const QString &name, const QString &words, int action)
{
    const QAction *trigger = m_context.actions.action(ui::ActionId(action));
    auto *button = new QPushButton(words);
    button->setObjectName(name);
    button->setToolTip(trigger->shortcut().toString(QKeySequence::NativeText));
    connect(button, &QPushButton::clicked, trigger, &QAction::trigger);
    return button;
}

/// Nothing was ever connected: what one can begin with.
void StartPanel::addOffers(QVBoxLayout *column)
{
    auto *connectButton =
        actionButton(QStringLiteral("connectButton"), tr("Connect to a controller…"), int(ui::ActionId::Connect));
    connectButton->setProperty("primary", true);
    m_primary = connectButton;
    auto *row = new QHBoxLayout;
    row->setSpacing(ui::space::gap);
    row->addWidget(offer(tr("A controller in your network"),
                       tr("Enter its name or address. Pendesk checks step by step whether it answers, and says what "
                          "is wrong where it does not."),
                       connectButton),
        1);
    row->addWidget(offer(tr("No robot at hand"),
                       tr("The demo brings a simulated controller in this program. Everything can be tried with it, "
                          "and no robot moves."),
                       actionButton(QStringLiteral("demoButton"), tr("Open the demo"), int(ui::ActionId::Demo))),
        1);
    column->addLayout(row);
}

/// The last one filled, the others raised; then the two other ways.
void StartPanel::addRecent(QVBoxLayout *column)
{
    auto *card = new widgets::Card(tr("Recent controllers"));
    card->body()->setSpacing(8);
    const QDateTime now = QDateTime::currentDateTime();
    int index = 0;
    for (const RecentProfile &recent : controllers(m_context)) {
        auto *tile = new start::RecentTile(recent, now, index == 0);
        const bool isOffered = recent.profile.name == m_context.station.profile().name;
        tile->setObjectName(
            isOffered ? QStringLiteral("reconnectButton") : QStringLiteral("recentButton%1").arg(index));
        const auto connectTo = [actions = &m_context.actions, name = recent.profile.name, isOffered] {
            if (isOffered)
                actions->action(ui::ActionId::Reconnect)->trigger();
            else
                Q_EMIT actions->profileChosen(name);
        };
        connect(tile, &QPushButton::clicked, this, connectTo);
        if (!recent.profile.isSimulation) {
            const auto *age =
                new ui::BackupAge(recent.profile.folderName(), m_context.store.notes(recent.profile), tile);
            connect(age, &ui::BackupAge::told, tile, &start::RecentTile::showBackup);
        }
        if (index++ == 0)
            m_primary = tile;
        card->body()->addWidget(tile);
    }
    column->addWidget(card);
    auto *row = new QHBoxLayout;
    row->setSpacing(10);
    row->addWidget(
        actionButton(QStringLiteral("connectButton"), tr("Another controller…"), int(ui::ActionId::Connect)));
    if (!m_context.station.profile().isSimulation)
        row->addWidget(actionButton(QStringLiteral("demoButton"), tr("Open the demo"), int(ui::ActionId::Demo)));
    row->addStretch();
    column->addLayout(row);
}

/// Enter: the button with the focus, wherever it is, else the filled one. The entry of the page in view, which has the
/// focus in the beginning, would do nothing.
void StartPanel::press()
{
    auto *focused = qobject_cast<QAbstractButton *>(window()->focusWidget());
    QAbstractButton *button = focused && !focused->isChecked() ? focused : m_primary;
    if (button)
        button->click();
}

} // namespace pages
