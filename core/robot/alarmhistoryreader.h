// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/orders.h"
#include "values/alarm.h"
#include <map>

namespace robot {

/// The newest entries of each list, the newest first.
using AlarmHistories = std::map<values::AlarmHistoryClass, QList<values::AlarmWithTexts>>;

/// Reads the five lists of past alarms (reference §3.2), entry by entry, each as far as it is new. It gives way to
/// everything else on the link. With texts where the controller has them (0x30B), else without (0x71).
///
/// A list that moves while it is read is read again. Deleting the reader ends it silently; the lists that were
/// announced until then are whole.
class AlarmHistoryReader : public QObject
{
    Q_OBJECT

public:
    /// `known`: what the journal has of this controller. `orders` must outlive the reader.
    AlarmHistoryReader(Orders &orders, AlarmHistories known, QObject *parent = nullptr);

    void start() { startList(); }

Q_SIGNALS:
    /// A list was read down to what is known: see journal::newCount().
    void listRead(values::AlarmHistoryClass list, const QList<values::AlarmWithTexts> &entries);
    /// The controller refuses this list. The others are read all the same.
    void listRefused(values::AlarmHistoryClass list, const values::Error &refusal);
    /// Entries read so far, of all lists.
    void progressed(int entries);
    /// The end. With an error the link was lost or the controller silent; some lists were not read.
    void finished(const std::optional<values::Error> &error);

private:
    using Entry = values::Result<values::AlarmWithTexts>;

    [[nodiscard]] values::AlarmHistoryClass list() const { return values::allAlarmHistoryClasses[m_list]; }
    void startList();
    void nextList();
    void ask(int entry);
    void onAnswer(int entry, const Entry &answer);
    void onRefused(int entry, const values::Error &refusal);
    void take(const values::AlarmWithTexts &entry);
    void check(int entry, const values::AlarmWithTexts &again);
    void beginCheck();
    void finish(const std::optional<values::Error> &error);

    Orders &m_orders;
    AlarmHistories m_known;
    std::size_t m_list = 0;
    QList<values::AlarmWithTexts> m_read;
    bool m_isChecking = false; ///< Reading the top again.
    int m_tries = 0; ///< Of this list.
    int m_count = 0;
    bool m_hasTexts;
};

} // namespace robot
