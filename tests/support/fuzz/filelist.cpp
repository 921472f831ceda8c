// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "protocol/fileblocks.h"
#include "protocol/packet.h"
#include "protocol/requests.h"

using namespace protocol;
using namespace values;

namespace fuzz {

namespace {

/// A name out of a list names one file in one folder, and can be asked for.
void isPlainName(const FileName &name)
{
    const auto again = FileName::create(name.bytes());
    require(again && *again == name && !name.bytes().contains('/'), "a listed name is none");
    const QByteArray datagram = encodeFileRequest(saveFile(name), 1);
    const auto request = parseClientPacket(datagram);
    require(request && request->payload == name.bytes(), "a name cannot be asked for");
}

/// Each line that is not empty is the next name or the next rejected one.
bool isMadeOf(QByteArrayView content, const FileList &list)
{
    qsizetype names = 0;
    qsizetype rejected = 0;
    while (!content.isEmpty()) {
        const qsizetype found = content.indexOf('\n');
        auto line = found < 0 ? content : content.first(found);
        content = found < 0 ? QByteArrayView {} : content.sliced(found + 1);
        if (line.endsWith('\r'))
            line.chop(1);
        if (line.isEmpty())
            continue;
        if (names < list.names.size() && list.names[names].bytes() == line)
            ++names;
        else if (rejected < list.rejected.size() && list.rejected[rejected] == line)
            ++rejected;
        else
            return false;
    }
    return names == list.names.size() && rejected == list.rejected.size();
}

void take(QByteArrayView data)
{
    const FileList list = parseFileList(data.toByteArray());
    for (const auto &name : list.names)
        isPlainName(name);
    require(isMadeOf(data, list), "lines of a list were lost or made up");
}

Seeds seeds() { return {"HOME.JBI\r\nIONAME.DAT\r\n", "A.JBI\r\n\r\nB\\C.JBI\r\n.JBI", "A.JBI\nB.JBI"}; }

} // namespace

extern const Target fileList;
const Target fileList {"fileList", take, seeds, 160};

} // namespace fuzz
