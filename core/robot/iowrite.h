// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "names/signal.h"
#include "robot/orders.h"

namespace robot {

/// Switches one network input, the only signals that HSES may write (reference §4.1). Eight signals travel together, so
/// the group is read first and shown; when it is written, it is read again, and if another of the eight has changed in
/// between, nothing is sent and it is shown again. Written once, then read back.
class IoWrite : public QObject
{
    Q_OBJECT

public:
    enum class Step {
        Reading, ///< The group is being read.
        Ready, ///< before() is what it is; write() may be called.
        Changed, ///< As Ready: but it was something else a moment ago, and nothing was sent.
        Writing,
        Done, ///< Read back as it was written.
        Mismatch, ///< Accepted, but readBack() is something else.
        Refused, ///< See error(); nothing was changed.
        Unknown, ///< See error(); it may or may not have been done.
        Failed, ///< It could not be read or not be sent: see error(); nothing was changed.
    };

    /// `orders` must outlive it.
    IoWrite(Orders &orders, const names::Signal &signal, QObject *parent = nullptr);

    [[nodiscard]] const names::Signal &signal() const { return m_signal; }
    [[nodiscard]] Step step() const { return m_step; }
    [[nodiscard]] std::optional<values::IoGroup> before() const { return m_before; }
    /// What write() would send.
    [[nodiscard]] std::optional<values::IoGroup> after() const;
    [[nodiscard]] std::optional<values::IoGroup> readBack() const { return m_readBack; }
    [[nodiscard]] const values::Error &error() const { return m_error; }
    [[nodiscard]] bool isOn() const { return m_isOn; }

    /// What the signal shall be: the reverse of what it is, as soon as that is known.
    void setOn(bool on);
    /// Reads the group, and shows it.
    void read();
    /// Only while Ready or Changed.
    void write();

Q_SIGNALS:
    void changed();

private:
    void ask(void (IoWrite::*take)(const values::IoGroup &));
    void show(const values::IoGroup &group);
    void send(const values::IoGroup &group);
    void compare(const values::IoGroup &group);
    void onWritten(const values::Result<void> &result);
    void set(Step step, const values::Error &error = {});

    Orders &m_orders;
    names::Signal m_signal;
    Step m_step = Step::Reading;
    std::optional<values::IoGroup> m_before;
    std::optional<values::IoGroup> m_readBack;
    values::Error m_error;
    bool m_isOn = false;
    values::IoGroup m_sent;
};

} // namespace robot
