// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cellfiles/macros.h"

#include "cellfiles/sentences.h"

namespace cellfiles {

Parsed<QList<Macro>> macrosFrom(QByteArrayView file)
{
    Parsed<QList<Macro>> parsed;
    for (const Block &block : outlineOf(file, parsed.warnings).blocks) {
        if (block.level == 2 && block.word.startsWith("MACRO")) {
            const auto number = wordFrom(block.text);
            if (!number)
                parsed.warnings.add(block.line, Sentences::tr("The number of the macro cannot be read."));
            parsed.value << Macro {number.value_or(0), block.line, {}, {}};
        } else if (!parsed.value.isEmpty() && block.word == "JOB1") {
            parsed.value.back().job = block.text.trimmed().toByteArray();
        } else if (!parsed.value.isEmpty() && block.word == "JOB2") {
            parsed.value.back().otherJob = block.text.trimmed().toByteArray();
        }
    }
    return parsed;
}

} // namespace cellfiles
