// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "cell/subject.h"
#include "cellfiles/conditions.h"
#include "cellfiles/ladder.h"
#include "cellfiles/macros.h"
#include "cellfiles/signalnames.h"
#include <QDateTime>
#include <map>

namespace cell {

/// One file of a controller, with the time at which it was fetched.
struct File {
    QByteArray name; ///< As on the controller: "CLAMP.JBI".
    QByteArray content;
    QDateTime at = {};
};

/// A file that could be understood in part.
struct Trouble {
    QByteArray file;
    QList<cellfiles::Warning> warnings;
};

/// The files of one controller, taken apart; made once, never changed, and free to be handed from a worker to the
/// window. Files that are missing leave their part empty: `has` tells "none" from "not known".
struct Cell {
    struct JobFile {
        QByteArray file;
        inform::Job job;
        QDateTime at;
    };

    std::map<QByteArray, JobFile> jobs; ///< By the name that the job itself has (///NAME).
    cellfiles::SignalNames signalNames; ///< Of general and external signals.
    cellfiles::NameList registerNames;
    cellfiles::VariableNames variableNames;
    cellfiles::Ladder ladder;
    QList<cellfiles::Macro> macros;
    QList<cellfiles::Tool> tools;
    QList<cellfiles::UserFrame> userFrames;
    QList<QByteArray> files; ///< All names, in the order given; has() looks here.
    QList<Trouble> troubles;
    QList<QByteArray> doubles; ///< Files that were left out because another one holds a job of the same name.

    [[nodiscard]] bool has(QByteArrayView file) const;
    /// What people call it: the name of a signal, register, variable, tool, frame or alarm, or the comment of a job;
    /// empty if it has none. Decoded.
    [[nodiscard]] QString nameOf(const Subject &subject) const;

    protocol::TextCodec codec {}; ///< Of the controller's texts.
};

/// Never fails: whatever the bytes are, what can be understood is there.
[[nodiscard]] Cell cellOf(const QList<File> &files, const protocol::TextCodec &codec);

} // namespace cell
