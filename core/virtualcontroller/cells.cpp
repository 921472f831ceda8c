// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/cells.h"

#include "protocol/payloads.h"
#include <algorithm>

using protocol::IoArea;
using values::PositionType;

namespace virtualcontroller {

namespace {

constexpr quint32 lastTool = 63;
constexpr quint32 lastUserFrame = 63;

quint16 writable(const Memory &, int) { return 0; }

// I/O groups

bool isIoGroup(const Memory &memory, int number) { return memory.dialect().ioArea(quint32(number)).has_value(); }

quint16 ioWriteRefusal(const Memory &memory, int number)
{
    return memory.dialect().ioArea(quint32(number)) == IoArea::NetworkInput ? 0 : NotAccessible;
}

Answer loadIo(const Memory &memory, int number, int)
{
    const auto found = memory.io.find(quint16(number));
    return protocol::encode(values::IoGroup {found == memory.io.end() ? quint8 {} : found->second});
}

/// Some clients send a whole word (reference §12, conflict 21).
quint16 storeIo(Memory &memory, int number, QByteArrayView bytes, int)
{
    const auto group = protocol::decode<values::IoGroup>(bytes.size() == 4 ? bytes.first(1) : bytes);
    if (!group)
        return SizeFault;
    memory.io[quint16(number)] = group->bits;
    return 0;
}

// Registers and variables of one element

template <auto list> bool isListed(const Memory &memory, int number)
{
    return number >= 0 && std::size_t(number) < (memory.*list).size();
}

quint16 registerWriteRefusal(const Memory &, int number)
{
    return protocol::writableRegisters.contains(quint32(number)) ? 0 : NotAccessible;
}

template <auto list> Answer loadItem(const Memory &memory, int number, int)
{
    return protocol::encode((memory.*list)[std::size_t(number)]);
}

template <auto list> quint16 storeItem(Memory &memory, int number, QByteArrayView bytes, int)
{
    auto &item = (memory.*list)[std::size_t(number)];
    const auto decoded = protocol::decode<std::remove_reference_t<decltype(item)>>(bytes);
    if (!decoded)
        return SizeFault;
    item = *decoded;
    return 0;
}

// Strings: stored with 32 bytes, of which 0x7E sees the first 16 (reference §4.3)

template <typename Variable> Answer loadString(const Memory &memory, int number, int)
{
    const auto &text = memory.s[std::size_t(number)].value;
    return protocol::encode(Variable {decltype(Variable::value) {text.raw()}});
}

/// A short text is padded (reference §12, conflict 22).
template <typename Variable> quint16 storeString(Memory &memory, int number, QByteArrayView bytes, int)
{
    if (bytes.isEmpty() || bytes.size() > decltype(Variable::value)::capacity)
        return SizeFault;
    memory.s[std::size_t(number)].value = values::FixedText<32> {bytes};
    return 0;
}

// Position variables: they may never have been taught

quint16 fault(const values::PositionVariable &variable)
{
    const auto &position = variable.position;
    if (position.type != PositionType::Pulse
        && (position.type < PositionType::Base || position.type > PositionType::Tool))
        return TypeFault;
    if (position.tool > lastTool)
        return ToolFault;
    const bool needsFrame = position.type == PositionType::User;
    return position.userFrame > lastUserFrame || (needsFrame && position.userFrame == 0) ? UserFrameFault : 0;
}

quint16 fault(const values::BasePosition &variable)
{
    return variable.type == PositionType::Pulse || variable.type == PositionType::Base ? 0 : TypeFault;
}

quint16 fault(const values::ExternalPosition &variable) { return variable.type == PositionType::Pulse ? 0 : TypeFault; }

template <auto list> Answer loadPosition(const Memory &memory, int number, int attribute)
{
    const auto &variable = (memory.*list)[std::size_t(number)];
    return variable ? Answer {protocol::encode(*variable, attribute)} : Answer {refused(Undefined)};
}

/// Reads elements into a variable that keeps the others: a single write leaves them alone (reference §4.4).
template <auto list> quint16 storePosition(Memory &memory, int number, QByteArrayView bytes, int attribute)
{
    using Variable = typename std::remove_reference_t<decltype((memory.*list)[0])>::value_type;
    auto &variable = (memory.*list)[std::size_t(number)];
    Variable changed = variable.value_or(Variable {});
    protocol::Reader reader {bytes, attribute};
    protocol::Layout<Variable>::describe(reader, changed);
    if (!reader.isComplete())
        return SizeFault;
    if (const quint16 code = fault(changed))
        return code;
    variable = changed;
    return 0;
}

template <auto list> CellKind items(quint16 single, quint16 plural, qsizetype size, bool isEven = false)
{
    return {single, plural, size, isEven, true, isListed<list>, writable, loadItem<list>, storeItem<list>};
}

template <typename Variable> CellKind strings(quint16 single, quint16 plural)
{
    return {single, plural, decltype(Variable::value)::capacity, false, true, isListed<&Memory::s>, writable,
        loadString<Variable>, storeString<Variable>};
}

template <auto list> CellKind positions(quint16 single, quint16 plural, qsizetype size)
{
    return {single, plural, size, false, true, isListed<list>, writable, loadPosition<list>, storePosition<list>};
}

template <typename Value> const qsizetype sizeOf = protocol::measure<Value>().bytes;

const std::array<CellKind, 11> &kinds()
{
    static const std::array<CellKind, 11> rows {{
        {0x78, 0x300, sizeOf<values::IoGroup>, true, false, isIoGroup, ioWriteRefusal, loadIo, storeIo},
        {0x79, 0x301, sizeOf<values::Register>, false, false, isListed<&Memory::registers>, registerWriteRefusal,
            loadItem<&Memory::registers>, storeItem<&Memory::registers>},
        items<&Memory::b>(0x7A, 0x302, sizeOf<values::ByteVariable>, true),
        items<&Memory::i>(0x7B, 0x303, sizeOf<values::IntegerVariable>),
        items<&Memory::d>(0x7C, 0x304, sizeOf<values::DoubleVariable>),
        items<&Memory::r>(0x7D, 0x305, sizeOf<values::RealVariable>),
        strings<values::StringVariable16>(0x7E, 0x306),
        strings<values::StringVariable32>(0x8C, 0x30C),
        positions<&Memory::p>(0x7F, 0x307, sizeOf<values::PositionVariable>),
        positions<&Memory::bp>(0x80, 0x308, sizeOf<values::BasePosition>),
        positions<&Memory::ex>(0x81, 0x309, sizeOf<values::ExternalPosition>),
    }};
    return rows;
}

} // namespace

const CellKind *findCellKind(quint16 command)
{
    const auto found = std::ranges::find_if(
        kinds(), [command](const CellKind &kind) { return kind.single == command || kind.plural == command; });
    return found == kinds().end() || command == 0 ? nullptr : &*found;
}

} // namespace virtualcontroller
