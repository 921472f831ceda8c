// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QObject>

namespace robot {
class Controller;
}

namespace settings {
class ProfileStore;
}

namespace ui {

/// Writes down when a controller of the store answered, and tells the first time. A simulation and a controller that
/// the store does not know leave no trace.
class FirstContact : public QObject
{
    Q_OBJECT

public:
    /// Both must outlive it.
    FirstContact(const robot::Controller &controller, settings::ProfileStore &store, QObject *parent = nullptr);

Q_SIGNALS:
    /// The controller is monitored for the first time: a person should see what it allows. Once for each profile, and
    /// never while a dialog is open: then it is told at the next connection.
    void readinessDue();

private:
    void onLinkStateChanged();
    void tell();

    const robot::Controller &m_controller;
    settings::ProfileStore &m_store;
};

} // namespace ui
