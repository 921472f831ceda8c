// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/execution.h"

#include "virtualcontroller/alarms.h"
#include "virtualcontroller/machine.h"
#include "virtualcontroller/speed.h"

using protocol::IoArea;
using values::Speed;
using values::SpeedClass;
using values::Status;

namespace virtualcontroller {

namespace {

constexpr Time lookAgain = 20ms; ///< How often WAIT looks at its signal.
constexpr std::size_t deepestCall = 8;

/// A number of units that is neither below 0 nor beyond all measure.
qint64 bounded(double number) { return number > 0 ? qint64(std::min(number, 1e9)) : 0; }

Time seconds(const QByteArray &text) { return Time {bounded(text.toDouble() * 1000)}; }

/// The number in "IN#(12)" and the like; 0 where there is none.
int signalNumber(const QByteArray &operand)
{
    const auto open = operand.indexOf('(');
    return operand.mid(open + 1, operand.size() - open - 2).toInt();
}

std::optional<IoArea> signalArea(const QByteArray &operand)
{
    if (operand.startsWith("IN#("))
        return IoArea::UserInput;
    if (operand.startsWith("OT#("))
        return IoArea::UserOutput;
    return std::nullopt;
}

/// Calls `function` with the cell of the B, I or D variable that "B012" names; false for anything else.
template <typename Function> bool withVariable(Memory &memory, const QByteArray &operand, Function function)
{
    bool ok = false;
    const uint number = operand.isEmpty() ? 0 : operand.sliced(1).toUInt(&ok);
    if (!ok || number >= memory.b.size())
        return false;
    switch (operand[0]) {
    case 'B': function(memory.b[number].value); return true;
    case 'I': function(memory.i[number].value); return true;
    case 'D': function(memory.d[number].value); return true;
    default: return false;
    }
}

/// The value of "B012", "IN#(3)", "ON", "OFF" or a number.
int valueOf(Memory &memory, const QByteArray &operand)
{
    if (const auto area = signalArea(operand))
        return memory.signal(*area, signalNumber(operand));
    int value = operand == "ON" ? 1 : operand.toInt();
    withVariable(memory, operand, [&value](const auto &cell) { value = int(cell); });
    return value;
}

/// A comparison such as "IN#(1)=ON" or "B000>=3".
bool isTrue(Memory &memory, const QByteArray &condition)
{
    const auto at = condition.indexOf('=') >= 0 ? condition.indexOf('=') : condition.indexOf('>');
    const auto split = at >= 0 ? at : condition.indexOf('<');
    if (split < 1)
        return false;
    const char before = condition[split - 1];
    const bool hasTwo = before == '<' || before == '>';
    const QByteArray sign = condition.mid(hasTwo ? split - 1 : split, hasTwo ? 2 : 1);
    const int left = valueOf(memory, condition.first(hasTwo ? split - 1 : split));
    const int right = valueOf(memory, condition.sliced(split + 1));
    return (left == right && sign != "<>" && sign.contains('=')) || (left < right && sign.contains('<'))
        || (left > right && sign.contains('>'));
}

/// True unless the instruction ends with "IF ..." and that is not so.
bool applies(Memory &memory, const Instruction &instruction)
{
    const auto at = instruction.words.indexOf("IF");
    return at < 0 || isTrue(memory, instruction.operand(int(at) + 1));
}

Speed speedOf(const Instruction &instruction)
{
    const auto wire = [&](const char *key, double units) {
        return quint32(bounded(instruction.valueOf(key).toDouble() * units));
    };
    if (const quint32 percent = wire("VJ=", 100))
        return {SpeedClass::Percent, percent};
    if (const quint32 rotation = wire("VR=", 10))
        return {SpeedClass::Rotation, rotation};
    const quint32 linear = wire("V=", 10);
    return {SpeedClass::ToolPoint, linear ? linear : 1000};
}

/// The position that a move goes to: one of the job, or a P variable.
std::optional<values::Position> target(const Memory &memory, const Program &program, const QByteArray &name)
{
    const auto found = program.positions.find(name);
    if (found != program.positions.end())
        return found->second;
    bool ok = false;
    const uint number = name.startsWith('P') ? name.sliced(1).toUInt(&ok) : 0;
    if (!ok || number >= memory.p.size() || !memory.p[number])
        return std::nullopt;
    return memory.p[number]->position;
}

/// Begins a move of the first robot; how long it takes. Without a position, or with one out of reach, there is an
/// alarm.
Time beginMove(Memory &memory, const Task &task, const Instruction &instruction)
{
    const auto position = target(memory, *task.stack.back().program, instruction.operand(1));
    if (!position) {
        raiseAlarm(memory, 4498, "UNDEFINED POSITION");
        return 0ms;
    }
    Group &robot = memory.groups.front();
    const auto unit = position->type == values::PositionType::Pulse ? GroupWords::Pulses : GroupWords::Cartesian;
    const double share = std::max(task.speedOverride, 1U) / 10000.0;
    const bool moves = moveGroup(memory, robot.group, position->axes, unit, speedOf(instruction), share);
    return moves ? robot.motion->end - memory.now : 0ms;
}

Time durationOf(Memory &memory, const Task &task, const Instruction &instruction)
{
    const Time least = std::max(memory.settings.lineTime, 1ms);
    if (instruction.isMove())
        return std::max(beginMove(memory, task, instruction), least);
    if (instruction.word() == "TIMER")
        return std::max(seconds(instruction.valueOf("T=")), least);
    return least;
}

void beginLine(Memory &memory, Task &task)
{
    const Frame &frame = task.stack.back();
    const Time takes = durationOf(memory, task, frame.program->lines[std::size_t(frame.line)]);
    task.isExecuting = memory.isJobRunning; // an alarm may have ended it
    task.begun = memory.now;
    task.due = memory.now + takes;
}

/// True while WAIT has neither its signal nor its time.
bool isWaiting(Memory &memory, const Task &task, const Instruction &instruction)
{
    if (instruction.word() != "WAIT" || isTrue(memory, instruction.operand(1)))
        return false;
    const QByteArray limit = instruction.valueOf("T=");
    return limit.isEmpty() || memory.now < task.begun + seconds(limit);
}

void setVariable(Memory &memory, const Instruction &instruction)
{
    static const QByteArrayList words {"SET", "DIN", "INC", "DEC", "ADD", "SUB", "MUL", "CLEAR"};
    const auto word = words.indexOf(instruction.word());
    const qint64 value = valueOf(memory, instruction.operand(2));
    withVariable(memory, word < 0 ? QByteArray {} : instruction.operand(1), [&](auto &cell) {
        const qint64 old = cell;
        const std::array<qint64, 8> results {value, value, old + 1, old - 1, old + value, old - value, old * value, 0};
        cell = std::remove_reference_t<decltype(cell)>(results[std::size_t(word)]);
    });
}

void setOutput(Memory &memory, const Instruction &instruction)
{
    if (instruction.word() == "DOUT" && signalArea(instruction.operand(1)) == IoArea::UserOutput)
        memory.setSignal(IoArea::UserOutput, signalNumber(instruction.operand(1)), instruction.operand(2) == "ON");
}

/// The job in "JOB:NAME".
std::shared_ptr<const Program> jobOperand(const Memory &memory, const Instruction &instruction)
{
    const QByteArray operand = instruction.operand(1);
    return operand.startsWith("JOB:") ? memory.program(operand.sliced(4)) : nullptr;
}

/// END or RET: back to the caller, or the end of the cycle.
void leave(Memory &memory, Task &task)
{
    if (task.stack.size() > 1) {
        task.stack.pop_back();
        ++task.stack.back().line;
        return;
    }
    task.stack.back().line = 0;
    if (!(memory.status.data1 & Status::Continuous))
        stopRunning(memory);
}

/// Why a job cannot go on. The numbers are the virtual controller's own.
void getStuck(Memory &memory, QByteArrayView why) { raiseAlarm(memory, 4499, why); }

void call(Memory &memory, Task &task, const Instruction &instruction)
{
    const auto job = jobOperand(memory, instruction);
    if (!job)
        return getStuck(memory, "JOB NOT FOUND");
    if (task.stack.size() >= deepestCall)
        return getStuck(memory, "CALLS TOO DEEP");
    task.stack.push_back({job, 0});
}

void jump(Memory &memory, Task &task, const Instruction &instruction)
{
    Frame &frame = task.stack.back();
    const auto label = frame.program->labels.find(instruction.operand(1));
    if (const auto job = jobOperand(memory, instruction))
        frame = {job, 0};
    else if (label != frame.program->labels.end())
        frame.line = label->second;
    else
        getStuck(memory, "NO PLACE TO JUMP TO");
}

/// Goes where the instruction at the top of the stack leads.
void goOn(Memory &memory, Task &task, const Instruction &instruction)
{
    const QByteArray word = instruction.word();
    const bool goes = applies(memory, instruction);
    if (word == "END" || (word == "RET" && goes))
        leave(memory, task);
    else if (word == "CALL" && goes)
        call(memory, task, instruction);
    else if (word == "JUMP" && goes)
        jump(memory, task, instruction);
    else
        ++task.stack.back().line;
}

void finishLine(Memory &memory, Task &task)
{
    const Frame frame = task.stack.back();
    const Instruction &instruction = frame.program->lines[std::size_t(frame.line)];
    if (isWaiting(memory, task, instruction)) {
        task.due = memory.now + lookAgain;
        return;
    }
    setVariable(memory, instruction);
    setOutput(memory, instruction);
    task.isExecuting = false;
    goOn(memory, task, instruction);
    if ((memory.status.data1 & Status::Step) || (instruction.word() == "PAUSE" && applies(memory, instruction)))
        stopRunning(memory);
}

} // namespace

Time nextLine(const Memory &memory)
{
    return memory.isJobRunning && !memory.tasks.front().stack.empty() ? memory.tasks.front().due : Time::max();
}

void executeDueLines(Memory &memory)
{
    if (nextLine(memory) > memory.now)
        return;
    Task &task = memory.tasks.front();
    if (task.isExecuting)
        finishLine(memory, task);
    if (memory.isJobRunning && !task.isExecuting)
        beginLine(memory, task);
}

} // namespace virtualcontroller
