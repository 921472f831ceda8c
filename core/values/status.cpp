// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "values/status.h"

#include <array>
#include <span>

namespace values {

namespace {

constexpr std::array data1Names {
    "step", "one_cycle", "continuous", "running", "speed_limited", "teach", "play", "remote"};
constexpr std::array data2Names {"", "hold_pendant", "hold_external", "hold_command", "alarm", "error", "servo_on", ""};

void appendNames(QStringList &names, quint32 bits, std::span<const char *const, 8> table)
{
    for (std::size_t bit = 0; bit < table.size(); ++bit) {
        if ((bits >> bit & 1) && *table[bit])
            names += QString::fromLatin1(table[bit]);
    }
}

} // namespace

QStringList Status::bitNames() const
{
    QStringList names;
    appendNames(names, data1.toInt(), data1Names);
    appendNames(names, data2.toInt(), data2Names);
    return names;
}

} // namespace values
