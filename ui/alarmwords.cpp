// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/alarmwords.h"

#include <QCoreApplication>

using journal::AlarmState;
using values::AlarmHistoryClass;

namespace ui {

namespace {

struct Alarms {
    Q_DECLARE_TR_FUNCTIONS(Alarms)
};

} // namespace

QString title(AlarmHistoryClass list)
{
    switch (list) {
    case AlarmHistoryClass::Major: return Alarms::tr("Major");
    case AlarmHistoryClass::Minor: return Alarms::tr("Minor");
    case AlarmHistoryClass::UserSystem: return Alarms::tr("User, system");
    case AlarmHistoryClass::User: return Alarms::tr("User");
    case AlarmHistoryClass::Offline: break;
    }
    return Alarms::tr("Off-line");
}

QString word(AlarmState state)
{
    switch (state) {
    case AlarmState::Unacknowledged: return Alarms::tr("◆ unacknowledged");
    case AlarmState::Acknowledged: return Alarms::tr("■ acknowledged");
    case AlarmState::ClearedUnacknowledged: return Alarms::tr("▲ cleared, unacknowledged");
    case AlarmState::Cleared: break;
    }
    return Alarms::tr("□ cleared");
}

Role roleOf(AlarmState state)
{
    switch (state) {
    case AlarmState::Unacknowledged:
    case AlarmState::Acknowledged: return Role::Alarm;
    case AlarmState::ClearedUnacknowledged: return Role::Amber;
    case AlarmState::Cleared: break;
    }
    return Role::Text2;
}

QString alarmText(const values::AlarmWithTexts &alarm, const protocol::TextCodec &codec)
{
    QStringList parts;
    for (const QByteArrayView bytes : {alarm.alarm.name.bytes(), alarm.extra.bytes(), alarm.subText.bytes()}) {
        if (!bytes.isEmpty())
            parts += codec.decode(bytes).simplified();
    }
    return parts.join(QStringLiteral(" · "));
}

QString dataSentence(const values::AlarmData &data)
{
    if (data.type == values::AlarmDataType::None)
        return Alarms::tr("No sub code.");
    QString kind = values::toString(data.type);
    kind[0] = kind[0].toUpper();
    return Alarms::tr("%1: %2. As sent: %3, type %4.")
        .arg(kind, data.toString())
        .arg(data.value)
        .arg(quint32(data.type));
}

QString tableTime(const QDateTime &utc)
{
    return utc.isValid() ? utc.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")) : QString();
}

} // namespace ui
