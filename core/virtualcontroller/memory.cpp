// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/memory.h"

#include "virtualcontroller/kinematics.h"
#include "virtualcontroller/machine.h"
#include <algorithm>

using protocol::IoArea;
using values::ControlGroup;
using values::Status;

namespace virtualcontroller
{

namespace
{

/// 0-based group and bit of signal `number` of an area.
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

Memory::Memory(Settings newSettings) : settings {newSettings}
{
    status.data1 = Status::Data1 {Status::OneCycle} | Status::Play | Status::Remote;
    tasks.resize(1);
    const values::AxisWords home {0, 0, 0, 0, 0, 0};
    groups.push_back({ControlGroup::robotPulse(1), kinematics::toCartesian(home), {}});
    software = values::FixedText<24> {"PENDESK VIRTUAL 0.1"};
    systemInformation[11] = {software, values::FixedText<16> {"VIRTUAL-A00"}, values::FixedText<8> {"1.00"}};
    systemInformation[101] = {software, values::FixedText<16> {"GENERAL"}, {}};
}

Memory Memory::demo(Settings settings)
{
    Memory memory {settings};
    memory.status.data2.setFlag(Status::ServoOn);
    setCycle(memory, Status::Continuous);
    memory.files["WELD_A12.JBI"] = "/JOB\r\n//NAME WELD_A12\r\n//POS\r\n///NPOS 3,0,0,0,0,0\r\n///TOOL 0\r\n"
                                   "///POSTYPE PULSE\r\n///PULSE\r\nC00000=0,0,0,0,0,0\r\n"
                                   "C00001=40000,-12000,8000,0,-9000,3000\r\nC00002=42000,20000,-8000,2000,-9000,0\r\n"
                                   "//INST\r\n///DATE 2026/01/12 08:30\r\n///COMM DEMO\r\n///ATTR SC,RW\r\n///GROUP1 "
                                   "RB1\r\nNOP\r\nMOVJ C00000 VJ=25.00\r\nMOVJ C00001 VJ=25.00\r\nDOUT OT#(1) "
                                   "ON\r\nMOVL C00002 V=50.0\r\nDOUT OT#(1) OFF\r\nTIMER T=1.00\r\nEND\r\n";
    selectJob(memory, 0, "WELD_A12", 0);
    startJob(memory);
    return memory;
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

bool Memory::signal(IoArea area, int number) const
{
    const auto [group, bit] = signalPlace(dialect(), area, number);
    const auto found = io.find(group);
    return found != io.end() && (found->second >> bit & 1);
}

void Memory::setSignal(IoArea area, int number, bool on)
{
    const auto [group, bit] = signalPlace(dialect(), area, number);
    quint8 &signals_ = io[group];
    signals_ = quint8(on ? signals_ | 1 << bit : signals_ & ~(1 << bit));
}

} // namespace virtualcontroller
