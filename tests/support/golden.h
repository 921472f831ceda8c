// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QByteArray>
#include <QJsonObject>
#include <QList>
#include <QString>

/// The packets of tests/data/golden.json. None of them was made by our own encoder.
namespace golden {

struct Packet {
    bool isFromClient;
    QByteArray bytes;
    QJsonObject
        fields; ///< By the names of `pendeskctl decode`; `refused_with` is the code that a refusal comes down to.
};

struct Exchange {
    QString title;
    QList<Packet> packets; ///< In sending order; the first one is the request.
};

/// A datagram that is no packet, or whose payload does not fit.
struct Malformed {
    QString title;
    QByteArray bytes;
    QByteArray replyTo; ///< The request that it answers, or empty.
    int port; ///< Where it came from; 0 if that does not matter.
    QString error;
};

/// A well-formed request that a controller refuses for its address or its size.
struct Refused {
    QString title;
    QByteArray bytes;
    QString model; ///< Key of the dialect.
    quint16 code;
};

[[nodiscard]] const QList<Exchange> &exchanges();
[[nodiscard]] const QList<Malformed> &malformed();
[[nodiscard]] const QList<Refused> &refused();
/// The exchange of that title; asserts that there is one.
[[nodiscard]] const Exchange &exchange(const QString &title);

} // namespace golden
