// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzztargets.h"
#include "support/golden.h"
#include <QTest>
#include <random>

/// Golden packets with a few bytes changed never upset anything. The seed is fixed: every run is the same.
class MutationsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingBreaks_data();
    void nothingBreaks();
};

namespace {

using Target = void (*)(QByteArrayView);
constexpr int executions = 50000;
constexpr qsizetype headerToDrop = 29; ///< Leaves a few bytes before the payload to choose with.

class Mutator
{
public:
    /// A golden packet, whole or from its last header bytes on, with up to eight changes.
    QByteArray next(bool isWhole)
    {
        QByteArray bytes = m_seeds[below(m_seeds.size())];
        if (!isWhole)
            bytes = bytes.mid(headerToDrop);
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

    static QList<QByteArray> seeds()
    {
        QList<QByteArray> packets {QByteArray {}};
        for (const auto &exchange : golden::exchanges()) {
            for (const auto &packet : exchange.packets)
                packets += packet.bytes;
        }
        for (const auto &row : golden::refused())
            packets += row.bytes;
        return packets;
    }

    QList<QByteArray> m_seeds = seeds();
    std::mt19937 m_random {20240229};
};

} // namespace

Q_DECLARE_METATYPE(Target)

void MutationsTest::nothingBreaks_data()
{
    QTest::addColumn<Target>("target");
    QTest::addColumn<bool>("isWhole");
    QTest::newRow("packet") << Target {fuzz::packet} << true;
    QTest::newRow("payload") << Target {fuzz::payload} << false;
    QTest::newRow("file blocks") << Target {fuzz::fileBlocks} << false;
    QTest::newRow("text") << Target {fuzz::text} << false;
}

void MutationsTest::nothingBreaks()
{
    QFETCH(Target, target);
    QFETCH(bool, isWhole);
    Mutator mutator;
    for (int execution = 0; execution < executions; ++execution)
        target(mutator.next(isWhole));
}

QTEST_APPLESS_MAIN(MutationsTest)
#include "tst_mutations.moc"
