// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/announcer.h"

#include "ui/alarmwords.h"
#include <QAccessible>
#include <QWidget>

namespace ui {

Announcer::Announcer(const robot::AlarmLog &alarms, const protocol::TextCodec &codec, QWidget *view)
    : QObject(view), m_codec {codec}, m_view {view}
{
    connect(&alarms, &robot::AlarmLog::alarmsCame, this, &Announcer::announce);
}

/// Of the window in use; of the main window if none is.
QWidget *Announcer::speaker() const
{
    const auto fields = m_view->findChildren<QWidget *>(QStringLiteral("stripAlarm"));
    const auto inUse = std::ranges::find_if(fields, [](const QWidget *field) { return field->isActiveWindow(); });
    return inUse != fields.end() ? *inUse : fields.value(0);
}

void Announcer::announce(const QList<journal::Sighting> &alarms)
{
    QWidget *field = speaker();
    if (alarms.isEmpty() || !field)
        return;
    const auto &newest = alarms.last().alarm;
    const QString words = tr("New alarm %1: %2").arg(newest.alarm.code).arg(alarmText(newest, m_codec));
    field->setAccessibleDescription(words);
    QAccessibleEvent event(field, QAccessible::Alert);
    QAccessible::updateAccessibility(&event);
    Q_EMIT announced(words);
}

} // namespace ui
