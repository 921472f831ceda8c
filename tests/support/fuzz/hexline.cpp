// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "protocol/hextext.h"

namespace fuzz {

namespace {

/// A line as `pendeskctl decode` takes it: what it gives is what the digits say.
void take(QByteArrayView data)
{
    const QString line = QString::fromUtf8(data);
    const auto bytes = protocol::bytesFromHex(line);
    if (!bytes)
        return;
    require(!bytes->isEmpty() && protocol::bytesFromHex(QString::fromLatin1(bytes->toHex(' '))) == bytes,
        "bytes changed on the way");
    require(line.simplified().remove(u' ').toLower() == QString::fromLatin1(bytes->toHex()), "digits were made up");
}

Seeds seeds()
{
    return {"59455243 2000", "59 45\t52 43", "5", "0x59",
        "59\xC2\xA0"
        "45",
        "zz"};
}

} // namespace

extern const Target hexLine;
const Target hexLine {"hexLine", take, seeds, 80};

} // namespace fuzz
