// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "names/names.h"
#include <QJsonDocument>

namespace fuzz {

namespace {

/// Local names as they are kept in the settings: what was read is written so that it reads the same.
void take(QByteArrayView data)
{
    const auto &dialect = protocol::dialect(protocol::Model::YRC1000);
    names::Names names;
    names.setLocalNames(QJsonDocument::fromJson(data.toByteArray()).object(), dialect);
    const QJsonObject kept = names.localNames();
    names::Names again;
    again.setLocalNames(kept, dialect);
    require(again.localNames() == kept, "names changed on the way");
}

Seeds seeds()
{
    return {
        R"({"#00010": "DOOR", "B000": "PARTS", "BP001": "", "M599": " X "})", R"json({"IN#(1)": 5, "Q1": "A"})json"};
}

} // namespace

extern const Target localNames;
const Target localNames {"localNames", take, seeds};

} // namespace fuzz
