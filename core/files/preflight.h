// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/filename.h"
#include <QList>
#include <QString>

namespace files {

enum class Concern {
    // The controller refuses such a file, or must not get it now.
    Empty,
    NotLoadable, ///< Not a type that a controller takes.
    BadJobName,
    NameDiffers, ///< The name in the header is not that of the file: another job would be written.
    NotAJob, ///< No /JOB or //INST.
    NoNop,
    NoEnd,
    WrongPositionCount, ///< ///NPOS counts other positions than there are.
    Running,
    ControlCharacter,
    // It may well do, and a person should know.
    LineEndings, ///< Not CR LF throughout.
    NoFinalNewline,
    LongComment, ///< More than 32 bytes.
    OtherCharacters, ///< Bytes beyond ASCII outside of comments.
    ReplacesNames, ///< A names file: all names in the controller become those in it.
};

/// One thing that a look at a file before its upload has found.
struct Finding {
    Concern concern;
    int line = 0; ///< From 1, as an editor counts; 0: the file as a whole.
    QString detail = {}; ///< The name or number in question.

    [[nodiscard]] bool stops() const { return concern < Concern::LineEndings; }
    bool operator==(const Finding &) const = default;
};

/// Looks at `content` before it is sent as `name`. `jobsInUse` are the jobs being executed or called at present,
/// without extension.
[[nodiscard]] QList<Finding> preflight(
    const values::FileName &name, const QByteArray &content, const QByteArrayList &jobsInUse = {});
[[nodiscard]] bool mayBeSent(const QList<Finding> &findings);
/// In a sentence.
[[nodiscard]] QString explain(const Finding &finding);

/// JBI, JBR, CND, DAT, PRM or LST (reference §7.7).
[[nodiscard]] bool isLoadable(const values::FileName &name);
[[nodiscard]] bool isJobFile(const values::FileName &name);

} // namespace files
