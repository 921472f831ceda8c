// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "cellfiles/outline.h"
#include <QDateTime>

/// The operation log and the alarm history of a controller (controller files reference §10).
namespace cellfiles {

struct LogField {
    QString key; ///< In the pendant's language.
    QString value;
    QStringList block {}; ///< The lines below a key without a colon.

    bool operator==(const LogField &) const = default;
};

/// One entry of LOGDATA.DAT. Keys and values are translated by the controller, so the first three are known by their
/// place: date, event, login.
struct LogEntry {
    QDateTime date; ///< By the controller's clock.
    QString event;
    QString login;
    QList<LogField> fields; ///< Behind the first three.
    int line = 0;
    bool isWhole = true;

    /// The value of a field by its English key; empty if there is none.
    [[nodiscard]] QString value(QStringView key) const;
    /// Written by itself, at midnight or at power on, up to forty a time.
    [[nodiscard]] bool isNoise() const;
    /// In one line: "VARIABLE EDIT: B VAR 7, 0 → 255".
    [[nodiscard]] QString text() const;
    /// The same entry: everything but its index.
    friend bool operator==(const LogEntry &a, const LogEntry &b)
    {
        return a.date == b.date && a.event == b.event && a.login == b.login && a.fields == b.fields;
    }
};
[[nodiscard]] Parsed<QList<LogEntry>> logFrom(QByteArrayView file, const protocol::TextCodec &codec);

struct AlarmRecord {
    QByteArray section; ///< "MAJOR", "MINOR", "IO_SYS", "IO_USR", "OFFLINE".
    int code = 0;
    QString name;
    QString group; ///< "ROBOT1"
    QString detail; ///< Axes "[SLURBT]" or a sub code "[16]".
    QString mode; ///< "PLAY"; empty on a DX100.
    QString task;
    QString job;
    int jobLine = 0;
    int step = 0;
    QString state; ///< "STOP"; empty on a DX100.
    QString date; ///< "2024/03/01 07:05:09", to minutes on a DX100.
    int line = 0;

    /// The same alarm at the same time. Names follow the pendant's language and are left out.
    [[nodiscard]] bool isSameAs(const AlarmRecord &other) const;
};
[[nodiscard]] Parsed<QList<AlarmRecord>> alarmHistoryFrom(QByteArrayView file, const protocol::TextCodec &codec);

} // namespace cellfiles
