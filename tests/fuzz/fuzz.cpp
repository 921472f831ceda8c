// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzztargets.h"

/// FUZZ_TARGET is the function of this program: see CMakeLists.txt.
extern "C" int LLVMFuzzerTestOneInput(const quint8 *data, std::size_t size)
{
    fuzz::FUZZ_TARGET(QByteArrayView {data, qsizetype(size)});
    return 0;
}
