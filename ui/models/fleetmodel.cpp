// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/models/fleetmodel.h"

#include "protocol/codes.h"
#include "ui/alarmwords.h"
#include "ui/linkview.h"
#include "ui/widgets/table.h"
#include "ui/words.h"

namespace models {

using namespace std::chrono_literals;
using robot::Freshness;
using robot::LinkState;
using station::Station;
using values::Status;
using widgets::Lamp;
using widgets::Word;

namespace {

/// While there is a link.
void showStatus(FleetRow &row, const Status &status)
{
    row.mode = ui::modeWord(status).text;
    row.servo = ui::servoWord(status).text;
    row.summary = ui::summaryWord(status);
    if (status.hasAlarm()) {
        row.trouble = Trouble::Alarm;
        row.state = {FleetModel::tr("ALARM"), Lamp::Alarm};
    } else if (status.isHeld()) {
        row.trouble = Trouble::Held;
        row.state = {FleetModel::tr("HELD"), Lamp::Warning};
        row.reason = FleetModel::tr("Hold: %1").arg(ui::holdWord(status).text);
    } else if (status.isRunning()) {
        row.state = {FleetModel::tr("RUNNING"), Lamp::Filled};
    } else if (status.data1.testFlag(Status::Teach)) {
        row.state = {FleetModel::tr("TEACH"), Lamp::Hollow};
    } else {
        row.state = {FleetModel::tr("STOPPED"), Lamp::Hollow};
    }
    if (status.hasError() && row.trouble == Trouble::None) {
        row.trouble = Trouble::Held;
        row.reason = FleetModel::tr("Error");
    }
}

/// Whatever else the status says, a controller that does not answer says nothing.
void showNoLink(FleetRow &row, const Station &station)
{
    const robot::Controller &controller = station.controller;
    const bool isTrouble = controller.linkState() == LinkState::Lost || controller.trouble();
    row.trouble = isTrouble ? Trouble::NoLink : Trouble::None;
    row.state = isTrouble ? Word {FleetModel::tr("NO LINK"), Lamp::Warning} : Word {FleetModel::tr("CHECKING")};
    if (controller.trouble())
        row.reason = protocol::explain(*controller.trouble());
    else if (station.state().status().value)
        row.reason = widgets::lastSeen(station.state().status().clock);
}

void showAlarms(FleetRow &row, const Station &station)
{
    for (int slot = 1; slot <= values::activeAlarmCount; ++slot) {
        const auto &reading = station.state().reading<robot::Kind::Alarm>(slot);
        if (!reading.value || reading.value->alarm.isEmpty())
            continue;
        if (++row.alarms == 1 && row.trouble == Trouble::Alarm)
            row.reason = QStringLiteral("%1 %2")
                             .arg(reading.value->alarm.code)
                             .arg(ui::alarmText(*reading.value, protocol::TextCodec {station.profile().encoding}));
    }
}

Word linkSummary(const Station &station)
{
    const LinkState state = station.controller.linkState();
    const Lamp lamp = state == LinkState::Lost || station.controller.trouble() ? Lamp::Warning : Lamp::None;
    if (state != LinkState::Lost)
        return {ui::linkWord(state), lamp};
    return {
        FleetModel::tr("%1 · %2").arg(ui::linkWord(state), station.controller.linkStateSince().toString(u"HH:mm:ss")),
        lamp};
}

void showStation(FleetRow &row, const Station &station)
{
    const robot::RobotState &state = station.state();
    const bool isUp = station.controller.linkState() == LinkState::Monitoring;
    row.isOpen = station.isOpen();
    row.isArmed = station.orders.isArmed();
    row.isStale = state.freshness(robot::topics::status) == Freshness::Stale;
    row.link = ui::roundTripText(station.controller.statistics().p50);
    row.summary = linkSummary(station);
    if (const auto &job = state.job().value) {
        row.job = ui::jobName(*job, station.profile().encoding);
        row.place = ui::jobPlace(*job);
    }
    if (const auto &status = state.status().value; status && isUp)
        showStatus(row, *status);
    else if (row.isOpen)
        showNoLink(row, station);
    showAlarms(row, station);
}

} // namespace

FleetRow fleetRow(const station::RosterEntry &entry)
{
    FleetRow row;
    row.id = entry.profile.id;
    row.name = entry.profile.name;
    row.tag = entry.profile.tag;
    row.isSimulation = entry.profile.isSimulation;
    row.state = {FleetModel::tr("OFF")};
    row.summary = {ui::linkWord(LinkState::Disconnected)};
    row.servo = row.link = row.job = widgets::dash();
    if (entry.station)
        showStation(row, *entry.station);
    return row;
}

FleetModel::FleetModel(const station::Fleet &fleet, QObject *parent) : QAbstractTableModel(parent), m_fleet {fleet}
{
    connect(&fleet, &station::Fleet::added, this, &FleetModel::update);
    connect(&fleet, &station::Fleet::removed, this, &FleetModel::update);
    connect(&m_timer, &QTimer::timeout, this, &FleetModel::update);
    m_timer.start(500ms);
    update();
}

/// Rows that came or went are inserted and removed where they stand, so that what is chosen stays chosen.
void FleetModel::fit(const QList<station::RosterEntry> &roster)
{
    const auto isRow = [](const FleetRow &row, const station::RosterEntry &entry) {
        return row.name == entry.profile.name;
    };
    for (int row = int(m_rows.size()) - 1; row >= 0; --row) {
        if (std::ranges::any_of(roster, [&](const auto &entry) { return isRow(m_rows[row], entry); }))
            continue;
        beginRemoveRows({}, row, row);
        m_rows.removeAt(row);
        endRemoveRows();
    }
    for (int row = 0; row < roster.size(); ++row) {
        if (row < m_rows.size() && isRow(m_rows[row], roster[row]))
            continue;
        beginInsertRows({}, row, row);
        m_rows.insert(row, fleetRow(roster[row]));
        endInsertRows();
    }
    if (m_rows.size() > roster.size()) { // the order is another: rare, a controller was renamed
        beginRemoveRows({}, int(roster.size()), int(m_rows.size()) - 1);
        m_rows.resize(roster.size());
        endRemoveRows();
    }
}

void FleetModel::update()
{
    const QList<station::RosterEntry> roster = m_fleet.roster();
    fit(roster);
    for (int row = 0; row < m_rows.size(); ++row) {
        FleetRow now = fleetRow(roster[row]);
        now.since = now.state == m_rows[row].state ? m_rows[row].since : QDateTime::currentDateTime();
        if (now == m_rows[row])
            continue;
        m_rows[row] = std::move(now);
        Q_EMIT dataChanged(index(row, 0), index(row, columns - 1));
    }
}

int FleetModel::rowCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : int(m_rows.size()); }

