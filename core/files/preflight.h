// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "inform/check.h"
#include "protocol/text.h"
#include "values/filename.h"
#include <QList>

namespace files {

/// Looks at `content` before it is sent as `name`: jobs by inform::check(). `jobsInUse` are the jobs being executed or
/// called at present, without extension.
[[nodiscard]] QList<inform::Finding> preflight(
    const values::FileName &name, const QByteArray &content, const QByteArrayList &jobsInUse = {});
[[nodiscard]] bool mayBeSent(const QList<inform::Finding> &findings);
/// What it is and what comes of it.
[[nodiscard]] QString explain(const inform::Finding &finding, const protocol::TextCodec &codec);

/// JBI, JBR, CND, DAT, PRM or LST (reference §7.7), in capitals or not.
[[nodiscard]] bool isLoadable(const values::FileName &name);
/// JBI or JBR.
[[nodiscard]] bool isJobFile(const values::FileName &name);

} // namespace files
