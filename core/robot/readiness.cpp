// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/readiness.h"

#include <array>

namespace robot {

namespace {

using enum Evidence;
using enum Allowance;

constexpr auto noAct = Act(-1);

struct SubjectRow {
    Subject subject;
    const char *key;
    Act act; ///< Whose conditions decide; noAct where there are others.
    std::optional<Condition> setting; ///< HSES does not tell it, and without it the act is refused.
};

/// One row a subject, in the order of Subject.
constexpr std::array subjectRows {
    SubjectRow {Subject::Reading, "reading", noAct, {}},
    SubjectRow {Subject::Data, "data", noAct, {}},
    SubjectRow {Subject::Ranges, "ranges", noAct, {}},
    SubjectRow {Subject::Remote, "remote", Act::ResetAlarm, {}}, // it needs REMOTE and nothing else
    SubjectRow {Subject::JobSelect, "job-select", Act::SelectJob, Condition::JobSelectPermitted},
    SubjectRow {Subject::JobStart, "job-start", Act::StartJob, {}},
    SubjectRow {Subject::Servo, "servo", Act::ServoOn, {}},
    SubjectRow {Subject::Moves, "moves", Act::Move, {}},
    SubjectRow {Subject::Hold, "hold", noAct, {}},
    SubjectRow {Subject::Files, "files", Act::DeleteFile, {}}, // it needs what every transfer needs
    SubjectRow {Subject::Overwrite, "overwrite", Act::Upload, Condition::OverwritePermitted},
    SubjectRow {Subject::Numbering, "numbering", noAct, {}},
};
static_assert(subjectRows.size() == subjectCount);

const SubjectRow &row(Subject subject) { return subjectRows[std::size_t(subject)]; }

/// The controller as it is, and a person who may do everything: what only this program asks for is met.
Situation allowedHere(const ReadinessFacts &facts)
{
    Situation situation = facts.situation;
    situation.isLinkUp = true;
    situation.level = Level::Engineer;
    situation.isArmed = true;
    return situation;
}

/// By the conditions of the subject's act.
ReadinessRow byAct(Subject subject, const ReadinessFacts &facts)
{
    if (!facts.situation.status)
        return {subject};
    ReadinessRow result {subject};
    bool isUnread = false;
    for (const Finding &finding : findings(row(subject).act, allowedHere(facts))) {
        if (finding.verdict == Verdict::NotMet)
            result.obstacles << finding.condition;
        else if (finding.verdict == Verdict::Unreadable)
            result.untold << finding.condition;
        isUnread |= finding.verdict == Verdict::Unread;
    }
    if (!result.obstacles.isEmpty())
        return {subject, NotAllowed, Measured, result.obstacles, result.untold};
    if (isUnread)
        return {subject};
    if (const auto setting = row(subject).setting)
        return {subject, NotKnown, Unreadable, {}, {*setting}};
    return {subject, Allowed, result.untold.isEmpty() ? Measured : Assumed, {}, result.untold};
}

ReadinessRow reading(const ReadinessFacts &facts)
{
    if (facts.link == LinkState::Lost)
        return {Subject::Reading, NotAllowed, Measured};
    return {Subject::Reading, Allowed, Measured};
}

ReadinessRow data(const ReadinessFacts &facts)
{
    using Outcome = Probe::Outcome;
    for (const Probe &probe : {facts.signal, facts.variable}) {
        if (probe.outcome == Outcome::Failed)
            return {Subject::Data, NotAllowed, Measured, {}, {}, probe.error};
    }
    if (facts.signal.outcome == Outcome::Unread || facts.variable.outcome == Outcome::Unread)
        return {Subject::Data};
    return {Subject::Data, Allowed, Measured};
}

/// No reply tells a range: at best the software tells the model.
ReadinessRow ranges(const ReadinessFacts &facts)
{
    if (!facts.system)
        return {Subject::Ranges};
    const auto told = protocol::modelOfSoftware(facts.system->software.bytes());
    if (told && *told != facts.profile.model)
        return {Subject::Ranges, NotAllowed, Measured};
    return {Subject::Ranges, told ? Allowed : NotKnown, Assumed};
}

/// Reference §10.2 lets HOLD on work always; only one that was ordered proves it.
ReadinessRow hold(const ReadinessFacts &facts)
{
    using Progress = HoldOrder::Progress;
    switch (facts.hold ? facts.hold->progress : Progress::UnderWay) {
    case Progress::Confirmed: return {Subject::Hold, Allowed, Measured};
    case Progress::Refused: return {Subject::Hold, NotAllowed, Measured, {}, {}, facts.hold->refusal};
    case Progress::Unconfirmed: return {Subject::Hold, NotKnown, Measured};
    case Progress::UnderWay: break;
    }
    return {Subject::Hold, Allowed, Assumed};
}

ReadinessRow moves(const ReadinessFacts &facts)
{
    ReadinessRow result = byAct(Subject::Moves, facts);
    if (result.obstacles.contains(Condition::ModelMoves)) // the profile says so, nothing that was read
        result = {Subject::Moves, NotAllowed, Assumed, {Condition::ModelMoves}};
    return result;
}

/// The list proves the port, the status REMOTE; no file was transferred.
ReadinessRow files(const ReadinessFacts &facts)
{
    if (facts.files.outcome == Probe::Outcome::Failed)
        return {Subject::Files, NotAllowed, Measured, {}, {}, facts.files.error};
    if (facts.files.outcome == Probe::Outcome::Unread)
        return {Subject::Files};
    return byAct(Subject::Files, facts);
}

ReadinessRow numbering(const ReadinessFacts &facts)
{
    if (facts.profile.isSimulation)
        return {Subject::Numbering, Allowed, Assumed};
    if (!facts.system)
        return {Subject::Numbering};
    if (facts.situation.isNumberingVerified)
        return {Subject::Numbering, Allowed, Measured};
    return {Subject::Numbering, NotKnown, Unreadable, {Condition::NumberingVerified}};
}

ReadinessRow judge(Subject subject, const ReadinessFacts &facts)
{
    switch (subject) {
    case Subject::Reading: return reading(facts);
    case Subject::Data: return data(facts);
    case Subject::Ranges: return ranges(facts);
    case Subject::Moves: return moves(facts);
    case Subject::Hold: return hold(facts);
    case Subject::Files: return files(facts);
    case Subject::Numbering: return numbering(facts);
    default: return byAct(subject, facts);
    }
}

} // namespace

QList<ReadinessRow> readiness(const ReadinessFacts &facts)
{
    const bool isKnown = facts.link == LinkState::Monitoring || facts.link == LinkState::Lost;
    QList<ReadinessRow> rows;
    for (const SubjectRow &row : subjectRows)
        rows << (isKnown ? judge(row.subject, facts) : ReadinessRow {row.subject});
    return rows;
}

ReadinessFacts readinessFacts(const Controller &controller, const Situation &situation)
{
    ReadinessFacts facts;
    facts.link = controller.linkState();
    facts.situation = situation;
    facts.situation.status = controller.state().status().value;
    facts.situation.job = controller.state().job().value;
    facts.profile = controller.profile();
    facts.system = controller.state().systemInformation().value;
    facts.hold = controller.holdFacts().order;
    return facts;
}

const char *key(Subject subject) { return row(subject).key; }

} // namespace robot
