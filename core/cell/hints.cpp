// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cell/hints.h"

#include <QSet>
#include <algorithm>
#include <map>

namespace cell {

namespace {

constexpr int firstOutput = 10'000;
constexpr int lastOutput = 19'999;

bool isOutput(const Subject &subject)
{
    return subject.kind == Subject::Kind::Signal && subject.number >= firstOutput && subject.number <= lastOutput;
}

QList<Place> placesOf(const QList<Use> &uses, How how)
{
    QList<Place> places;
    for (const Use &use : uses) {
        if (use.how == how && !use.isMaybe && !places.contains(use.place))
            places << use.place;
    }
    return places;
}

/// A job counts once however often it writes; the ladder counts by instruction.
int writersOf(const QList<Place> &places)
{
    QSet<QByteArray> jobs;
    int instructions = 0;
    for (const Place &place : places) {
        if (place.kind == Place::Kind::Job)
            jobs.insert(place.name);
        else
            ++instructions;
    }
    return int(jobs.size()) + instructions;
}

QList<Hint> missingJobs(const CallTree &calls)
{
    std::map<QByteArray, QList<Place>> missing;
    for (const Call &call : calls.calls()) {
        if (call.isMissing)
            missing[call.callee] << Place {Place::Kind::Job, call.caller, call.line};
    }
    QList<Hint> hints;
    for (const auto &[job, places] : missing)
        hints << Hint {Hint::Kind::MissingJob, {Subject::Kind::Job, 0, job}, places};
    return hints;
}

QList<Hint> severalWriters(const CrossReference &uses)
{
    QList<Hint> hints;
    for (const Subject &subject : uses.subjects()) {
        const QList<Place> places = isOutput(subject) ? placesOf(uses.uses(subject), How::Writes) : QList<Place> {};
        if (writersOf(places) > 1)
            hints << Hint {Hint::Kind::SeveralWriters, subject, places};
    }
    return hints;
}

/// What may be written through an index, or is a position that people teach, is left out.
QList<Hint> neverWritten(const CrossReference &uses)
{
    QList<Hint> hints;
    for (const Subject &subject : uses.subjects()) {
        if (subject.kind > Subject::Kind::S)
            continue;
        const QList<Use> all = uses.uses(subject);
        const bool isWritten = std::ranges::any_of(all, [](const Use &use) { return use.how == How::Writes; });
        const QList<Place> places = placesOf(all, How::Reads) + placesOf(all, How::Waits);
        if (!isWritten && !places.isEmpty())
            hints << Hint {Hint::Kind::NeverWritten, subject, places};
    }
    return hints;
}

QList<Hint> severalNames(const CrossReference &uses)
{
    QList<Hint> hints;
    for (const Subject &subject : uses.subjects()) {
        const QList<Place> places =
            isVariable(subject.kind) ? placesOf(uses.uses(subject), How::Names) : QList<Place> {};
        if (places.size() > 1)
            hints << Hint {Hint::Kind::SeveralNames, subject, places};
    }
    return hints;
}

QList<Hint> toolsNotEntered(const Cell &cell, const CrossReference &uses)
{
    QList<Hint> hints;
    for (const cellfiles::Tool &tool : cell.tools) {
        const Subject subject {Subject::Kind::Tool, tool.number};
        const QList<Place> places = placesOf(uses.uses(subject), How::Reads);
        if (tool.number > 0 && tool.isWhole && tool.entryKind < 2 && !places.isEmpty())
            hints << Hint {Hint::Kind::ToolNotEntered, subject, places};
    }
    return hints;
}

QList<Hint> unusedJobs(const Cell &cell, const CallTree &calls)
{
    const bool usesMacros =
        std::ranges::any_of(calls.calls(), [](const Call &call) { return !call.through.isEmpty(); });
    QList<Hint> hints;
    if (calls.hasUnknownTargets() || (usesMacros && !cell.has("MACRO.DAT")))
        return hints;
    for (const QByteArray &job : calls.unused())
        hints << Hint {Hint::Kind::UnusedJob, {Subject::Kind::Job, 0, job}, {{Place::Kind::Job, job, 0}}};
    return hints;
}

} // namespace

QList<Hint> hintsOf(const Cell &cell, const CrossReference &uses, const CallTree &calls)
{
    return missingJobs(calls) + severalWriters(uses) + neverWritten(uses) + severalNames(uses)
        + toolsNotEntered(cell, uses) + unusedJobs(cell, calls);
}

} // namespace cell
