// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/layout.h"
#include "values/job.h"
#include "values/position.h"
#include "values/status.h"
#include "values/systeminformation.h"

namespace protocol {

/// Reference §3.4.
template <> struct Layout<values::Status> {
    static void describe(auto &visit, auto &status)
    {
        visit.element("data1", status.data1);
        visit.element("data2", status.data2);
    }
};

/// Reference §3.5.
template <> struct Layout<values::ExecutingJob> {
    static void describe(auto &visit, auto &job)
    {
        visit.element("job", job.name);
        visit.element("line", job.line);
        visit.element("step", job.step);
        visit.element("override", job.speedOverride);
    }
};

/// Reference §3.6: always eight names.
template <> struct Layout<values::AxisNames> {
    static void describe(auto &visit, auto &axes)
    {
        for (auto &name : axes.names)
            visit.element("names", name);
    }
};

/// Reference §3.7: five words and as many axes as the arm has.
template <> struct Layout<values::Position> {
    static void describe(auto &visit, auto &position)
    {
        visit.element("kind", position.type);
        visit.element("form", position.form);
        visit.element("tool", position.tool);
        visit.element("user_frame", position.userFrame);
        visit.element("extended_form", position.extendedForm);
        visit.axes("axes", position.axes);
    }
};

/// Reference §3.10.
template <> struct Layout<values::SystemInformation> {
    static void describe(auto &visit, auto &information)
    {
        visit.element("version", information.software);
        visit.element("model", information.model);
        visit.element("parameter", information.parameters);
    }
};

} // namespace protocol
