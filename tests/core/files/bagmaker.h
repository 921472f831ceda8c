// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/bag.h"

/// A bag with one job in `folder`; its path. One that is not complete lacks a file that the controller refused.
inline QString makeBag(const QString &folder, const QDateTime &taken, bool isComplete)
{
    files::BagInfo info;
    info.taken = taken;
    info.results = {{"A.JBI", {}}};
    if (!isComplete)
        info.results << files::FileResult {"B.JBI", values::Error {values::ErrorKind::Refused, 0x1F, 0x2110, {}}};
    auto writer = files::BagWriter::create(folder, taken);
    if (!writer || !(*writer)->add(*values::FileName::create("A.JBI"), "/JOB\r\n"))
        return {};
    return (*writer)->seal(info).value_or(QString {});
}
