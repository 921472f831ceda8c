// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/layout.h"
#include "values/control.h"
#include "values/move.h"

namespace protocol {

/// Reference §6: 0x82, 0x83, 0x86.
template <> struct Layout<values::ControlWord> {
    static void describe(auto &visit, auto &word) { visit.element("value", word.value); }
};

/// Reference §6: 0x84.
template <> struct Layout<values::CycleSelection> {
    static void describe(auto &visit, auto &selection) { visit.element("value", selection.mode); }
};

/// Reference §6: 0x85. Some clients send the text without padding.
template <> struct Layout<values::PendantText> {
    static void describe(auto &visit, auto &message) { visit.paddedElement("text", message.text); }
};

/// Reference §6.1.
template <> struct Layout<values::JobSelection> {
    static void describe(auto &visit, auto &selection)
    {
        visit.element("job", selection.job);
        visit.element("line", selection.line);
    }
};

template <typename Target> int wordsOf() { return int(measure<Target>().bytes / 4); }

/// The four words that both kinds of move begin with.
void describeGroupsAndSpeed(auto &visit, auto &target)
{
    visit.element("robot", target.robot);
    visit.element("station", target.station);
    visit.element("speed_class", target.speed.kind);
    visit.element("speed_value", target.speed.value);
    visit.derived("speed", [&target] { return target.speed.toString(); });
}

/// Reference §6.2: 26 words.
template <> struct Layout<values::CartesianTarget> {
    static void describe(auto &visit, auto &target)
    {
        describeGroupsAndSpeed(visit, target);
        visit.element("frame", target.frame);
        visit.element("xyz", target.xyz);
        visit.element("rotation", target.rotation);
        visit.element("reserved", target.reserved);
        visit.element("form", target.form);
        visit.element("extended_form", target.extendedForm);
        visit.element("tool", target.tool);
        visit.element("user_frame", target.userFrame);
        visit.element("base_axes", target.base);
        visit.element("station_axes", target.stationAxes);
        visit.derived("words_in_payload", [] { return wordsOf<values::CartesianTarget>(); });
    }
};

/// Reference §6.3: 22 words.
template <> struct Layout<values::PulseTarget> {
    static void describe(auto &visit, auto &target)
    {
        describeGroupsAndSpeed(visit, target);
        visit.element("axes", target.axes);
        visit.element("tool", target.tool);
        visit.element("base_axes", target.base);
        visit.element("station_axes", target.stationAxes);
        visit.derived("words_in_payload", [] { return wordsOf<values::PulseTarget>(); });
    }
};

} // namespace protocol
