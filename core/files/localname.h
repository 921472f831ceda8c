// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/filename.h"
#include <QSet>
#include <QString>

namespace files {

/// What a file of a controller is called on this computer. Letters, digits and the like stay; every other byte, and the
/// first byte of a name that some system keeps for a device (CON, LPT1), is written as %8A. So a name needs no
/// encoding, leads nowhere, and is the same on every file system.
[[nodiscard]] QString toLocalName(QByteArrayView name);
/// The bytes that `local` stands for; nullopt if no file of a controller can be called so on this computer.
[[nodiscard]] std::optional<values::FileName> fromLocalName(const QString &local);

/// The name of a folder for a controller that a person called `name`: letters of all scripts and blanks stay.
[[nodiscard]] QString toFolderName(const QString &name);

/// Local names for the files of one folder, different ones even where "a.jbi" and "A.JBI" would be the same file.
class LocalNames
{
public:
    [[nodiscard]] QString take(const values::FileName &name);

private:
    QSet<QString> m_taken; ///< In upper case.
};

} // namespace files
