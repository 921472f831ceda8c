// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QByteArrayView>
#include <QList>
#include <span>

/// What must hold for any bytes at all that come from outside: one target a parser, in a file of its own. libFuzzer
/// calls them without end (tests/fuzz/run), and a test a fixed number of times (tests/fuzz/tst_targets.cpp).
namespace fuzz {

using Seeds = QList<QByteArray>;

/// One parser, and what must hold of it. One call tries one thing, chosen by the first bytes, so that calls are quick
/// and the fuzzer sees what its choice led to.
struct Target {
    const char *name;
    void (*take)(QByteArrayView data); ///< Aborts the program where something does not hold.
    Seeds (*seeds)(); ///< Good and bad input to start from; not empty.
    int longest = 320; ///< Bytes of input that are of use.
    int tries = 20'000; ///< How often the test calls it; fewer where a call touches a disk.
};

/// All of them: the table in targets.cpp.
[[nodiscard]] std::span<const Target *const> targets();

/// Aborts with `what` unless it holds.
void require(bool holds, const char *what);

/// Takes bytes off the front; 0 when there are none left.
class Source
{
public:
    explicit Source(QByteArrayView data) : m_rest {data} { }

    quint8 byte()
    {
        const auto taken = take(1);
        return taken.isEmpty() ? quint8(0) : quint8(taken.front());
    }
    QByteArrayView take(qsizetype size)
    {
        const auto taken = m_rest.first(std::min(size, m_rest.size()));
        m_rest = m_rest.sliced(taken.size());
        return taken;
    }
    /// One of several things.
    const auto &choose(const auto &things) { return things[byte() % std::size(things)]; }
    [[nodiscard]] QByteArrayView rest() const { return m_rest; }
    [[nodiscard]] QString text() const { return QString::fromUtf8(m_rest); }

private:
    QByteArrayView m_rest;
};

/// Every packet of tests/data/golden.json, and nothing at all.
[[nodiscard]] Seeds goldenPackets();
/// The demo's files whose names end so.
[[nodiscard]] Seeds demoFiles(QByteArrayView ending);

} // namespace fuzz
