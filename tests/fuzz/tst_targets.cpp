// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"
#include <QTest>
#include <random>

/// Good and bad input with a few bytes changed never upsets a parser. The seed is fixed: every run is the same.
class TestTargets : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingBreaks_data();
    void nothingBreaks();
};

namespace {

class Mutator
{
public:
    explicit Mutator(const fuzz::Seeds &seeds) : m_seeds {seeds} { }

    /// A seed with up to seven changes.
    QByteArray next()
    {
        QByteArray bytes = m_seeds[below(m_seeds.size())];
        for (auto changes = below(8); changes > 0; --changes)
            change(bytes);
        return bytes;
    }

private:
    qsizetype below(qsizetype limit) { return qsizetype(m_random() % quint32(limit)); }

    void change(QByteArray &bytes)
    {
        const qsizetype at = below(bytes.size() + 1);
        switch (below(4)) {
        case 0: bytes.insert(at, char(m_random())); break;
        case 1: bytes.remove(at, below(8)); break;
        case 2: bytes.truncate(at); break;
        default:
            if (at < bytes.size())
                bytes[at] = char(m_random());
        }
    }

    fuzz::Seeds m_seeds;
    std::mt19937 m_random {20240229};
};

} // namespace

Q_DECLARE_METATYPE(const fuzz::Target *)

void TestTargets::nothingBreaks_data()
{
    QTest::addColumn<const fuzz::Target *>("target");
    for (const fuzz::Target *target : fuzz::targets())
        QTest::newRow(target->name) << target;
}

void TestTargets::nothingBreaks()
{
    QFETCH(const fuzz::Target *, target);
    const fuzz::Seeds seeds = target->seeds();
    QVERIFY(!seeds.isEmpty());
    for (const QByteArray &seed : seeds)
        target->take(seed);
    Mutator mutator {seeds};
    for (int execution = 0; execution < target->tries; ++execution)
        target->take(mutator.next());
}

QTEST_GUILESS_MAIN(TestTargets)
#include "tst_targets.moc"
