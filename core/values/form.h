// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/error.h"
#include <QStringList>
#include <span>

namespace values {

/// One bit of a form word and what its two states mean (reference §5.2). Bit numbers are the order of the rows.
struct FormBit {
    const char *off; ///< For QCoreApplication::translate("values", …); as it stands it is the word in files and logs.
    const char *on;
};

/// The form word; the last two bits matter on 7-axis arms and on writing only.
[[nodiscard]] std::span<const FormBit> formBits();
/// The extended form word.
[[nodiscard]] std::span<const FormBit> extendedFormBits();

/// One untranslated word for each bit of the table.
[[nodiscard]] QStringList formWords(quint32 form, std::span<const FormBit> table);
/// The reverse; a word that is not given leaves its bit 0. BadInput names a word that the table does not hold.
[[nodiscard]] Result<quint32> formFromWords(const QStringList &words, std::span<const FormBit> table);

} // namespace values
