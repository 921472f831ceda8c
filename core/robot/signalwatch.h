// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "names/signal.h"
#include "robot/robotstate.h"
#include <deque>

namespace robot {

/// What a signal was from a moment on.
struct SignalSpan {
    Time from {};
    std::optional<bool> isOn; ///< nullopt: nobody knows, it was not read.
};

/// What was seen of one watched signal.
struct SignalTrace {
    names::Signal signal;
    int rises = 0; ///< Changes from 0 to 1 between two readings; shorter pulses are not seen.
    int falls = 0;
    QDateTime changed; ///< The last of them, local time.
    std::deque<SignalSpan> spans; ///< Oldest first, the last one lasts until now.
};

/// Counts the edges of some signals and remembers the last five minutes of them. Between two readings that are too far
/// apart nothing is counted: it is a gap.
class SignalWatch : public QObject
{
    Q_OBJECT

public:
    static constexpr auto memory = std::chrono::minutes {5};

    /// `state` must outlive the watch.
    explicit SignalWatch(const RobotState &state, QObject *parent = nullptr);

    [[nodiscard]] const QList<SignalTrace> &traces() const { return m_traces; }
    [[nodiscard]] bool isWatched(const names::Signal &signal) const { return find(signal) >= 0; }
    /// nullptr if it is not watched.
    [[nodiscard]] const SignalTrace *trace(const names::Signal &signal) const;
    /// Each group once.
    [[nodiscard]] QList<TopicRange> topics() const;

    void add(const names::Signal &signal);
    void remove(const names::Signal &signal);
    /// Counts from 0 again.
    void reset();

    /// Takes what is known now. Called with every reading.
    void look(Time now);

Q_SIGNALS:
    /// Signals came or went.
    void listChanged();
    /// Something was read, or was not.
    void traced();

private:
    [[nodiscard]] qsizetype find(const names::Signal &signal) const;
    void look(SignalTrace &trace, Time now);

    const RobotState &m_state;
    QList<SignalTrace> m_traces;
};

} // namespace robot
