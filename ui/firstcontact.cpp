// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/firstcontact.h"

#include "robot/controller.h"
#include "settings/profilestore.h"
#include "ui/widgets/sheetlayer.h"
#include <QApplication>

namespace ui {

using robot::LinkState;

namespace {

bool isSheetOpen()
{
    const auto windows = QApplication::topLevelWidgets();
    return std::ranges::any_of(windows, [](const QWidget *window) {
        const auto *layer = window->findChild<widgets::SheetLayer *>(QString(), Qt::FindDirectChildrenOnly);
        return layer && layer->isOpen();
    });
}

} // namespace

FirstContact::FirstContact(const robot::Controller &controller, settings::ProfileStore &store, QObject *parent)
    : QObject(parent), m_controller {controller}, m_store {store}
{
    connect(&controller, &robot::Controller::linkStateChanged, this, &FirstContact::onLinkStateChanged);
}

void FirstContact::onLinkStateChanged()
{
    const settings::Profile &profile = m_controller.profile();
    if (m_controller.linkState() != LinkState::Monitoring || profile.isSimulation || !m_store.find(profile.name))
        return;
    m_store.noteConnected(profile.name, m_controller.linkStateSince());
    QMetaObject::invokeMethod(this, &FirstContact::tell, Qt::QueuedConnection); // the connection dialog closes first
}

void FirstContact::tell()
{
    const QString name = m_controller.profile().name;
    if (m_controller.linkState() != LinkState::Monitoring || m_store.isReadinessSeen(name) || isSheetOpen())
        return;
    m_store.setReadinessSeen(name);
    Q_EMIT readinessDue();
}

} // namespace ui
