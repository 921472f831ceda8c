// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QStringList>

/// The verbs. Each takes its arguments, itself first, and returns the exit code.
namespace pendeskctl {

int runInfo(const QStringList &arguments);
int runAlarms(const QStringList &arguments);
int runPosition(const QStringList &arguments);
int runIo(const QStringList &arguments);
int runRegisters(const QStringList &arguments);
int runVar(const QStringList &arguments);
int runWatch(const QStringList &arguments);
int runJobs(const QStringList &arguments);
int runFiles(const QStringList &arguments);
int runBackup(const QStringList &arguments);
int runCheck(const QStringList &arguments);
int runVerify(const QStringList &arguments);
int runShow(const QStringList &arguments);
int runXref(const QStringList &arguments);
int runCalls(const QStringList &arguments);
int runUnused(const QStringList &arguments);
int runCompare(const QStringList &arguments);
int runRestore(const QStringList &arguments);

} // namespace pendeskctl
