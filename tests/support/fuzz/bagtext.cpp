// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "files/bagtext.h"

namespace fuzz {

namespace {

/// What a manifest says is what was written, to the byte; any bag-info.txt is read and written again.
void take(QByteArrayView data)
{
    const QByteArray text = data.toByteArray();
    if (const auto manifest = files::manifestFrom(text))
        require(files::toText(*manifest) == text, "a manifest is not as it was written");
    (void)files::toText(files::bagInfoFrom(text), 0, 0);
}

Seeds seeds()
{
    files::BagInfo info;
    info.controller = QStringLiteral("CELL 4");
    info.host = QStringLiteral("192.168.1.31");
    info.results = {{"HOME.JBI", {}}, {"*.CND", values::Error {values::ErrorKind::Refused, {}}}};
    return {files::toText(info, 12, 1), QByteArray(64, 'a') + "  data/A.JBI\n", QByteArray(64, 'a') + "  ../A.JBI\n",
        "Bagging-Date: 2026-01-31\n continued\nno label\n"};
}

} // namespace

extern const Target bagText;
const Target bagText {"bagText", take, seeds};

} // namespace fuzz
