// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "decode.h"
#include "options.h"
#include "status.h"
#include "verbs.h"
#include <QCoreApplication>
#include <array>
#include <csignal>
#include <cstdlib>

using namespace pendeskctl;

namespace {

struct Verb {
    const char *name;
    const char *purpose;
    int (*run)(const QStringList &arguments);
};

constexpr std::array verbs {
    Verb {"status", QT_TRANSLATE_NOOP("pendeskctl", "read status, job, position and system information"), runStatus},
    Verb {"info", QT_TRANSLATE_NOOP("pendeskctl", "read model, system software and parameter version"), runInfo},
    Verb {"alarms", QT_TRANSLATE_NOOP("pendeskctl", "read the active alarms, or a list of the history"), runAlarms},
    Verb {"position", QT_TRANSLATE_NOOP("pendeskctl", "read where the robot stands"), runPosition},
    Verb {"jobs", QT_TRANSLATE_NOOP("pendeskctl", "list the jobs"), runJobs},
    Verb {"io", QT_TRANSLATE_NOOP("pendeskctl", "read I/O, write a network input"), runIo},
    Verb {"registers", QT_TRANSLATE_NOOP("pendeskctl", "read and write registers"), runRegisters},
    Verb {"var", QT_TRANSLATE_NOOP("pendeskctl", "read and write variables"), runVar},
    Verb {"files", QT_TRANSLATE_NOOP("pendeskctl", "list, read, send and delete files"), runFiles},
    Verb {"check", QT_TRANSLATE_NOOP("pendeskctl", "look at jobs before they are sent"), runCheck},
    Verb {"backup", QT_TRANSLATE_NOOP("pendeskctl", "read all files of a controller into a new backup"), runBackup},
    Verb {"verify", QT_TRANSLATE_NOOP("pendeskctl", "tell whether a backup is what was written"), runVerify},
    Verb {"show", QT_TRANSLATE_NOOP("pendeskctl", "tell what controller files say"), runShow},
    Verb {"xref", QT_TRANSLATE_NOOP("pendeskctl", "tell where variables, signals and jobs are used"), runXref},
    Verb {"calls", QT_TRANSLATE_NOOP("pendeskctl", "tell which job calls which"), runCalls},
    Verb {"unused", QT_TRANSLATE_NOOP("pendeskctl", "tell what in the files is worth a look"), runUnused},
    Verb {"compare", QT_TRANSLATE_NOOP("pendeskctl", "compare two backups, or one with the controller"), runCompare},
    Verb {"restore", QT_TRANSLATE_NOOP("pendeskctl", "send back what differs from a backup"), runRestore},
    Verb {"watch", QT_TRANSLATE_NOOP("pendeskctl", "read values again and again"), runWatch},
    Verb {"decode", QT_TRANSLATE_NOOP("pendeskctl", "take packets given in hex apart"), runDecode},
};

QString usage()
{
    QString text = QCoreApplication::translate("pendeskctl", "Usage: pendeskctl VERB [options]") + u'\n';
    for (const Verb &verb : verbs)
        text += QStringLiteral("  %1 %2\n")
                    .arg(QLatin1StringView(verb.name), -10)
                    .arg(QCoreApplication::translate("pendeskctl", verb.purpose));
    const QStringList remarks {
        QCoreApplication::translate("pendeskctl", "pendeskctl VERB --help tells more."),
        QCoreApplication::translate(
            "pendeskctl", "The controller is named with --host H, or with --profile NAME as Pendesk keeps it."),
        QCoreApplication::translate("pendeskctl", "What changes something does nothing without --yes."),
        QCoreApplication::translate("pendeskctl",
            "Exit codes: 0 done, 1 differences, 2 wrong call, 3 no answer or outcome unknown, 4 refused,\n"
            "5 local file error, 6 verification failed, 7 done in part."),
    };
    return text + u'\n' + remarks.join(u'\n');
}

/// Backups get their name last and files are replaced at once, so it does no harm to stop anywhere.
void onInterrupt(int) { std::_Exit(Interrupted); }

} // namespace

int main(int argc, char *argv[])
{
    const QCoreApplication application {argc, argv};
    std::signal(SIGINT, onInterrupt);
    QCoreApplication::setApplicationName(QStringLiteral("pendesk"));
    QCoreApplication::setOrganizationName(QStringLiteral("pendesk"));
    QCoreApplication::setApplicationVersion(QStringLiteral(PENDESK_VERSION));
    const QStringList arguments = QCoreApplication::arguments().sliced(1);
    const QString first = arguments.value(0);
    for (const Verb &verb : verbs) {
        if (first == QLatin1StringView(verb.name))
            return verb.run(arguments);
    }
    if (first == u"--help" || first == u"-h") {
        print(usage().split(u'\n'));
        return Done;
    }
    if (first == u"--version") {
        print(QStringLiteral("pendeskctl " PENDESK_VERSION));
        return Done;
    }
    if (!first.isEmpty())
        complain(QCoreApplication::translate("pendeskctl", "there is no verb “%1”.").arg(first));
    std::fprintf(stderr, "%s\n", qUtf8Printable(usage()));
    return Usage;
}
