// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cellfiles/filetypes.h"
#include "support/fuzztargets.h"
#include "support/golden.h"
#include "virtualcontroller/memory.h"
#include <QDirIterator>
#include <QTest>
#include <random>

/// Golden packets and jobs with a few bytes changed never upset anything. The seed is fixed: every run is the same.
class MutationsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingBreaks_data();
    void nothingBreaks();
};

namespace {

using Target = void (*)(QByteArrayView);
using Seeds = QList<QByteArray>;
constexpr int executions = 50000;
constexpr qsizetype headerToDrop = 26; ///< Leaves a few bytes before the payload to choose with.

class Mutator
{
public:
    explicit Mutator(const Seeds &seeds) : m_seeds {seeds} { }

    /// A seed with up to eight changes.
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

    Seeds m_seeds;
    std::mt19937 m_random {20240229};
};

Seeds packets()
{
    Seeds packets {QByteArray {}};
    for (const auto &exchange : golden::exchanges()) {
        for (const auto &packet : exchange.packets)
            packets += packet.bytes;
    }
    for (const auto &row : golden::refused())
        packets += row.bytes;
    return packets;
}

/// Payloads and what is left of their headers.
Seeds payloads()
{
    Seeds payloads = packets();
    for (QByteArray &packet : payloads)
        packet.remove(0, headerToDrop);
    return payloads;
}

/// The jobs of the demo, once to be read and once to be loaded.
Seeds jobs()
{
    Seeds jobs;
    for (const auto &[name, contents] : virtualcontroller::Memory {}.files) {
        if (name.endsWith(".JBI"))
            jobs += {'\0' + contents, '\1' + name + '\n' + contents};
    }
    return jobs;
}

/// The small ones among the files of real forms, each with the bytes that choose its type.
Seeds cellFiles()
{
    constexpr qint64 small = 900;
    Seeds seeds;
    QDirIterator files {QStringLiteral(PENDESK_TEST_DATA "/cell"), QDir::Files, QDirIterator::Subdirectories};
    while (files.hasNext()) {
        QFile file {files.next()};
        if (file.size() > small || !file.open(QIODevice::ReadOnly))
            continue;
        const auto &type = cellfiles::fileTypeOf(files.fileName().toLatin1());
        const auto row = char(&type - cellfiles::fileTypes().data());
        const QByteArray content = file.readAll();
        seeds << QByteArray {1, row} + '\0' + '\0' + content << QByteArray {1, row} + '\2' + '\1' + content;
    }
    return seeds;
}

} // namespace

Q_DECLARE_METATYPE(Target)

void MutationsTest::nothingBreaks_data()
{
    QTest::addColumn<Target>("target");
    QTest::addColumn<Seeds>("seeds");
    QTest::newRow("packet") << Target {fuzz::packet} << packets();
    QTest::newRow("payload") << Target {fuzz::payload} << payloads();
    QTest::newRow("file blocks") << Target {fuzz::fileBlocks} << payloads();
    QTest::newRow("file list") << Target {fuzz::fileList} << payloads();
    QTest::newRow("text") << Target {fuzz::text} << payloads();
    QTest::newRow("INFORM") << Target {fuzz::inform} << jobs();
    QTest::newRow("cell files") << Target {fuzz::cellFile} << cellFiles();
}

void MutationsTest::nothingBreaks()
{
    QFETCH(Target, target);
    QFETCH(Seeds, seeds);
    Mutator mutator {seeds};
    for (int execution = 0; execution < executions; ++execution)
        target(mutator.next());
}

QTEST_APPLESS_MAIN(MutationsTest)
#include "tst_mutations.moc"
