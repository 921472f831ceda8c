// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/readinesswords.h"

#include "protocol/codes.h"
#include "ui/conditionwords.h"
#include "ui/linkview.h"
#include "ui/words.h"
#include <QCoreApplication>
#include <QLocale>

using robot::Allowance;
using robot::Condition;
using robot::Evidence;
using robot::ReadinessFacts;
using robot::ReadinessRow;
using robot::Subject;
using widgets::Lamp;

namespace ui {

namespace {

struct Readiness {
    Q_DECLARE_TR_FUNCTIONS(Readiness)
};

QString modelName(protocol::Model model) { return QLatin1String(protocol::dialect(model).name); }

QString softwareOf(const ReadinessFacts &facts)
{
    return facts.system ? controllerText(facts.system->software.bytes()) : widgets::dash();
}

QString dataSentence(const ReadinessRow &row)
{
    if (row.error)
        return Readiness::tr("A signal group and a B variable were asked for: %1.").arg(protocol::explain(*row.error));
    return Readiness::tr("A signal group and a B variable are asked for while this sheet is open. Writing needs no "
                         "REMOTE; whether data are protected cannot be read.");
}

QString rangesSentence(const ReadinessRow &row, const ReadinessFacts &facts)
{
    const QString profile = modelName(facts.profile.model);
    if (row.evidence == Evidence::Unread)
        return Readiness::tr("The software version, which tells the model, was not read yet.");
    if (row.allowance == Allowance::NotAllowed) {
        const auto told = protocol::modelOfSoftware(facts.system->software.bytes());
        return Readiness::tr("The profile says %1, but %2 is the software of a %3.")
            .arg(profile, softwareOf(facts), modelName(told.value_or(facts.profile.model)));
    }
    if (row.allowance == Allowance::NotKnown)
        return Readiness::tr("The software %1 does not tell the model. The ranges are those of the profile's %2.")
            .arg(softwareOf(facts), profile);
    return Readiness::tr("The software %1 is that of a %2. Its ranges come from a table, not from the controller.")
        .arg(softwareOf(facts), profile);
}

QString holdSentence(const ReadinessRow &row)
{
    if (row.error)
        return Readiness::tr("The last HOLD was refused: %1.").arg(protocol::explain(*row.error));
    if (row.evidence == Evidence::Measured && row.allowance == Allowance::Allowed)
        return Readiness::tr("The last HOLD was confirmed by the status. It is a software hold, no emergency stop.");
    if (row.evidence == Evidence::Measured)
        return Readiness::tr("The last HOLD was sent, and the status did not confirm it.");
    return Readiness::tr(
        "It needs neither REMOTE nor an access level, and was not tried. It is a software hold, no emergency stop.");
}

QString filesSentence(const ReadinessRow &row, const ReadinessFacts &facts)
{
    const quint16 port = facts.profile.filePort;
    if (row.error)
        return Readiness::tr("A list of jobs was asked for at port %1: %2.")
            .arg(port)
            .arg(protocol::explain(*row.error));
    if (row.evidence == Evidence::Unread)
        return Readiness::tr("A list of jobs is asked for at port %1.").arg(port);
    return Readiness::tr("Port %1 lists the jobs. Sending and deleting files need REMOTE.").arg(port);
}

QString numberingSentence(const ReadinessRow &row, const ReadinessFacts &facts)
{
    const settings::Profile &profile = facts.profile;
    const int first = int(profile.numbering);
    if (profile.isSimulation)
        return Readiness::tr("This simulation has B000 at number %1 on the network.").arg(first);
    if (row.evidence == Evidence::Unread)
        return Readiness::tr("The software version, with which it was compared, was not read yet.");
    if (row.evidence == Evidence::Unreadable && profile.numberingVerified.isValid())
        return Readiness::tr(
            "It was compared with software %1, but %2 runs now: variables are not written before it is "
            "compared again.")
            .arg(profile.numberingSoftware, softwareOf(facts));
    if (row.evidence == Evidence::Unreadable)
        return Readiness::tr("Whether B000 is number 0 or 1 on the network is unverified; variables are not written.");
    const QString date = QLocale().toString(profile.numberingVerified.toLocalTime().date(), QLocale::ShortFormat);
    return profile.numbering == protocol::Numbering::FromZero
        ? Readiness::tr("Compared with the pendant on %1: number 0 on the network is B000.").arg(date)
        : Readiness::tr("Compared with the pendant on %1, shifted: number 1 on the network is B000.").arg(date);
}

QString readingSentence(const ReadinessRow &row)
{
    if (row.allowance == Allowance::NotAllowed)
        return Readiness::tr("The controller does not answer any more. Reading resumes by itself.");
    return Readiness::tr("The controller tells its status and system information. Reading needs no REMOTE.");
}

QString meaning(const ReadinessRow &row, const ReadinessFacts &facts)
{
    switch (row.subject) {
    case Subject::Reading: return readingSentence(row);
    case Subject::Data: return dataSentence(row);
    case Subject::Ranges: return rangesSentence(row, facts);
    case Subject::Remote:
        return Readiness::tr("Orders are taken in command remote alone: start, select, reset, cycle, servo on.");
    case Subject::JobSelect: return Readiness::tr("It needs REMOTE, and that no job runs.");
    case Subject::JobStart:
        return Readiness::tr("It needs PLAY, REMOTE, servo on and a job, and nothing that holds the robot.");
    case Subject::Servo:
        return Readiness::tr("It needs PLAY and REMOTE. Servo off can always be ordered from here; whether it is taken "
                             "without REMOTE is up to the controller.");
    case Subject::Moves:
        return Readiness::tr("They need what a start needs, but for the job, and a model that knows them.");
    case Subject::Hold: return holdSentence(row);
    case Subject::Files: return filesSentence(row, facts);
    case Subject::Overwrite: return Readiness::tr("Sending a file that exists there needs REMOTE and two parameters.");
    case Subject::Numbering: return numberingSentence(row, facts);
    }
    return {};
}

QString listed(const QList<Condition> &conditions, QString (*toText)(Condition))
{
    QStringList words;
    for (const Condition condition : conditions)
        words << toText(condition);
    return words.join(QStringLiteral(" · "));
}

/// The one that a person should see to first. REMOTE has a row of its own; in TEACH somebody else has the robot.
std::optional<Condition> foremost(const ReadinessRow &row)
{
    if (row.obstacles.contains(Condition::NotTeach))
        return Condition::NotTeach;
    for (const Condition condition : row.obstacles) {
        if (condition != Condition::Remote || row.subject == Subject::Remote)
            return condition;
    }
    if (row.evidence == Evidence::Unreadable && !row.untold.isEmpty())
        return row.untold.first();
    return std::nullopt;
}

} // namespace

QString title(Subject subject)
{
    switch (subject) {
    case Subject::Reading: return Readiness::tr("Reading");
    case Subject::Data: return Readiness::tr("I/O and variables");
    case Subject::Ranges: return Readiness::tr("Ranges of the model");
    case Subject::Remote: return Readiness::tr("Orders (REMOTE)");
    case Subject::JobSelect: return Readiness::tr("Selecting a job");
    case Subject::JobStart: return Readiness::tr("Starting a job");
    case Subject::Servo: return Readiness::tr("Switching servo on");
    case Subject::Moves: return Readiness::tr("Jog and move");
    case Subject::Hold: return Readiness::tr("HOLD (software)");
    case Subject::Files: return Readiness::tr("Files");
    case Subject::Overwrite: return Readiness::tr("Replacing files");
    case Subject::Numbering: return Readiness::tr("Numbering of variables");
    }
    return {};
}

widgets::Word word(Allowance allowance)
{
    switch (allowance) {
    case Allowance::Allowed: return {Readiness::tr("allowed"), Lamp::Filled};
    case Allowance::NotAllowed: return {Readiness::tr("not allowed"), Lamp::Warning};
    case Allowance::NotKnown: return {Readiness::tr("not known"), Lamp::Hollow};
    }
    return {};
}

QString word(Evidence evidence)
{
    switch (evidence) {
    case Evidence::Measured: return Readiness::tr("measured");
    case Evidence::Assumed: return Readiness::tr("assumed");
    case Evidence::Unreadable: return Readiness::tr("cannot be read");
    case Evidence::Unread: return Readiness::tr("not read yet");
    }
    return {};
}

QString sentence(const ReadinessRow &row, const ReadinessFacts &facts)
{
    QStringList sentences {meaning(row, facts)};
    if (!row.obstacles.isEmpty() && row.subject != Subject::Numbering)
        sentences << Readiness::tr("In the way: %1.").arg(listed(row.obstacles, complaint));
    else if (!row.untold.isEmpty())
        sentences << Readiness::tr("HSES does not tell whether this is so: %1.").arg(listed(row.untold, title));
    return sentences.join(u' ');
}

QString remedy(const ReadinessRow &row, const ReadinessFacts &facts)
{
    const auto condition = foremost(row);
    if (condition)
        return Readiness::tr("What helps: %1.").arg(remedy(*condition, facts.profile.model));
    if (row.subject == Subject::Reading && row.allowance == Allowance::NotAllowed)
        return Readiness::tr("Diagnose… in the rail finds out at which step it fails.");
    if (row.subject == Subject::Ranges && row.allowance == Allowance::NotAllowed)
        return Readiness::tr("Correct the model in the profile (Connect…).");
    if (row.subject == Subject::Hold && row.allowance != Allowance::Allowed)
        return Readiness::tr("Use the pendant.");
    return {};
}

QString toText(const QList<ReadinessRow> &rows, const ReadinessFacts &facts)
{
    QStringList lines {Readiness::tr("Pendesk %1, readiness of %2 (%3), %4, %5")
                           .arg(QCoreApplication::applicationVersion(), facts.profile.name, addressText(facts.profile),
                               softwareOf(facts), linkWord(facts.link))};
    for (const ReadinessRow &row : rows) {
        lines << Readiness::tr("%1: %2, %3", "subject, allowance, evidence")
                     .arg(title(row.subject), word(row.allowance).text, word(row.evidence));
        lines << QStringLiteral("  ") + sentence(row, facts);
        if (const QString help = remedy(row, facts); !help.isEmpty())
            lines << QStringLiteral("  ") + help;
    }
    return lines.join(u'\n') + u'\n';
}

} // namespace ui
