// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "support/golden.h"
#include "virtualcontroller/memory.h"

/// All targets: one line each, and a file of its own beside this one that defines it.
#define PENDESK_FUZZ_TARGETS(TARGET)                                                                                   \
    TARGET(packet)                                                                                                     \
    TARGET(payload)                                                                                                    \
    TARGET(fileBlocks)                                                                                                 \
    TARGET(capture)                                                                                                    \
    TARGET(fileList)                                                                                                   \
    TARGET(text)                                                                                                       \
    TARGET(job)                                                                                                        \
    TARGET(program)                                                                                                    \
    TARGET(loadedFile)                                                                                                 \
    TARGET(cellFile)                                                                                                   \
    TARGET(localNames)                                                                                                 \
    TARGET(profile)                                                                                                    \
    TARGET(settingsFile)                                                                                               \
    TARGET(incident)                                                                                                   \
    TARGET(signalSet)                                                                                                  \
    TARGET(csv)                                                                                                        \
    TARGET(pasted)                                                                                                     \
    TARGET(number)                                                                                                     \
    TARGET(reference)                                                                                                  \
    TARGET(clock)                                                                                                      \
    TARGET(state)                                                                                                      \
    TARGET(script)                                                                                                     \
    TARGET(faults)                                                                                                     \
    TARGET(hexLine)                                                                                                    \
    TARGET(localFileName)                                                                                              \
    TARGET(lineDiff)                                                                                                   \
    TARGET(bagText)                                                                                                    \
    TARGET(bag)                                                                                                        \
    TARGET(pinned)                                                                                                     \
    TARGET(journalRow)

namespace fuzz {

#define PENDESK_DECLARE(name) extern const Target name;
PENDESK_FUZZ_TARGETS(PENDESK_DECLARE)

std::span<const Target *const> targets()
{
#define PENDESK_LIST(name) &name,
    static constexpr const Target *all[] {PENDESK_FUZZ_TARGETS(PENDESK_LIST)};
    return all;
}

void require(bool holds, const char *what)
{
    if (!holds)
        qFatal("%s", what);
}

Seeds goldenPackets()
{
    Seeds packets {QByteArray {}};
    for (const auto &exchange : golden::exchanges()) {
        for (const auto &sent : exchange.packets)
            packets << sent.bytes;
    }
    for (const auto &row : golden::malformed())
        packets << row.bytes;
    for (const auto &row : golden::refused())
        packets << row.bytes;
    return packets;
}

Seeds demoFiles(QByteArrayView ending)
{
    Seeds files;
    for (const auto &[name, contents] : virtualcontroller::Memory {}.files) {
        if (name.endsWith(ending))
            files << contents;
    }
    return files;
}

} // namespace fuzz
