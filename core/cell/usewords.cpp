// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cell/usewords.h"

#include "cell/sentences.h"
#include <algorithm>

namespace cell {

namespace {

QString certainText(How how)
{
    switch (how) {
    case How::Writes: return Sentences::tr("written");
    case How::Reads: return Sentences::tr("read");
    case How::Waits: return Sentences::tr("waited for");
    case How::Calls: return Sentences::tr("called");
    case How::JumpsTo: return Sentences::tr("jumped to");
    case How::Starts: return Sentences::tr("started");
    case How::Names: return Sentences::tr("named");
    }
    return {};
}

QString placesText(const QList<Place> &places, const Cell &cell)
{
    constexpr qsizetype most = 5;
    QStringList texts;
    for (const Place &place : places.first(std::min(places.size(), most)))
        texts << placeText(place, cell);
    return texts.join(QStringLiteral(", ")) + (places.size() > most ? QStringLiteral(", …") : QString {});
}

} // namespace

QString useText(const Use &use)
{
    const QString certain = certainText(use.how);
    return use.isMaybe ? Sentences::tr("may be %1").arg(certain) : certain;
}

QString placeText(const Place &place, const Cell &cell)
{
    const QString name = cell.codec.decode(place.name);
    const bool isKnown = place.kind == Place::Kind::Job || place.line > 0;
    return isKnown ? Sentences::tr("%1 line %2").arg(name).arg(place.line) : name;
}

QString lineText(const Place &place, const Cell &cell)
{
    if (place.kind == Place::Kind::Job) {
        const auto found = cell.jobs.find(place.name);
        const bool isThere = found != cell.jobs.end() && place.line >= 0 && place.line < found->second.job.lineCount();
        return isThere ? cell.codec.decode(found->second.job.instruction(place.line)) : QString {};
    }
    const auto &instructions = cell.ladder.instructions;
    const auto found = std::ranges::find(instructions, place.line, &cellfiles::LadderInstruction::line);
    const bool isLadder = place.kind == Place::Kind::Ladder && found != instructions.end();
    return isLadder ? cell.codec.decode(found->text()) : QString {};
}

QString subjectText(const Subject &subject, const Cell &cell)
{
    const bool isJob = subject.kind == Subject::Kind::Job;
    const QString text = isJob ? cell.codec.decode(subject.name) : toString(subject);
    const QString name = cell.nameOf(subject);
    return name.isEmpty() ? text : text + u' ' + name;
}

QString sentence(const Hint &hint, const Cell &cell)
{
    const QString subject = subjectText(hint.subject, cell);
    const QString places = placesText(hint.places, cell);
    switch (hint.kind) {
    case Hint::Kind::MissingJob: return Sentences::tr("%1 is called, and no file has it: %2.").arg(subject, places);
    case Hint::Kind::SeveralWriters: return Sentences::tr("%1 is written in several places: %2.").arg(subject, places);
    case Hint::Kind::NeverWritten:
        return Sentences::tr("%1 is read and never written in the files: %2.").arg(subject, places);
    case Hint::Kind::SeveralNames: return Sentences::tr("%1 has several names: %2.").arg(subject, places);
    case Hint::Kind::ToolNotEntered:
        return Sentences::tr("%1 is used and its data were not entered: %2.").arg(subject, places);
    case Hint::Kind::UnusedJob: return Sentences::tr("%1 is named by no other job and no macro.").arg(subject);
    }
    return {};
}

} // namespace cell
