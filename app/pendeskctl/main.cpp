// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "decode.h"
#include "options.h"
#include "status.h"
#include <QCoreApplication>
#include <array>

using namespace pendeskctl;

namespace {

struct Verb {
    const char *name;
    const char *purpose;
    int (*run)(const QStringList &arguments);
};

constexpr std::array verbs {
    Verb {"status", QT_TRANSLATE_NOOP("pendeskctl", "read status, job, position and system information"), runStatus},
    Verb {"decode", QT_TRANSLATE_NOOP("pendeskctl", "take packets given in hex apart"), runDecode},
};

QString usage()
{
    QString text = QCoreApplication::translate("pendeskctl", "Usage: pendeskctl VERB [options]") + u'\n';
    for (const Verb &verb : verbs)
        text += QStringLiteral("  %1 %2\n")
                    .arg(QLatin1StringView(verb.name), -10)
                    .arg(QCoreApplication::translate("pendeskctl", verb.purpose));
    return text + QCoreApplication::translate("pendeskctl", "pendeskctl VERB --help tells more.");
}

} // namespace

int main(int argc, char *argv[])
{
    const QCoreApplication application {argc, argv};
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
        print(usage());
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
