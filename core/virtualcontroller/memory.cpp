// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/memory.h"

#include "virtualcontroller/kinematics.h"
#include <algorithm>

using protocol::IoArea;
using values::ControlGroup;

namespace virtualcontroller {

namespace {

/// The group and bit of signal `number` of an area.
std::pair<quint16, int> signalPlace(const protocol::Dialect &dialect, IoArea area, int number)
{
    const int index = std::max(number, 1) - 1;
    return {quint16(dialect.ioRange(area).first + index / 8), index % 8};
}

/// The pulse instance of any instance of a group.
quint16 pulseInstance(ControlGroup group)
{
    return quint16(group.isCartesian() ? group.instance - 100 : group.instance);
}

} // namespace

const Group *Memory::findGroup(ControlGroup group) const
{
    const auto found = std::ranges::find_if(
        groups, [&](const Group &candidate) { return candidate.group.instance == pulseInstance(group); });
    return found == groups.end() ? nullptr : &*found;
}

Group *Memory::findGroup(ControlGroup group) { return const_cast<Group *>(std::as_const(*this).findGroup(group)); }

values::ExecutingJob Memory::executingJob(const Task &task) const
{
    if (task.stack.empty())
        return {{}, 0, 0, task.speedOverride};
    const Frame &frame = task.stack.back();
    return {values::JobName {frame.program->name}, quint32(frame.line), quint32(frame.program->stepAt(frame.line)),
        task.speedOverride};
}

std::shared_ptr<const Program> Memory::program(const QByteArray &name) const
{
    const auto file = files.find(name + ".JBI");
    if (file == files.end())
        return nullptr;
    auto parsed = parseProgram(file->second);
    return parsed ? std::make_shared<const Program>(std::move(*parsed)) : nullptr;
}

bool Memory::isJobInUse(const QByteArray &name) const
{
    const auto holds = [&](const Frame &frame) { return frame.program->name == name; };
    return isJobRunning
        && std::ranges::any_of(tasks, [&](const Task &task) { return std::ranges::any_of(task.stack, holds); });
}

values::FixedText<16> Memory::clockText() const
{
    const QDateTime clock = switchedOn.addMSecs(now.count());
    return values::FixedText<16> {clock.toString(QStringLiteral("yyyy/MM/dd HH:mm")).toLatin1()};
}

bool Memory::signal(IoArea area, int number) const
{
    const auto [group, bit] = signalPlace(dialect, area, number);
    const auto found = io.find(group);
    return found != io.end() && values::IoGroup {found->second}.isOn(bit);
}

void Memory::setSignal(IoArea area, int number, bool on)
{
    const auto [group, bit] = signalPlace(dialect, area, number);
    io[group] = values::IoGroup {io[group]}.with(bit, on).bits;
}

} // namespace virtualcontroller
