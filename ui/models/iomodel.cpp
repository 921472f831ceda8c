// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/models/iomodel.h"

#include "protocol/codes.h"
#include "ui/widgets/shown.h"

namespace models {

using namespace std::chrono_literals;
using names::Signal;
using robot::Freshness;
using robot::Kind;
using robot::Time;

namespace {

constexpr auto recentFor = 2s;

} // namespace

IoModel::IoModel(const robot::RobotState &state, robot::NameBook &book, const protocol::Dialect &dialect,
    protocol::InstanceRange groups, QObject *parent)
    : QAbstractTableModel(parent),
      m_state {state},
      m_book {book},
      m_dialect {dialect},
      m_range {groups},
      m_groups(std::size_t(groups.count()))
{
    m_fade.setInterval(250ms);
    connect(&m_fade, &QTimer::timeout, this, [this] { tick(values::now()); });
    connect(&state, &robot::RobotState::changed, this, &IoModel::onChanged);
    connect(&book, &robot::NameBook::changed, this,
        [this] { Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1)); });
    onChanged({Kind::IoGroup, groups.first, groups.last});
    tick(Time::max()); // what was read before is no change now
}

Signal IoModel::signalAt(const QModelIndex &index) const { return {m_range.first + index.row(), index.column()}; }

QModelIndex IoModel::indexOf(const Signal &signal) const
{
    return m_range.contains(quint32(signal.group)) ? index(signal.group - m_range.first, signal.bit) : QModelIndex();
}

robot::TopicRange IoModel::groups(int firstRow, int lastRow) const
{
    return {Kind::IoGroup, m_range.first + firstRow, m_range.first + lastRow};
}

QList<int> IoModel::refusedRows() const
{
    QList<int> rows;
    for (std::size_t row = 0; row < m_groups.size(); ++row) {
        if (m_groups[row].freshness == Freshness::Refused)
            rows << int(row);
    }
    return rows;
}

/// Takes the group's present state; false if it looks as before.
bool IoModel::look(int row, Time now)
{
    const int number = m_range.first + row;
    Group &group = m_groups[std::size_t(row)];
    const auto &reading = m_state.reading<Kind::IoGroup>(number);
    const Freshness freshness = m_state.freshness({Kind::IoGroup, quint16(number)});
    const auto bits = reading.value ? std::optional {reading.value->bits} : std::nullopt;
    const bool isSame = bits == group.bits && freshness == group.freshness;
    const quint8 flipped = bits && group.bits ? quint8(*bits ^ *group.bits) : quint8(0);
    group.recent |= flipped;
    for (int bit = 0; bit < names::signalsPerGroup; ++bit) {
        if (flipped >> bit & 1)
            group.changed[std::size_t(bit)] = now;
    }
    group.bits = bits;
    group.freshness = freshness;
    return !isSame;
}

void IoModel::onChanged(const robot::TopicRange &range)
{
    if (range.kind != Kind::IoGroup)
        return;
    const Time now = values::now();
    const int first = std::max<int>(range.first, m_range.first) - m_range.first;
    const int last = std::min<int>(range.last, m_range.last) - m_range.first;
    bool hasRefusals = false;
    for (int row = first; row <= last; ++row) {
        const Freshness before = m_groups[std::size_t(row)].freshness;
        if (!look(row, now))
            continue;
        hasRefusals |= (before == Freshness::Refused) != (m_groups[std::size_t(row)].freshness == Freshness::Refused);
        Q_EMIT dataChanged(index(row, 0), index(row, columnCount() - 1));
        if (m_groups[std::size_t(row)].recent && !m_fade.isActive())
            m_fade.start();
    }
    if (hasRefusals)
        Q_EMIT refusedRowsChanged();
}

void IoModel::tick(Time now)
{
    bool isAnyRecent = false;
    for (std::size_t row = 0; row < m_groups.size(); ++row) {
        Group &group = m_groups[row];
        const quint8 before = group.recent;
        for (int bit = 0; bit < names::signalsPerGroup; ++bit) {
            if (now - group.changed[std::size_t(bit)] >= recentFor)
                group.recent &= quint8(~(1 << bit));
        }
        isAnyRecent |= group.recent != 0;
        if (group.recent != before)
            Q_EMIT dataChanged(index(int(row), 0), index(int(row), columnCount() - 1));
    }
    if (!isAnyRecent)
        m_fade.stop();
}

Lamp IoModel::lamp(const QModelIndex &index) const
{
    const Group &group = m_groups[std::size_t(index.row())];
    const Signal signal = signalAt(index);
    const QString inform = informName(signal, m_dialect);
    return {group.freshness, group.bits && (*group.bits >> signal.bit & 1), (group.recent >> signal.bit & 1) != 0,
        inform.isEmpty() ? toString(signal) : inform, m_book.names().of(signal)};
}

int IoModel::rowCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : int(m_groups.size()); }

int IoModel::columnCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : names::signalsPerGroup; }

QVariant IoModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (role != Qt::DisplayRole)
        return {};
    if (orientation == Qt::Horizontal)
        return QStringLiteral("…%1").arg(section);
    return toString(Signal {m_range.first + section, 0});
}

QString IoModel::words(const QModelIndex &index) const
{
    const Lamp shown = lamp(index);
    switch (shown.freshness) {
    case Freshness::Unknown: return widgets::dash();
    case Freshness::Refused: return tr("refused");
    case Freshness::Live:
    case Freshness::Stale: break;
    }
    return shown.isOn ? QStringLiteral("1") : QStringLiteral("0");
}

QVariant IoModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const Signal signal = signalAt(index);
    const auto &reading = m_state.reading<Kind::IoGroup>(signal.group);
    switch (role) {
    case Qt::DisplayRole: return words(index);
    case Qt::EditRole: return m_book.names().of(signal).text;
    case Qt::AccessibleTextRole: {
        const Lamp shown = lamp(index);
        const QString head = QStringList {toString(signal), informName(signal, m_dialect), shown.name.text}.join(u' ');
        const QString value = tr("%1: %2").arg(head.simplified(), words(index));
        return shown.freshness == Freshness::Stale ? tr("%1. %2").arg(value, widgets::lastSeen(reading.clock)) : value;
    }
    case Qt::ToolTipRole: {
        if (reading.refusal)
            return protocol::explain(*reading.refusal);
        const QStringList lines {QStringList {toString(signal), informName(signal, m_dialect)}.join(u' ').trimmed(),
            lamp(index).name.text,
            lamp(index).freshness == Freshness::Stale ? widgets::lastSeen(reading.clock) : QString()};
        return lines.join(u'\n').trimmed();
    }
    default: return {};
    }
}

Qt::ItemFlags IoModel::flags(const QModelIndex &index) const
{
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    return index.isValid() ? flags | Qt::ItemIsEditable : flags;
}

bool IoModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (!index.isValid() || role != Qt::EditRole)
        return false;
    const Signal signal = signalAt(index);
    const QString name = value.toString();
    m_book.setLocalName(signal, name == m_book.names().own(signal) ? QString() : name);
    return true;
}

} // namespace models
