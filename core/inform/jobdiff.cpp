// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/alignment.h"
#include "inform/jobdiffparts.h"

#include <algorithm>
#include <map>
#include <set>

namespace inform {

namespace {

using Edits = QList<JobEdit>;

QByteArray valuesOf(const Point &point)
{
    QByteArray text = point.type.toByteArray() + ' ' + point.values.toByteArray();
    if (point.isOfRobot() && !point.tool.isEmpty())
        text += " TOOL " + point.tool.toByteArray();
    if (!point.user.isEmpty())
        text += " USER " + point.user.toByteArray();
    return text;
}

/// As instructions write it: P012 for the entry P00012.
QByteArray nameOf(const Point &point)
{
    if (point.isTaught())
        return point.name.toByteArray();
    return point.kind.toByteArray() + QByteArray::number(point.number).rightJustified(3, '0');
}

/// The points that a line owns, in its order.
QList<const Point *> pointsOf(const Job &job, int line)
{
    QList<const Point *> result;
    for (const Token &token : job.tokensOf(job.at(line))) {
        const Point *point = token.kind == TokenKind::Point ? job.point(token.in(job.at(line).text)) : nullptr;
        if (point)
            result << point;
    }
    return result;
}

/// Goes through the pairs of lines and says what is different.
class Differ
{
public:
    Differ(const Job &older, const Job &newer, const Clean &clean)
        : m_older {older}, m_newer {newer}, m_clean {clean}, m_pairs {alignLines(older, newer, clean)}
    {
    }
    Edits edits();

private:
    void findMoves();
    void addLine(const LinePair &pair);
    void addLonely(EditKind kind, const Job &job, int line);
    void addOwnedPoints(int oldLine, int newLine);
    void addPoint(const Point *older, const Point *newer, int line);
    void addOtherPoints();
    [[nodiscard]] QList<QList<int>> runs(bool isRemoved) const;
    [[nodiscard]] bool isSameRun(const QList<int> &removed, const QList<int> &added) const;
    [[nodiscard]] bool isWorthNaming(const QList<int> &removed) const;

