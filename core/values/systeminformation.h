// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/fixedtext.h"

namespace values {

/// What the controller says of itself (reference §3.10).
struct SystemInformation {
    FixedText<24> software; ///< System software version, the same for every instance.
    FixedText<16> model; ///< Robot model, or application name; empty for a station.
    FixedText<8> parameters; ///< Parameter version; robots only.

    bool operator==(const SystemInformation &) const = default;
};

} // namespace values
