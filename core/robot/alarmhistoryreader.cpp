// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/alarmhistoryreader.h"

#include "journal/history.h"

using values::AlarmWithTexts;
using values::Error;
using values::ErrorKind;

namespace robot {

namespace {

constexpr int mostTries = 5; ///< Of a list that moves; after that it waits for the next occasion.

} // namespace

AlarmHistoryReader::AlarmHistoryReader(Orders &orders, AlarmHistories known, QObject *parent)
    : QObject {parent},
      m_orders {orders},
      m_known {std::move(known)},
      m_hasTexts {orders.controller().profile().dialect().hasAlarmTexts}
{
}

void AlarmHistoryReader::startList()
{
    m_read.clear();
    m_isChecking = false;
    ask(1);
}

void AlarmHistoryReader::nextList()
{
    m_tries = 0;
    if (++m_list == values::allAlarmHistoryClasses.size())
        finish({});
    else
        startList();
}

void AlarmHistoryReader::ask(int entry)
{
    constexpr auto last = session::Priority::Background;
    if (m_hasTexts) {
        const auto take = [this, entry](const Entry &answer) { onAnswer(entry, answer); };
        return m_orders.read(protocol::ReadAlarmHistoryWithTexts {list(), entry}, this, take, last);
    }
    const auto take = [this, entry](const values::Result<values::Alarm> &answer) {
        onAnswer(entry, answer.map([](const values::Alarm &alarm) { return AlarmWithTexts {alarm, {}, {}, {}}; }));
    };
    m_orders.read(protocol::ReadAlarmHistory {list(), entry}, this, take, last);
}

void AlarmHistoryReader::onAnswer(int entry, const Entry &answer)
{
    if (answer && m_isChecking)
        check(entry, *answer);
    else if (answer)
        take(*answer);
    else if (answer.error().kind == ErrorKind::Refused)
        onRefused(entry, answer.error());
    else
        finish(answer.error());
}

void AlarmHistoryReader::onRefused(int entry, const Error &refusal)
{
    if (std::exchange(m_hasTexts, false)) // an older controller: without texts
        return ask(entry);
    Q_EMIT listRefused(list(), refusal);
    nextList();
}

void AlarmHistoryReader::take(const AlarmWithTexts &entry)
{
    Q_EMIT progressed(++m_count);
    if (entry.alarm.isEmpty())
        return beginCheck();
    m_read.append(entry);
    const bool isWhole = m_read.size() == values::alarmHistoryLength;
    if (isWhole || journal::isEnough(m_read, m_known[list()]))
        beginCheck();
    else
        ask(int(m_read.size()) + 1);
}

void AlarmHistoryReader::beginCheck()
{
    m_isChecking = true;
    if (m_read.isEmpty())
        check(0, {});
    else
        ask(1);
}

/// Entry `entry` once more; 0 where there is nothing to check.
void AlarmHistoryReader::check(int entry, const AlarmWithTexts &again)
{
    const bool hasMoved = entry > 0 && !journal::isSameEntry(again, m_read[entry - 1]);
    if (hasMoved && ++m_tries < mostTries)
        return startList();
    if (hasMoved)
        return nextList();
    if (entry < journal::checkCount(m_read))
        return ask(entry + 1);
    Q_EMIT listRead(list(), m_read);
    nextList();
}

void AlarmHistoryReader::finish(const std::optional<Error> &error) { Q_EMIT finished(error); }

} // namespace robot