    const Job &m_older;
    const Job &m_newer;
    const Clean &m_clean;
    QList<LinePair> m_pairs;
    std::set<int> m_movedFrom;
    std::map<int, std::pair<int, int>>
        m_movedTo; ///< First line → where it stood, how many lines; the others map to 0 lines.
    std::set<const Point *> m_seen;
    Edits m_edits;
};

/// Stretches of lines that were removed, or added, without another line between.
QList<QList<int>> Differ::runs(bool isRemoved) const
{
    QList<QList<int>> result;
    int last = -2;
    for (const LinePair &pair : m_pairs) {
        const int line = isRemoved ? pair.older : pair.newer;
        if (pair.isBoth() || line < 0)
            continue;
        if (line != last + 1)
            result << QList<int> {};
        result.last() << line;
        last = line;
    }
    return result;
}

bool Differ::isSameRun(const QList<int> &removed, const QList<int> &added) const
{
    return std::ranges::equal(removed, added,
        [this](int older, int newer) { return lineKey(m_older, older, m_clean) == lineKey(m_newer, newer, m_clean); });
}

/// A lonely ENDIF is found in many places.
bool Differ::isWorthNaming(const QList<int> &removed) const
{
    return removed.size() > 1 || !pointsOf(m_older, removed.first()).isEmpty();
}

void Differ::findMoves()
{
    auto added = runs(false);
    for (const QList<int> &removed : runs(true)) {
        const auto found = std::ranges::find_if(added, [&](const QList<int> &run) { return isSameRun(removed, run); });
        if (found == added.end() || !isWorthNaming(removed))
            continue;
        m_movedFrom.insert(removed.begin(), removed.end());
        for (qsizetype line = 0; line < removed.size(); ++line)
            addOwnedPoints(removed[line], found->at(line)); // they are the same, and owned
        for (const int line : *found)
            m_movedTo[line] = {-1, 0};
        m_movedTo[found->first()] = {removed.first(), int(removed.size())};
        added.erase(found);
    }
}

void Differ::addLonely(EditKind kind, const Job &job, int line)
{
    JobEdit edit {kind, line};
    QByteArrayList points;
    for (const Point *point : pointsOf(job, line)) {
        m_seen.insert(point);
        points << valuesOf(*point);
    }
    edit.newer = points.join(", ");
    edit.older = job.instruction(line).toByteArray();
    m_edits << edit;
}

void Differ::addLine(const LinePair &pair)
{
    if (pair.isBoth()) {
        if (!pair.isSame)
            m_edits << diffStatements(m_older, pair.older, m_newer, pair.newer, m_clean);
        return addOwnedPoints(pair.older, pair.newer);
    }
    if (pair.newer < 0)
        return m_movedFrom.contains(pair.older) ? void() : addLonely(EditKind::LineRemoved, m_older, pair.older);
    const auto moved = m_movedTo.find(pair.newer);
    if (moved == m_movedTo.end())
        return addLonely(EditKind::LineAdded, m_newer, pair.newer);
    if (moved->second.second > 0)
        m_edits << JobEdit {
            EditKind::LinesMoved, pair.newer, {}, {}, {}, {}, {}, moved->second.first, moved->second.second};
}

void Differ::addPoint(const Point *older, const Point *newer, int line)
{
    const bool isOld = older && !m_seen.insert(older).second;
    const bool isOldToo = newer && !m_seen.insert(newer).second;
    if (isOld || isOldToo)
        return;
    JobEdit edit {EditKind::PointChanged, line, {}, {}, nameOf(newer ? *newer : *older)};
    if (!older || !newer) {
        edit.kind = newer ? EditKind::PointAdded : EditKind::PointRemoved;
        (newer ? edit.newer : edit.older) = valuesOf(newer ? *newer : *older);
        m_edits << edit;
    } else if (const auto change = diffPoints(*older, *newer)) {
        edit.point = *change;
        m_edits << edit;
    }
}

/// Each kind by itself: the first C of one line is the first C of the other.
void Differ::addOwnedPoints(int oldLine, int newLine)
{
    const auto before = pointsOf(m_older, oldLine);
    const auto after = pointsOf(m_newer, newLine);
    for (const char *kind : pointKinds) {
        const auto isKind = [kind](const Point *point) { return point->kind == kind; };
        QList<const Point *> a;
        QList<const Point *> b;
        std::ranges::copy_if(before, std::back_inserter(a), isKind);
        std::ranges::copy_if(after, std::back_inserter(b), isKind);
        for (qsizetype index = 0; index < std::max(a.size(), b.size()); ++index)
            addPoint(a.value(index), b.value(index), newLine);
    }
}

/// Position variables by their number, and points that no line owns.
void Differ::addOtherPoints()
{
    std::map<std::pair<QByteArray, int>, std::pair<const Point *, const Point *>> points;
    const auto isLeft = [this](const Point &point) { return !m_seen.contains(&point); };
    for (const Point &point : m_older.points) {
        if (isLeft(point))
            points[{point.kind.toByteArray(), point.number}].first = &point;
    }
    for (const Point &point : m_newer.points) {
        if (isLeft(point))
            points[{point.kind.toByteArray(), point.number}].second = &point;
    }
    for (const auto &[name, versions] : points)
        addPoint(versions.first, versions.second, -1);
}

Edits Differ::edits()
{
    findMoves();
    m_edits = diffHeaders(m_older, m_newer, m_clean);
    for (const LinePair &pair : m_pairs)
        addLine(pair);
    addOtherPoints();
    return m_edits;
}

} // namespace

QList<JobEdit> diffJobs(const Job &older, const Job &newer, const Clean &clean)
{
    return Differ {older, newer, clean}.edits();
}

} // namespace inform
