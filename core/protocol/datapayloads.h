// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/layout.h"
#include "protocol/monitoringpayloads.h"
#include "values/variable.h"

namespace protocol {

/// Reference §4.1.
template <> struct Layout<values::IoGroup> {
    static void describe(auto &visit, auto &group) { visit.element("io", group.bits); }
};

/// A payload of a single element with the name "value".
template <typename Value> struct ValueLayout {
    static void describe(auto &visit, auto &variable) { visit.element("value", variable.value); }
};

/// Reference §4.2 and §4.3.
template <> struct Layout<values::Register> : ValueLayout<values::Register> {
};
template <> struct Layout<values::ByteVariable> : ValueLayout<values::ByteVariable> {
};
template <> struct Layout<values::IntegerVariable> : ValueLayout<values::IntegerVariable> {
};
template <> struct Layout<values::DoubleVariable> : ValueLayout<values::DoubleVariable> {
};
template <> struct Layout<values::RealVariable> : ValueLayout<values::RealVariable> {
};
template <> struct Layout<values::StringVariable16> : ValueLayout<values::StringVariable16> {
};
template <> struct Layout<values::StringVariable32> : ValueLayout<values::StringVariable32> {
};

/// Reference §4.4.
template <> struct Layout<values::PositionVariable> {
    static void describe(auto &visit, auto &variable)
    {
        describePositionWords(visit, variable.position);
        visit.eightAxes("axes", variable.position.axes, variable.position.type);
        describeFormWords(visit, variable.position);
    }
};

/// BP and EX: the type and eight axes (reference §4.4).
template <typename Value> struct AxesLayout {
    static void describe(auto &visit, auto &variable)
    {
        visit.element("kind", variable.type);
        visit.eightAxes("axes", variable.axes, variable.type);
    }
};
template <> struct Layout<values::BasePosition> : AxesLayout<values::BasePosition> {
};
template <> struct Layout<values::ExternalPosition> : AxesLayout<values::ExternalPosition> {
};

} // namespace protocol
