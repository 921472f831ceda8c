// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/checkparts.h"

#include <algorithm>
#include <map>

namespace inform {

namespace {

using Name = std::pair<QByteArrayView, int>;
using Findings = QList<Finding>;

/// Where each taught point is named: the first line, and how many places.
struct Use {
    int line = -1;
    int places = 0;
};
using Uses = std::map<Name, Use>;

Uses usesOf(const Job &job)
{
    Uses uses;
    for (int number = 0; number < job.lineCount(); ++number) {
        for (const Token &token : job.tokensOf(job.at(number))) {
            const auto name = token.kind == TokenKind::Point ? pointName(token.in(job.at(number).text)) : std::nullopt;
            if (!name)
                continue;
            Use &use = uses[{name->kind, name->number}];
            use.line = use.places++ == 0 ? number : use.line;
        }
    }
    return uses;
}

int headerLine(const Job &job, QByteArrayView key)
{
    const auto found = std::ranges::find_if(job.lines,
        [key](const Line &line) { return line.kind == LineKind::Header && withoutBlanks(line.text).startsWith(key); });
    return found == job.lines.end() ? 0 : int(found - job.lines.begin()) + 1;
}

void checkCounts(const Job &job, Findings &findings)
{
    const PointCounts counts = job.counted();
    if (!job.announced) {
        findings << Finding {Fault::NoPointCount, headerLine(job, "///NPOS"), -1, job.points.empty() ? "" : "points"};
        return;
    }
    for (std::size_t kind = 0; kind < counts.size(); ++kind) {
        if (counts[kind] == job.announced->at(kind))
            continue;
        const QByteArrayList detail {
            pointKinds[kind], QByteArray::number(job.announced->at(kind)), QByteArray::number(counts[kind])};
        findings << Finding {Fault::WrongPointCount, headerLine(job, "///NPOS"), -1, detail.join(' ')};
        return; // one kind too many is another kind too few
    }
}

/// How many axes a control group of this kind may have (reference §3.2).
std::pair<int, int> axesOf(const Point &point)
{
    if (point.isOfRobot())
        return {6, 7};
    return point.kind.startsWith('B') ? std::pair {1, 3} : std::pair {1, 6};
}

void checkValues(const Point &point, Findings &findings)
{
    const QByteArray name = point.name.toByteArray();
    const auto count = int(splitAt(point.values, ',').size());
    const auto [least, most] = axesOf(point);
    if (count < least || count > most)
        findings << Finding {Fault::WrongAxisCount, point.line + 1, -1, name + ' ' + QByteArray::number(count)};
    else if (!point.numbers())
        findings << Finding {Fault::BadValue, point.line + 1, -1, name};
    const QByteArrayView layout = point.isPulse() ? "PULSE" : point.isAngle() ? "ANGLE" : "RECTAN";
    if (layout != point.layout)
        findings << Finding {Fault::WrongLayout, point.line + 1, -1, name};
}

/// The group that has the axes of a point: RB, BS or ST.
QByteArrayView groupOf(const Point &point)
{
    return point.isOfRobot() ? "RB" : point.kind.startsWith('B') ? "BS" : "ST";
}

bool hasGroup(const Job &job, QByteArrayView prefix)
{
    return std::ranges::any_of(job.groups, [prefix](const QByteArrayList &groups) {
        return std::ranges::any_of(groups, [prefix](const QByteArray &group) { return group.startsWith(prefix); });
    });
}

/// Position variables may be in jobs without a group: they are set there, not moved to.
void checkGroups(const Job &job, const Uses &uses, Findings &findings)
{
    for (const Point &point : job.points) {
        if (!point.isTaught() || hasGroup(job, groupOf(point)))
            continue;
        const auto use = uses.find({point.kind, point.number});
        const Fault fault = job.groups.isEmpty() ? Fault::NoGroup : Fault::GroupLacksAxes;
        findings << Finding {
            fault, point.line + 1, use == uses.end() ? -1 : use->second.line, point.kind.toByteArray()};
        return;
    }
}

void checkPoint(const Job &job, const Point &point, const Uses &uses, Findings &findings)
{
    const QByteArray name = point.name.toByteArray();
    if (job.point(point.name) != &point)
        findings << Finding {Fault::PointTwice, point.line + 1, -1, name};
    checkValues(point, findings);
    const auto use = uses.find({point.kind, point.number});
    if (point.isTaught() && use == uses.end())
        findings << Finding {Fault::PointUnused, point.line + 1, -1, name};
    if (point.kind == "C" && point.isPulse() && job.attributes.contains("RJ"))
        findings << Finding {Fault::PulseInRelativeJob, point.line + 1, -1, name};
}

void checkUses(const Job &job, const Uses &uses, Findings &findings)
{
    for (const auto &[name, use] : uses) {
        const QByteArray text = name.first.toByteArray() + QByteArray::number(name.second).rightJustified(5, '0');
        if (!job.point(text))
            findings << atLine(Fault::PointUndefined, job, use.line, text);
        else if (use.places > 1)
            findings << atLine(Fault::PointShared, job, use.line, text);
    }
}

} // namespace

void checkPoints(const Job &job, QList<Finding> &findings)
{
    checkCounts(job, findings);
    for (std::size_t index = 0; index < job.lines.size(); ++index) {
        if (job.lines[index].kind == LineKind::Foreign && job.lines[index].section == Section::Positions)
            findings << Finding {Fault::NoPosition, int(index) + 1};
    }
    const Uses uses = usesOf(job);
    for (const Point &point : job.points)
        checkPoint(job, point, uses, findings);
    checkGroups(job, uses, findings);
    checkUses(job, uses, findings);
}

} // namespace inform
