// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/text.h"
#include <QFile>

/// The controller files of tests/data/cell: one folder a controller.
namespace samples {

/// The bytes of "yrc1000/TOOL.CND"; ends the test if there is no such file.
inline QByteArray read(const QString &path)
{
    QFile file {QStringLiteral(PENDESK_TEST_DATA "/cell/") + path};
    if (!file.open(QIODevice::ReadOnly))
        qFatal("%s cannot be read", qPrintable(file.fileName()));
    return file.readAll();
}

inline const protocol::TextCodec &codec()
{
    static const protocol::TextCodec latin1;
    return latin1;
}

} // namespace samples
