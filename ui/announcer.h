// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/text.h"
#include "robot/alarmlog.h"

class QWidget;

namespace ui {

/// Tells assistive technology of new alarms as they come, whichever page and window is in use: the alarm field of the
/// strip that the person sees speaks, once for each alarm that came last.
class Announcer : public QObject
{
    Q_OBJECT

public:
    /// `view` has the strips; both must outlive the announcer.
    Announcer(const robot::AlarmLog &alarms, const protocol::TextCodec &codec, QWidget *view);

Q_SIGNALS:
    /// Assistive technology was told.
    void announced(const QString &words);

private:
    void announce(const QList<journal::Sighting> &alarms);
    [[nodiscard]] QWidget *speaker() const;

    protocol::TextCodec m_codec;
    QWidget *m_view;
};

} // namespace ui
