// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "virtualcontroller/memory.h"
#include "virtualcontroller/statereader.h"

namespace virtualcontroller {

/// A list of up to eight words.
[[nodiscard]] values::AxisWords axisWords(const StateValue &value);
/// The variables of a start state, by name: "B000", "P127".
void takeVariables(const StateValue &value, Memory &memory);

} // namespace virtualcontroller
