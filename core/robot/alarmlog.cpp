// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/alarmlog.h"

#include "journal/history.h"
#include <algorithm>

using journal::ActiveAlarms;
using values::AlarmHistoryClass;
using values::AlarmWithTexts;
using values::Error;
using values::Result;

namespace robot {

namespace {

constexpr int mostFailures = 3; ///< After that a reading waits for the next occasion.
constexpr TopicRange activeAlarms {Kind::Alarm, 1, values::activeAlarmCount};

} // namespace

AlarmLog::AlarmLog(Orders &orders, journal::Store &store, QObject *parent)
    : AlarmLog {orders, store, Options {}, parent}
{
}

AlarmLog::AlarmLog(Orders &orders, journal::Store &store, const Options &options, QObject *parent)
    : QObject {parent},
      m_orders {orders},
      m_store {store},
      m_options {options},
      m_active {orders.controller().profile().name},
      m_unknownLists {int(values::allAlarmHistoryClasses.size())}
{
    m_pause.setSingleShot(true);
    connect(&m_pause, &QTimer::timeout, this, &AlarmLog::beginReading);
    connect(&orders.controller().state(), &RobotState::changed, this, &AlarmLog::onStateChanged);
    connect(&orders.controller(), &Controller::linkStateChanged, this, &AlarmLog::beginReading);
    loadKnown();
}

AlarmLog::~AlarmLog() = default;

void AlarmLog::loadKnown()
{
    const QString name = m_orders.controller().profile().name;
    m_store.sightings(name, this, [this](const Result<QList<journal::Sighting>> &kept) {
        if (!kept)
            return;
        m_active.restore(*kept);
        Q_EMIT alarmsChanged();
    });
    for (const AlarmHistoryClass list : values::allAlarmHistoryClasses) {
        const auto take = [this, list](const Result<journal::Page<journal::AlarmRecord>> &page) {
            if (page) {
                for (const journal::AlarmRecord &record : page->records)
                    m_known[list] += record.alarm;
            }
            --m_unknownLists;
            beginReading();
        };
        m_store.alarms({name, list, 0}, {}, values::alarmHistoryLength, this, take);
    }
}

void AlarmLog::onStateChanged(const TopicRange &range)
{
    if (range.kind == Kind::Status)
        follow();
    else if (range.kind == Kind::Alarm)
        takeRound();
}

/// Reads the slots as long as the controller or the list says that there is something in them.
void AlarmLog::follow()
{
    const auto &status = m_orders.controller().state().status().value;
    const bool hasActive = std::ranges::any_of(m_active.entries(), [](const ActiveAlarms::Entry &entry) {
        return entry.sighting.state == journal::AlarmState::Unacknowledged
            || entry.sighting.state == journal::AlarmState::Acknowledged;
    });
    const bool isNeeded = hasActive || (status && status->hasAlarm());
    if (isNeeded && !m_interest)
        m_interest = m_orders.controller().poller().want({activeAlarms});
    else if (!isNeeded)
        m_interest.reset();
}

/// Once each slot was read anew.
void AlarmLog::takeRound()
{
    QList<AlarmWithTexts> round;
    Time latest {};
    for (int slot = 1; slot <= values::activeAlarmCount; ++slot) {
        const auto &reading = m_orders.controller().state().reading<Kind::Alarm>(slot);
        if (!reading.value || reading.at <= m_lastRound)
            return;
        round += *reading.value;
        latest = std::max(latest, reading.at);
    }
    m_lastRound = latest;
    const auto changes = m_active.take(round, QDateTime::currentDateTimeUtc());
    keep(changes);
    follow();
    Q_EMIT alarmsChanged();
    if (changes.came.isEmpty())
        return;
    Q_EMIT alarmsCame(changes.came);
    readHistorySoon();
}

void AlarmLog::acknowledge(const QList<AlarmWithTexts> &alarms)
{
    keep(m_active.acknowledge(alarms));
    Q_EMIT alarmsChanged();
}

void AlarmLog::keep(const ActiveAlarms::Changes &changes)
{
    for (const journal::Sighting &sighting : changes.toKeep)
        m_store.keep(sighting);
}

void AlarmLog::readHistorySoon()
{
    m_isReadingDue = true;
    if (!m_pause.isActive())
        beginReading();
}

void AlarmLog::readHistory()
{
    m_failures = 0;
    m_isReadingDue = true;
    beginReading();
}

/// Begins what is due; else that happens when the journal has told what it has, or the present reading has ended.
void AlarmLog::beginReading()
{
    if (!m_isReadingDue || m_unknownLists > 0 || m_reader || !m_orders.situation().isLinkUp)
        return;
    m_isReadingDue = false;
    m_pause.start(m_options.pause);
    m_entriesRead = 0;
    m_readingError.reset();
    m_reader = new AlarmHistoryReader {m_orders, m_known, this};
    connect(m_reader, &AlarmHistoryReader::listRead, this, &AlarmLog::onListRead);
    connect(m_reader, &AlarmHistoryReader::finished, this, &AlarmLog::onFinished);
    connect(m_reader, &AlarmHistoryReader::progressed, this, [this](int entries) {
        m_entriesRead = entries;
        Q_EMIT readingChanged();
    });
    m_reader->start();
    Q_EMIT readingChanged();
}

void AlarmLog::cancelReading()
{
    if (m_reader)
        onFinished(Error {values::ErrorKind::Cancelled});
}

void AlarmLog::onListRead(AlarmHistoryClass list, const QList<AlarmWithTexts> &entries)
{
    auto &known = m_known[list];
    const qsizetype fresh = journal::newCount(entries, known);
    if (fresh == 0)
        return;
    m_store.merge({m_orders.controller().profile().name, list, entries, QDateTime::currentDateTimeUtc()});
    known = entries.first(fresh) + known;
    known.resize(std::min<qsizetype>(known.size(), values::alarmHistoryLength));
    Q_EMIT historyGrew();
}

void AlarmLog::onFinished(const std::optional<Error> &error)
{
    m_reader->deleteLater();
    m_reader->disconnect(this);
    m_reader.clear();
    m_readingError = error;
    const bool isUnanswered = error && error->kind != values::ErrorKind::Cancelled;
    m_failures = isUnanswered ? m_failures + 1 : 0;
    if (error)
        m_isReadingDue = isUnanswered && m_failures < mostFailures;
    if (isUnanswered)
        m_pause.start(m_options.pause);
    if (!m_pause.isActive())
        beginReading();
    Q_EMIT readingChanged();
}

} // namespace robot
