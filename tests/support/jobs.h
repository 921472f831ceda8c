// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QByteArray>
#include <QFile>
#include <QString>

/// The job files of tests/data/jobs: valid ones, broken ones with one fault each in broken/, two versions of one job in
/// pairs/.
namespace testdata {

inline QByteArray job(const QString &name)
{
    QFile file {QStringLiteral(PENDESK_TEST_DATA "/jobs/") + name};
    if (!file.open(QIODevice::ReadOnly))
        qFatal("%s cannot be read", qPrintable(file.fileName()));
    return file.readAll();
}

} // namespace testdata
