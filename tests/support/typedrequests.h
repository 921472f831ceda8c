// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/requests.h"
#include <functional>

/// Every typed request with the golden exchange that it must make, and the value that the reply must give.
namespace typed {

struct Row {
    const char *title; ///< Of the golden exchange.
    protocol::Request request;
    protocol::Effect effect;
    std::function<QString(QByteArrayView payload)>
        check; ///< What is wrong with the value of a good reply; empty if nothing.
    QByteArray reply; ///< The payload that the expected value encodes to.
};

[[nodiscard]] const QList<Row> &rows();

struct FileRow {
    const char *title; ///< Of the golden exchange.
    protocol::Request request;
};

/// The requests of the file port.
[[nodiscard]] const QList<FileRow> &fileRows();

} // namespace typed
