// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "journal/activealarms.h"
#include "journal/store.h"
#include "robot/alarmhistoryreader.h"
#include <QPointer>

namespace robot {

/// Follows the alarms of one controller and writes them to the journal, whether somebody looks or not. While there is
/// no alarm it reads nothing by itself.
///
/// The history is read when an alarm came, and when somebody asks for it; a reading that was not answered is tried
/// again a few times.
class AlarmLog : public QObject
{
    Q_OBJECT

public:
    struct Options {
        Milliseconds pause {5000}; ///< At least, between two readings of the history because of new alarms.
    };

    /// `orders` and `store` must outlive the log.
    AlarmLog(Orders &orders, journal::Store &store, const Options &options, QObject *parent = nullptr);
    AlarmLog(Orders &orders, journal::Store &store, QObject *parent = nullptr);
    ~AlarmLog() override;

    /// Active alarms and those that cleared unacknowledged, the newest first, as of the last reading of all slots.
    [[nodiscard]] const QList<journal::ActiveAlarms::Entry> &alarms() const { return m_active.entries(); }
    /// A person has seen these; the robot does not hear of it.
    void acknowledge(const QList<values::AlarmWithTexts> &alarms);

    /// Reads what is new of the history, unless that is going on.
    void readHistory();
    void cancelReading();
    [[nodiscard]] bool isReading() const { return m_reader != nullptr; }
    /// Entries that the present or last reading has asked for.
    [[nodiscard]] int entriesRead() const { return m_entriesRead; }
    /// Why the last reading ended early; empty if it did not.
    [[nodiscard]] const std::optional<values::Error> &readingError() const { return m_readingError; }

Q_SIGNALS:
    /// alarms() is another list, or one of them has another state.
    void alarmsChanged();
    void alarmsCame(const QList<journal::Sighting> &alarms);
    /// isReading(), entriesRead() or readingError() is another.
    void readingChanged();
    /// The journal was given new entries.
    void historyGrew();

private:
    void loadKnown();
    void onStateChanged(const TopicRange &range);
    void takeRound();
    void follow();
    void keep(const journal::ActiveAlarms::Changes &changes);
    void onListRead(values::AlarmHistoryClass list, const QList<values::AlarmWithTexts> &entries);
    void onFinished(const std::optional<values::Error> &error);
    void readHistorySoon();
    void beginReading();

    Orders &m_orders;
    journal::Store &m_store;
    Options m_options;
    journal::ActiveAlarms m_active;
    AlarmHistories m_known; ///< What the journal has.
    int m_unknownLists; ///< Of which the journal has not answered yet what it has.
    Poller::Interest m_interest; ///< Held while there are alarms.
    Time m_lastRound {};
    QPointer<AlarmHistoryReader> m_reader;
    QTimer m_pause;
    bool m_isReadingDue = false;
    int m_failures = 0; ///< Readings in a row that nobody answered.
    int m_entriesRead = 0;
    std::optional<values::Error> m_readingError;
};

} // namespace robot