int FleetModel::columnCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : columns; }

QString FleetModel::text(const FleetRow &row, int column)
{
    switch (column) {
    case Name: return row.name;
    case State: return row.state.text;
    case Mode: return row.mode;
    case Reason: return row.reason;
    case Job: return row.job;
    case Place: return row.place;
    case Servo: return row.servo;
    case Alarms: return row.alarms > 0 ? QString::number(row.alarms) : QString();
    case Link: return row.link;
    }
    return {};
}

QVariant FleetModel::data(const QModelIndex &index, int role) const
{
    const FleetRow &row = m_rows[index.row()];
    switch (role) {
    case Qt::DisplayRole: return text(row, index.column());
    case Qt::AccessibleTextRole:
        return index.column() == Name ? tr("%1: %2. %3").arg(row.name, row.summary.text, row.reason) : QVariant();
    case RowRole: return QVariant::fromValue(static_cast<const void *>(&row));
    case TroubleRole: return int(row.trouble);
    case widgets::BoldRole: return index.column() == Name || index.column() == State;
    case widgets::InkRole: return index.column() == State ? int(widgets::roleOf(row.state.lamp)) : QVariant();
    case widgets::HatchedRole: return row.isStale && index.column() >= Mode && index.column() != Reason;
    default: return {};
    }
}

QVariant FleetModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    const QString titles[] {tr("Controller"), tr("State"), tr("Mode"), tr("Reason"), tr("Job"), tr("Place"),
        tr("Servo"), tr("Alarms"), tr("Round trip")};
    return titles[section];
}

} // namespace models
