// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/alignment.h"

#include <QHash>
#include <algorithm>
#include <limits>

namespace inform {

namespace {

/// Hunks with more pairs of lines than this are not searched for the best pairing.
constexpr qint64 mostPairs = 250000;

std::vector<int> numbersOf(const Job &job, QHash<QByteArray, int> &numbers, const Clean &clean)
{
    std::vector<int> result;
    result.reserve(job.instructions.size());
    for (int line = 0; line < job.lineCount(); ++line) {
        const QByteArray key = lineKey(job, line, clean);
        result.push_back(numbers.emplace(key, numbers.value(key, int(numbers.size()))).value());
    }
    return result;
}

/// What a line is made of, for telling how alike two lines are.
struct Shape {
    LineKind kind;
    QByteArrayList words; ///< Of its parts.
    QList<QByteArray> operands; ///< Canonical; a point as what it is.
    QList<QList<QByteArrayView>> points; ///< The values of each.
    QByteArrayList pointKeys;
};

Shape shapeOf(const Job &job, int number)
{
    const Line &line = job.at(number);
    Shape shape {line.kind, {}, {}, {}, {}};
    for (const Token &token : job.tokensOf(line)) {
        if (token.kind == TokenKind::Word)
            shape.words << token.in(line.text).toByteArray();
        else if (token.kind == TokenKind::Point) {
            const Point *point = job.point(token.in(line.text));
            const auto values = point ? splitAt(point->values, ',') : std::vector<QByteArrayView> {};
            shape.points << QList<QByteArrayView>(values.begin(), values.end());
            shape.pointKeys << (point ? point->kind.toByteArray() + pointKey(*point) : QByteArray {});
        } else if (token.kind != TokenKind::PartSign && token.kind != TokenKind::Prefix)
            shape.operands << canonical(token, line.text);
    }
    return shape;
}

/// From 0 for one place to 1 for places that have nothing in common.
double distance(const Shape &older, const Shape &newer, qsizetype index)
{
    if (older.pointKeys[index] == newer.pointKeys[index])
        return 0;
    const auto &a = older.points[index];
    const auto &b = newer.points[index];
    qsizetype same = 0;
    for (qsizetype axis = 0; axis < std::min(a.size(), b.size()); ++axis)
        same += a[axis] == b[axis] ? 1 : 0;
    return 1 - 0.8 * double(same) / double(std::max<qsizetype>(1, std::max(a.size(), b.size())));
}

/// The share of the operands and points that differ, 0 to 1.
double difference(const Shape &older, const Shape &newer)
{
    double differing = 0;
    const qsizetype points = std::min(older.points.size(), newer.points.size());
    for (qsizetype index = 0; index < points; ++index)
        differing += distance(older, newer, index);
    const qsizetype operands = std::min(older.operands.size(), newer.operands.size());
    for (qsizetype index = 0; index < operands; ++index)
        differing += older.operands[index] == newer.operands[index] ? 0 : 1;
    const qsizetype all =
        std::max(older.points.size(), newer.points.size()) + std::max(older.operands.size(), newer.operands.size());
    differing += double(all - points - operands);
    return all == 0 ? 0 : differing / double(all);
}

/// What it costs to call one line the other, changed. Removing one and adding the other costs 2.
double cost(const Shape &older, const Shape &newer)
{
    if (older.kind != newer.kind)
        return 3;
    if (older.kind != LineKind::Instruction)
        return 1.5;
    const double differing = difference(older, newer);
    if (older.words == newer.words)
        return 0.2 + 1.2 * differing;
    const bool hasSamePoints = !older.pointKeys.isEmpty() && older.pointKeys == newer.pointKeys;
    return hasSamePoints ? 0.9 : 1.9;
}

/// The cheapest way from the older lines of a hunk to the newer ones.
class Pairing
{
public:
    Pairing(const Job &older, const Job &newer, const Hunk &hunk);
    [[nodiscard]] QList<LinePair> pairs();

private:
    enum class Way : quint8 { Remove, Add, Pair };

