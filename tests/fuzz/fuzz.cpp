// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"
#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <cstdio>

/// One program for all targets. FUZZ_TARGET names the one to run; with FUZZ_SEEDS it writes what every target starts
/// from into folders below that one, prints the names of the targets and the longest input of each, and ends.
namespace {

const fuzz::Target *chosen = nullptr;

void writeSeeds(const fuzz::Target &target, const QString &folder)
{
    int number = 0;
    fuzz::require(QDir {}.mkpath(folder), "the folder of seeds cannot be made");
    for (const QByteArray &seed : target.seeds()) {
        QFile file {QStringLiteral("%1/%2").arg(folder).arg(++number, 4, 10, QChar(u'0'))};
        fuzz::require(file.open(QIODevice::WriteOnly) && file.write(seed) == seed.size(), "a seed cannot be written");
    }
}

[[noreturn]] void list(const QString &folder)
{
    for (const fuzz::Target *target : fuzz::targets()) {
        writeSeeds(*target, folder + u'/' + QLatin1StringView(target->name));
        std::printf("%s %d\n", target->name, target->longest);
    }
    std::exit(0);
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    static const QCoreApplication application {*argc, *argv};
    if (const QString folder = qEnvironmentVariable("FUZZ_SEEDS"); !folder.isEmpty())
        list(folder);
    const QByteArray wanted = qgetenv("FUZZ_TARGET");
    for (const fuzz::Target *target : fuzz::targets())
        chosen = wanted == target->name ? target : chosen;
    fuzz::require(chosen, "FUZZ_TARGET names no target");
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const quint8 *data, std::size_t size)
{
    chosen->take({data, qsizetype(size)});
    return 0;
}
