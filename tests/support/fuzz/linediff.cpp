// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "files/noise.h"
#include "inform/linediff.h"

namespace fuzz {

namespace {

/// The newer lines, made of the older ones and the hunks.
QByteArrayList patched(const QByteArrayList &older, const QByteArrayList &newer, const QList<inform::Hunk> &hunks)
{
    QByteArrayList result;
    qsizetype at = 0;
    for (const inform::Hunk &hunk : hunks) {
        result += older.mid(at, hunk.oldFrom - at);
        result += newer.mid(hunk.newFrom, hunk.newCount);
        at = hunk.oldFrom + hunk.oldCount;
    }
    return result + older.mid(at);
}

/// Two texts with a zero byte between them: what differs, and nothing else, makes one of the other.
void take(QByteArrayView data)
{
    const qsizetype end = data.indexOf('\0');
    const auto older = data.first(end < 0 ? data.size() : end).toByteArray().split('\n');
    const auto newer = data.sliced(end < 0 ? data.size() : end + 1).toByteArray().split('\n');
    require(patched(older, newer, inform::diffLines(older, newer)) == newer, "a difference is wrong");
    require(inform::diffLines(older, older).isEmpty(), "a text differs from itself");
    const files::NoiseFilter noise;
    const QByteArray text = data.toByteArray();
    require(noise.cleanLines(text) == noise.cleanLines(text), "the same text differs");
}

Seeds seeds()
{
    Seeds seeds {QByteArrayLiteral("a\nb\nc\0a\nc\nd"), QByteArrayLiteral("///DATE 2026/01/31 08:30\nNOP\0NOP\nEND")};
    for (const QByteArray &job : demoFiles(".JBI"))
        seeds << job.left(150) + '\0' + job.mid(20, 150);
    return seeds;
}

} // namespace

extern const Target lineDiff;
const Target lineDiff {"lineDiff", take, seeds, 320, 5000};

} // namespace fuzz
