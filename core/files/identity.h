// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/bagtext.h"
#include "files/fileset.h"

namespace files {

/// What tells one robot from another (controller files reference §13, step 0). Empty: not known.
struct Identity {
    QString name; ///< Of the profile.
    QString host;
    QString model; ///< As the controller gives it.
    QString software;
    QString mechanisms; ///< "R1 0011_1111, B1 0000_0001": control groups and their axes, by SYSTEM.SYS.
    QString counts; ///< "100,100,…": how many variables of each kind, by VAR.DAT.
};

/// By what the controller said of itself, and by its SYSTEM.SYS and VAR.DAT where they are among the files.
[[nodiscard]] Identity identityOf(const BagInfo &info, const FileSet &files);

/// One line of the table that a person sees before anything is sent.
struct IdentityRow {
    QString title; ///< Translated.
    QString backup;
    QString controller;
    bool isSame = true; ///< Also where one of them is not known.
    bool isDecisive = false; ///< Another one is another robot.
};
[[nodiscard]] QList<IdentityRow> compareIdentities(const Identity &backup, const Identity &controller);
/// A decisive row differs.
[[nodiscard]] bool isAnotherRobot(const QList<IdentityRow> &rows);

} // namespace files