    [[nodiscard]] std::size_t place(int older, int newer) const
    {
        return std::size_t(older) * std::size_t(m_hunk.newCount + 1) + std::size_t(newer);
    }
    void fill();

    Hunk m_hunk;
    std::vector<Shape> m_older;
    std::vector<Shape> m_newer;
    std::vector<double> m_costs; ///< Of the lines before.
    std::vector<Way> m_ways;
};

Pairing::Pairing(const Job &older, const Job &newer, const Hunk &hunk) : m_hunk {hunk}
{
    for (int line = 0; line < hunk.oldCount; ++line)
        m_older.push_back(shapeOf(older, hunk.oldFrom + line));
    for (int line = 0; line < hunk.newCount; ++line)
        m_newer.push_back(shapeOf(newer, hunk.newFrom + line));
}

void Pairing::fill()
{
    const auto size = place(m_hunk.oldCount, m_hunk.newCount) + 1;
    m_costs.assign(size, std::numeric_limits<double>::max());
    m_ways.assign(size, Way::Add);
    m_costs[0] = 0;
    const auto improve = [this](std::size_t at, double total, Way way) {
        if (total < m_costs[at]) {
            m_costs[at] = total;
            m_ways[at] = way;
        }
    };
    for (int i = 0; i <= m_hunk.oldCount; ++i) {
        for (int j = 0; j <= m_hunk.newCount; ++j) {
            const double here = m_costs[place(i, j)];
            if (i < m_hunk.oldCount)
                improve(place(i + 1, j), here + 1, Way::Remove);
            if (j < m_hunk.newCount)
                improve(place(i, j + 1), here + 1, Way::Add);
            if (i < m_hunk.oldCount && j < m_hunk.newCount)
                improve(place(i + 1, j + 1), here + cost(m_older[std::size_t(i)], m_newer[std::size_t(j)]), Way::Pair);
        }
    }
}

QList<LinePair> Pairing::pairs()
{
    fill();
    QList<LinePair> result;
    int i = m_hunk.oldCount;
    int j = m_hunk.newCount;
    while (i > 0 || j > 0) {
        const Way way = m_ways[place(i, j)];
        i -= way == Way::Add ? 0 : 1;
        j -= way == Way::Remove ? 0 : 1;
        result << LinePair {way == Way::Add ? -1 : m_hunk.oldFrom + i, way == Way::Remove ? -1 : m_hunk.newFrom + j};
    }
    std::ranges::reverse(result);
    return result;
}

/// A hunk that is too large to search: line by line.
QList<LinePair> inOrder(const Hunk &hunk)
{
    QList<LinePair> result;
    for (int line = 0; line < hunk.oldCount; ++line)
        result << LinePair {hunk.oldFrom + line, -1};
    for (int line = 0; line < hunk.newCount; ++line)
        result << LinePair {-1, hunk.newFrom + line};
    return result;
}

QList<LinePair> pairsOf(const Job &older, const Job &newer, const Hunk &hunk)
{
    if (qint64(hunk.oldCount) * hunk.newCount > mostPairs || hunk.oldCount == 0 || hunk.newCount == 0)
        return inOrder(hunk);
    return Pairing {older, newer, hunk}.pairs();
}

} // namespace

QList<LinePair> alignLines(const Job &older, const Job &newer, const Clean &clean)
{
    QHash<QByteArray, int> numbers;
    const std::vector<int> oldLines = numbersOf(older, numbers, clean);
    const std::vector<int> newLines = numbersOf(newer, numbers, clean);
    QList<LinePair> result;
    int oldAt = 0;
    int newAt = 0;
    const auto addSameUntil = [&](int oldEnd) {
        while (oldAt < oldEnd)
            result << LinePair {oldAt++, newAt++, true};
    };
    for (const Hunk &hunk : diffSequences(oldLines, newLines)) {
        addSameUntil(hunk.oldFrom);
        result << pairsOf(older, newer, hunk);
        oldAt = hunk.oldFrom + hunk.oldCount;
        newAt = hunk.newFrom + hunk.newCount;
    }
    addSameUntil(older.lineCount());
    return result;
}

} // namespace inform
