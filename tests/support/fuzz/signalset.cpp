// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "trend/signal.h"

namespace fuzz {

namespace {

/// Signals as they travel in a drag and stand in the settings, a key a line: each that is read has that key.
void take(QByteArrayView data)
{
    const auto list = trend::fromMime(data.toByteArray());
    require(trend::fromMime(trend::toMime(list)) == list, "signals changed on the way");
    const QString word = QString::fromUtf8(data);
    if (const auto signal = trend::fromKey(word))
        require(trend::fromKey(trend::key(*signal)) == signal, "a key names another signal");
}

Seeds seeds() { return {"torque.1.0", "io.1.0\nio.2701.7\nbyte.5.0", "status.0.6\n\nnone.1.1", "torque.01.-1"}; }

} // namespace

extern const Target signalSet;
const Target signalSet {"signalSet", take, seeds, 100};

} // namespace fuzz
