// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/memory.h"

#include "virtualcontroller/kinematics.h"
#include <algorithm>

using protocol::IoArea;
using values::ControlGroup;

namespace virtualcontroller {

namespace {

struct SignalPlace {
    quint16 group;
    int bit;
};

/// Where signal `number` of an area is; nullopt if the area does not reach that far.
std::optional<SignalPlace> signalPlace(const protocol::Dialect &dialect, IoArea area, int number)
{
    const auto groups = dialect.ioRange(area);
    if (number < 1 || number > groups.count() * 8)
        return std::nullopt;
    return SignalPlace {quint16(groups.first + (number - 1) / 8), (number - 1) % 8};
}

/// The pulse instance of any instance of a group.
quint16 pulseInstance(ControlGroup group)
{
    return quint16(group.isCartesian() ? group.instance - 100 : group.instance);
}

} // namespace

void Memory::resizeVariables(int variables, int positionVariables)
{
    dialect.variables = variables;
    dialect.positionVariables = positionVariables;
    const auto resize = [](int count, auto &...lists) { (lists.resize(std::size_t(count)), ...); };
    resize(variables, b, i, d, r, s);
    resize(positionVariables, p, bp, ex);
}

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
    const auto place = signalPlace(dialect, area, number);
    const auto found = place ? io.find(place->group) : io.end();
    return found != io.end() && values::IoGroup {found->second}.isOn(place->bit);
}

void Memory::setSignal(IoArea area, int number, bool on)
{
    if (const auto place = signalPlace(dialect, area, number))
        io[place->group] = values::IoGroup {io[place->group]}.with(place->bit, on).bits;
}

} // namespace virtualcontroller
