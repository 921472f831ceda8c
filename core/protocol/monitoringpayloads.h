// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/layout.h"
#include "values/alarm.h"
#include "values/form.h"
#include "values/job.h"
#include "values/managementtime.h"
#include "values/position.h"
#include "values/status.h"
#include "values/systeminformation.h"
#include "values/temperature.h"

namespace protocol {

/// The elements that every form of an alarm begins with (reference §3.1).
void describeAlarm(auto &visit, auto &alarm)
{
    visit.element("alarm_code", alarm.code);
    visit.element("alarm_data", alarm.data.value);
    visit.element("alarm_type", alarm.data.type);
    visit.element("time", alarm.time);
    visit.element("alarm_name", alarm.name);
    visit.derived("sub_code", [&alarm] { return alarm.data.toString(); });
}

/// Reference §3.1, §3.2: any length from 60 bytes on (§0.1 i).
template <> struct Layout<values::Alarm> {
    static void describe(auto &visit, auto &alarm)
    {
        describeAlarm(visit, alarm);
        visit.rest();
    }
};

/// Reference §3.1: any length from 60 bytes on (§12, conflict 34).
template <> struct Layout<values::AlarmWithTexts> {
    static void describe(auto &visit, auto &detailed)
    {
        describeAlarm(visit, detailed.alarm);
        visit.optional();
        visit.element("extra_text", detailed.extra);
        visit.element("sub_text", detailed.subText);
        visit.element("reversed", detailed.reversed);
        visit.rest();
    }
};

/// Reference §3.4.
template <> struct Layout<values::Status> {
    static void describe(auto &visit, auto &status)
    {
        visit.element("data1", status.data1);
        visit.element("data2", status.data2);
        visit.derived("bits", [&status] { return status.bitNames(); });
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
    static void describe(auto &visit, auto &axes) { visit.each("names", axes.names); }
};

/// The five words before the axes of a robot position (reference §3.7, §4.4).
void describePositionWords(auto &visit, auto &position)
{
    visit.element("kind", position.type);
    visit.element("form", position.form);
    visit.element("tool", position.tool);
    visit.element("user_frame", position.userFrame);
    visit.element("extended_form", position.extendedForm);
}

/// The form bits in words; a pulse position has none.
void describeFormWords(auto &visit, auto &position)
{
    visit.derived("form_words", [&position] {
        return position.type == values::PositionType::Pulse ? QStringList {}
                                                            : values::formWords(position.form, values::formBits())
                + values::formWords(position.extendedForm, values::extendedFormBits());
    });
}

/// Reference §3.7: five words and as many axes as the arm has.
template <> struct Layout<values::Position> {
    static void describe(auto &visit, auto &position)
    {
        describePositionWords(visit, position);
        visit.axes("axes", position.axes, position.type);
        describeFormWords(visit, position);
    }
};

/// Reference §3.8: as many axes as the arm has.
template <> struct Layout<values::FollowingError> {
    static void describe(auto &visit, auto &error) { visit.axes("axes", error.axes, values::PositionType::Pulse); }
};

/// Reference §3.8.
template <> struct Layout<values::Torque> {
    static void describe(auto &visit, auto &torque) { visit.axes("axes", torque.axes, values::PositionType::Pulse); }
};

/// Reference §3.9.
template <> struct Layout<values::ManagementTime> {
    static void describe(auto &visit, auto &time)
    {
        visit.element("start", time.start);
        visit.element("elapsed", time.elapsed);
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

/// Reference §3.11: all words are one element.
template <> struct Layout<values::EncoderTemperatures> {
    static void describe(auto &visit, auto &temperatures) { visit.element("celsius", temperatures.celsius); }
};

template <> struct Layout<values::ConverterTemperature> {
    static void describe(auto &visit, auto &temperature) { visit.element("celsius", temperature.words); }
};

} // namespace protocol
