// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/linediff.h"

#include <QHash>
#include <QList>
#include <algorithm>
#include <optional>
#include <span>
#include <vector>

namespace inform {

namespace {

constexpr int maxEdits = 1500;

using Lines = std::span<const int>; ///< Each line as the number of its text.

/// The greedy search of Myers: `reach` holds, by diagonal, how far one gets in the older text with so many edits.
class Search
{
public:
    Search(Lines older, Lines newer) : m_older {older}, m_newer {newer} { }

    /// The pairs of equal lines of a shortest edit, or nullopt if it is too long.
    std::optional<std::vector<std::pair<int, int>>> matches();

private:
    using Reach = QList<int>; ///< Index: diagonal + edits + 1.

    int x(const Reach &reach, int edits, int diagonal) const { return reach[diagonal + edits + 1]; }
    bool comesFromAbove(const Reach &before, int edits, int diagonal) const;
    bool advance(int edits);
    std::vector<std::pair<int, int>> goBack() const;

    Lines m_older;
    Lines m_newer;
    std::vector<Reach> m_reaches {Reach {-1, 0, -1}}; ///< [edits]: the state before they were made.
};

/// Whether the best way onto `diagonal` adds a line of the newer text rather than dropping one of the older.
bool Search::comesFromAbove(const Reach &before, int edits, int diagonal) const
{
    if (diagonal == -edits)
        return true;
    return diagonal != edits && x(before, edits - 1, diagonal - 1) < x(before, edits - 1, diagonal + 1);
}

/// One more edit; true when the end is reached.
bool Search::advance(int edits)
{
    const int oldSize = int(m_older.size());
    const int newSize = int(m_newer.size());
    const Reach &before = m_reaches.back();
    Reach after(2 * edits + 3, -1);
    bool isDone = false;
    for (int diagonal = -edits; diagonal <= edits; diagonal += 2) {
        int at = 0;
        if (edits > 0)
            at = comesFromAbove(before, edits, diagonal) ? x(before, edits - 1, diagonal + 1)
                                                         : x(before, edits - 1, diagonal - 1) + 1;
        while (at >= 0 && at < oldSize && at - diagonal < newSize && at - diagonal >= 0
            && m_older[std::size_t(at)] == m_newer[std::size_t(at - diagonal)])
            ++at;
        after[diagonal + edits + 1] = at;
        isDone = isDone || (at >= oldSize && at - diagonal >= newSize);
    }
    m_reaches.push_back(std::move(after));
    return isDone;
}

std::vector<std::pair<int, int>> Search::goBack() const
{
    std::vector<std::pair<int, int>> pairs;
    int at = int(m_older.size());
    int diagonal = at - int(m_newer.size());
    for (int edits = int(m_reaches.size()) - 2; edits >= 0; --edits) {
        int start = 0;
        int previous = 0;
        const Reach &before = m_reaches[std::size_t(edits)];
        if (edits > 0) {
            const bool isAdded = comesFromAbove(before, edits, diagonal);
            previous = isAdded ? diagonal + 1 : diagonal - 1;
            start = x(before, edits - 1, previous) + (isAdded ? 0 : 1);
        }
        for (; at > start; --at)
            pairs.emplace_back(at - 1, at - 1 - diagonal);
        if (edits > 0)
            at = x(before, edits - 1, previous);
        diagonal = previous;
    }
    std::ranges::reverse(pairs);
    return pairs;
}

std::optional<std::vector<std::pair<int, int>>> Search::matches()
{
    for (int edits = 0; edits <= maxEdits; ++edits) {
        if (advance(edits))
            return goBack();
    }
    return std::nullopt;
}

std::vector<int> numbered(const QByteArrayList &lines, QHash<QByteArray, int> &numbers)
{
    std::vector<int> result;
    for (const QByteArray &line : lines)
        result.push_back(numbers.emplace(line, numbers.value(line, int(numbers.size()))).value());
    return result;
}

/// What lies between the pairs.
QList<Hunk> hunksBetween(const std::vector<std::pair<int, int>> &pairs, int shift, int oldSize, int newSize)
{
    QList<Hunk> hunks;
    int oldAt = 0;
    int newAt = 0;
    const auto close = [&](int oldTo, int newTo) {
        if (oldTo > oldAt || newTo > newAt)
            hunks << Hunk {oldAt + shift, oldTo - oldAt, newAt + shift, newTo - newAt};
        oldAt = oldTo + 1;
        newAt = newTo + 1;
    };
    for (const auto &[oldLine, newLine] : pairs)
        close(oldLine, newLine);
    close(oldSize, newSize);
    return hunks;
}

} // namespace

QList<Hunk> diffSequences(Lines a, Lines b)
{
    const auto differing = std::ranges::mismatch(a, b);
    const auto prefix = std::size_t(differing.in1 - a.begin());
    a = a.subspan(prefix);
    b = b.subspan(prefix);
    while (!a.empty() && !b.empty() && a.back() == b.back()) {
        a = a.first(a.size() - 1);
        b = b.first(b.size() - 1);
    }
    const auto pairs = Search {a, b}.matches();
    return hunksBetween(pairs.value_or(std::vector<std::pair<int, int>> {}), int(prefix), int(a.size()), int(b.size()));
}

QList<Hunk> diffLines(const QByteArrayList &older, const QByteArrayList &newer)
{
    QHash<QByteArray, int> numbers;
    const std::vector<int> oldNumbers = numbered(older, numbers);
    const std::vector<int> newNumbers = numbered(newer, numbers);
    return diffSequences(oldNumbers, newNumbers);
}

} // namespace inform
