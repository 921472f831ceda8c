// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/models/activealarmmodel.h"

#include "ui/alarmwords.h"
#include "ui/widgets/shown.h"
#include "ui/widgets/table.h"

namespace models {

using journal::AlarmState;
using robot::Freshness;
using robot::Kind;

namespace {

constexpr const char *activeTitles[] {
    QT_TRANSLATE_NOOP("models::ActiveAlarmModel", "State"),
    QT_TRANSLATE_NOOP("models::ActiveAlarmModel", "Code"),
    QT_TRANSLATE_NOOP("models::ActiveAlarmModel", "Sub code"),
    QT_TRANSLATE_NOOP("models::ActiveAlarmModel", "Text"),
    QT_TRANSLATE_NOOP("models::ActiveAlarmModel", "Controller time"),
    QT_TRANSLATE_NOOP("models::ActiveAlarmModel", "First seen"),
    QT_TRANSLATE_NOOP("models::ActiveAlarmModel", "Times"),
};
static_assert(std::size(activeTitles) == ActiveAlarmModel::columns);

bool isNumber(int column) { return column == ActiveAlarmModel::Code || column == ActiveAlarmModel::Count; }

bool isActive(const journal::ActiveAlarms::Entry &entry)
{
    return entry.sighting.state == AlarmState::Unacknowledged || entry.sighting.state == AlarmState::Acknowledged;
}

} // namespace

ActiveAlarmModel::ActiveAlarmModel(
    const robot::AlarmLog &log, const robot::RobotState &state, const protocol::TextCodec &codec, QObject *parent)
    : QAbstractTableModel(parent), m_log {log}, m_state {state}, m_codec {codec}, m_entries {log.alarms()}
{
    connect(&log, &robot::AlarmLog::alarmsChanged, this, &ActiveAlarmModel::update);
    connect(&state, &robot::RobotState::changed, this, &ActiveAlarmModel::onStateChanged);
    onStateChanged({Kind::Alarm, 1, 1});
}

/// Takes the list over row by row: what is gone is removed, what moved is moved, what is new is put in.
void ActiveAlarmModel::update()
{
    const auto sameAs = [](const Entry &one) {
        return [alarm = one.sighting.alarm](
                   const Entry &other) { return journal::isSameAlarm(alarm, other.sighting.alarm); };
    };
    const auto &now = m_log.alarms();
    for (int row = int(m_entries.size()); row-- > 0;) {
        if (std::any_of(now.begin(), now.end(), sameAs(m_entries[row])))
            continue;
        beginRemoveRows({}, row, row);
        m_entries.removeAt(row);
        endRemoveRows();
    }
    for (int row = 0; row < now.size(); ++row) {
        const auto found = std::find_if(m_entries.cbegin() + row, m_entries.cend(), sameAs(now[row]));
        const int from = int(found - m_entries.cbegin());
        if (from == m_entries.size()) {
            beginInsertRows({}, row, row);
            m_entries.insert(row, now[row]);
            endInsertRows();
        } else if (from != row) {
            beginMoveRows({}, from, from, {}, row);
            m_entries.move(from, row);
            endMoveRows();
        }
        m_entries[row] = now[row];
    }
    if (!m_entries.isEmpty())
        Q_EMIT dataChanged(index(0, 0), index(int(m_entries.size()) - 1, columns - 1));
}

void ActiveAlarmModel::onStateChanged(const robot::TopicRange &range)
{
    if (range.kind != Kind::Alarm)
        return;
    bool areLive = true;
    for (int slot = 1; slot <= values::activeAlarmCount; ++slot)
        areLive &= m_state.freshness({Kind::Alarm, quint16(slot)}) == Freshness::Live;
    if (std::exchange(m_areSlotsLive, areLive) != areLive && !m_entries.isEmpty())
        Q_EMIT dataChanged(index(0, 0), index(int(m_entries.size()) - 1, columns - 1));
}

int ActiveAlarmModel::rowCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : int(m_entries.size()); }

int ActiveAlarmModel::columnCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : int(columns); }

QVariant ActiveAlarmModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Horizontal && role == Qt::DisplayRole)
        return tr(activeTitles[section]);
    if (orientation == Qt::Horizontal && role == Qt::TextAlignmentRole && isNumber(section))
        return int(Qt::AlignRight | Qt::AlignVCenter);
    return {};
}

QVariant ActiveAlarmModel::data(const QModelIndex &index, int role) const
{
    const Entry &entry = at(index.row());
    const int column = index.column();
    switch (role) {
    case Qt::DisplayRole: return text(entry, column);
    case Qt::ToolTipRole: return toolTip(entry, column);
    case Qt::TextAlignmentRole: return int((isNumber(column) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    case widgets::BoldRole: return column == Code || entry.sighting.state == AlarmState::Unacknowledged;
    case widgets::HatchedRole: return isStale(entry);
    case widgets::InkRole:
        if (isStale(entry))
            return int(ui::Role::Text3);
        return column <= Code ? QVariant(int(ui::roleOf(entry.sighting.state))) : QVariant();
    default: return {};
    }
}

/// What cleared is this computer's own knowledge and never stale.
bool ActiveAlarmModel::isStale(const Entry &entry) const { return !m_areSlotsLive && isActive(entry); }

QString ActiveAlarmModel::text(const Entry &entry, int column) const
{
    const auto &[controller, alarm, firstSeen, lastSeen, count, state] = entry.sighting;
    switch (column) {
    case State: return ui::word(state);
    case Code: return QString::number(alarm.alarm.code);
    case Data: return alarm.alarm.data.toString();
    case Text: return ui::alarmText(alarm, m_codec);
    case Time: return m_codec.decode(alarm.alarm.time.bytes());
    case FirstSeen: return ui::tableTime(firstSeen);
    default: return QString::number(count);
    }
}

QString ActiveAlarmModel::toolTip(const Entry &entry, int column) const
{
    if (isStale(entry))
        return widgets::lastSeen(entry.sighting.lastSeen.toLocalTime());
    if (column == State && isActive(entry) && !entry.isInSlot)
        return tr("The controller tells the newest four alarms only, and this is not one of them. It may be active.");
    if (column == Time)
        return tr("First seen by this computer: %1").arg(text(entry, FirstSeen));
    return column == Data ? ui::dataSentence(entry.sighting.alarm.alarm.data) : text(entry, column);
}

} // namespace models
