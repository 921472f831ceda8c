// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QByteArrayList>
#include <QList>

namespace robot {

/// What can be jumped to in a job: where a label stands, and where another job is called.
struct JobMark {
    enum class Kind { Label, Call };

    Kind kind = Kind::Label;
    int line = 0;
    QByteArray text; ///< "*NEXT", "JOB:CLAMP"

    bool operator==(const JobMark &) const = default;
};

/// The part of a JBI file that is shown as a job (reference §7.8): its instructions, numbered as the controller counts
/// them. Bytes stay as they came.
struct JobText {
    QByteArray name; ///< Of //NAME, which counts for the controller.
    QByteArray comment;
    QByteArray date; ///< Of the last change, the controller's clock.
    QByteArrayList lines; ///< Line 0 is NOP, the last one END. Empty if there is no NOP.
    QList<JobMark> marks; ///< In the order of their lines.

    bool operator==(const JobText &) const = default;
};

/// Reads what is there and passes over what is not understood; never fails. Line ends may be CR LF or LF.
[[nodiscard]] JobText parseJobText(const QByteArray &jbi);

} // namespace robot
