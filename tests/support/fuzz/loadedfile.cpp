// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "virtualcontroller/filestore.h"
#include <algorithm>

namespace fuzz {

namespace {

/// The first line is the name of a file that is loaded into a running controller: it is refused, or there afterwards,
/// and nothing else has changed.
void take(QByteArrayView data)
{
    using namespace virtualcontroller;
    static const Memory original = Memory::demo();
    static Memory memory = original;
    const qsizetype end = std::max<qsizetype>(data.indexOf('\n'), 0);
    const QByteArray name = data.first(end).toByteArray();
    const QByteArray contents = data.sliced(std::min(end + 1, data.size())).toByteArray();
    if (filestore::loadRefusal(memory, name) || filestore::load(memory, name, contents))
        return require(memory.files.size() == original.files.size(), "a refused file was kept");
    const auto kept = std::ranges::count_if(memory.files, [&](const auto &entry) { return entry.second == contents; });
    require(kept >= 1 && memory.files.size() <= original.files.size() + 1, "a file was lost");
    memory.files = original.files;
}

Seeds seeds()
{
    Seeds seeds {"A.CND\n//TOOL 0\r\n"};
    for (const QByteArray &job : demoFiles(".JBI"))
        seeds << "A.JBI\n" + job;
    return seeds;
}

} // namespace

extern const Target loadedFile;
const Target loadedFile {"loadedFile", take, seeds};

} // namespace fuzz
