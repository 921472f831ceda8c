// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "names/namefile.h"

namespace fuzz {

namespace {

/// The first byte chooses an encoding; then a controller's file of names.
void take(QByteArrayView data)
{
    Source source {data};
    const protocol::TextCodec codec {source.choose(protocol::encodings()).encoding};
    const auto read = names::readNames(source.rest(), codec, protocol::dialect(protocol::Model::YRC1000));
    require(read.remarkCount >= read.remarks.size() && read.remarks.size() <= names::NameFile::maxRemarks,
        "remarks without a bound");
    require(read.signalNames.size() + read.variableNames.size()
            <= source.rest().count('\n') + source.rest().count('\r') + 1,
        "more names than lines");
}

Seeds seeds()
{
    Seeds seeds;
    for (const QByteArray &file : demoFiles("NAME.DAT"))
        seeds << '\0' + file << '\2' + file;
    return seeds;
}

} // namespace

extern const Target nameFile;
const Target nameFile {"nameFile", take, seeds};

} // namespace fuzz
