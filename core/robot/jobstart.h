// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/orders.h"

namespace robot {

/// One start and what became of it: the order is sent once, then the status tells. Deleting it ends the watching, not
/// the robot.
class JobStart : public QObject
{
    Q_OBJECT

public:
    enum class Phase {
        Sent,
        Waiting, ///< Accepted; waiting for RUN, 3 s at most.
        Running, ///< The status says RUN.
        NotRunning, ///< Accepted, and no RUN was seen within 3 s.
        Refused, ///< By the controller or by a condition: see error().
        Asking, ///< No answer; the status is being read.
        UnknownRunning, ///< No answer to the start; a status read afterwards says RUN.
        UnknownNotRunning, ///< No answer to the start; a status read afterwards says no RUN.
        UnknownStatus, ///< No answer to the start, nor to the status: nobody here can know.
    };
    static constexpr Milliseconds runPatience {3000};

    /// `orders` must outlive it. `job` as the journal is to have it.
    JobStart(Orders &orders, QString job, QObject *parent = nullptr);

    void start();
    [[nodiscard]] Phase phase() const { return m_phase; }
    [[nodiscard]] bool isFinished() const;
    [[nodiscard]] const std::optional<values::Error> &error() const { return m_error; }

Q_SIGNALS:
    void phaseChanged();

private:
    void onAnswered(const values::Result<void> &result);
    void onSituationChanged();
    void ask();
    void onStatus(const values::Result<values::Status> &status);
    void setPhase(Phase phase);

    Orders &m_orders;
    QString m_job;
    Phase m_phase = Phase::Sent;
    std::optional<values::Error> m_error;
    Time m_deadline {};
};

} // namespace robot
