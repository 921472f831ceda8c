// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/cells.h"

#include "protocol/payloads.h"
#include <algorithm>

using values::PositionType;

namespace virtualcontroller {

namespace {

quint16 takesAnything(QByteArrayView, int) { return 0; }

Answer loadIo(const Memory &memory, int number, int)
{
    const auto found = memory.io.find(quint16(number));
    return protocol::encode(values::IoGroup {found == memory.io.end() ? quint8 {} : found->second});
}

void storeIo(Memory &memory, int number, QByteArrayView bytes, int)
{
    memory.io[quint16(number)] = protocol::decode<values::IoGroup>(bytes)->bits;
}

template <auto list> Answer loadItem(const Memory &memory, int number, int)
{
    return protocol::encode((memory.*list)[std::size_t(number)]);
}

template <auto list> void storeItem(Memory &memory, int number, QByteArrayView bytes, int)
{
    auto &item = (memory.*list)[std::size_t(number)];
    item = *protocol::decode<std::remove_reference_t<decltype(item)>>(bytes);
}

/// Strings are kept with 32 bytes, of which 0x7E sees the first 16 (reference §4.3).
template <typename Variable> Answer loadString(const Memory &memory, int number, int)
{
    return protocol::encode(Variable {decltype(Variable::value) {memory.s[std::size_t(number)].value.raw()}});
}

void storeString(Memory &memory, int number, QByteArrayView bytes, int)
{
    memory.s[std::size_t(number)].value = values::FixedText<32> {bytes};
}

/// Position variables may never have been taught.
template <auto list> Answer loadPosition(const Memory &memory, int number, int element)
{
    const auto &variable = (memory.*list)[std::size_t(number)];
    return variable ? Answer {protocol::encode(*variable, element)} : Answer {refused(Undefined)};
}

/// A single element leaves the others alone (reference §4.4).
template <auto list> void storePosition(Memory &memory, int number, QByteArrayView bytes, int element)
{
    auto &variable = (memory.*list)[std::size_t(number)];
    auto changed = variable.value_or(typename std::remove_reference_t<decltype(variable)>::value_type {});
    protocol::Reader reader {bytes, element};
    protocol::Layout<decltype(changed)>::describe(reader, changed);
    variable = changed;
}

quint16 fault(const values::PositionVariable &variable, bool isWhole)
{
    const auto &position = variable.position;
    const bool isFrame = position.type >= PositionType::Base && position.type <= PositionType::Tool;
    if (position.type != PositionType::Pulse && !isFrame)
        return TypeFault;
    if (position.tool > lastTool)
        return ToolFault;
    const bool lacksFrame = isWhole && position.type == PositionType::User && position.userFrame == 0;
    return lacksFrame || position.userFrame > lastUserFrame ? UserFrameFault : 0;
}

quint16 fault(const values::BasePosition &variable, bool)
{
    return variable.type == PositionType::Pulse || variable.type == PositionType::Base ? 0 : TypeFault;
}

quint16 fault(const values::ExternalPosition &variable, bool)
{
    return variable.type == PositionType::Pulse ? 0 : TypeFault;
}

template <typename Variable> quint16 checkPosition(QByteArrayView bytes, int element)
{
    return fault(*protocol::decode<Variable>(bytes, element), element == 0);
}

constexpr std::array kinds {
    CellKind {0x78, 0x300, false, loadIo, storeIo, takesAnything},
    CellKind {0x79, 0x301, false, loadItem<&Memory::registers>, storeItem<&Memory::registers>, takesAnything},
    CellKind {0x7A, 0x302, true, loadItem<&Memory::b>, storeItem<&Memory::b>, takesAnything},
    CellKind {0x7B, 0x303, true, loadItem<&Memory::i>, storeItem<&Memory::i>, takesAnything},
    CellKind {0x7C, 0x304, true, loadItem<&Memory::d>, storeItem<&Memory::d>, takesAnything},
    CellKind {0x7D, 0x305, true, loadItem<&Memory::r>, storeItem<&Memory::r>, takesAnything},
    CellKind {0x7E, 0x306, true, loadString<values::StringVariable16>, storeString, takesAnything},
    CellKind {0x8C, 0x30C, true, loadString<values::StringVariable32>, storeString, takesAnything},
    CellKind {0x7F, 0x307, true, loadPosition<&Memory::p>, storePosition<&Memory::p>,
        checkPosition<values::PositionVariable>},
    CellKind {
        0x80, 0x308, true, loadPosition<&Memory::bp>, storePosition<&Memory::bp>, checkPosition<values::BasePosition>},
    CellKind {0x81, 0x309, true, loadPosition<&Memory::ex>, storePosition<&Memory::ex>,
        checkPosition<values::ExternalPosition>},
};

} // namespace

std::span<const CellKind> cellKinds() { return kinds; }

const CellKind &cellKind(quint16 command)
{
    return *std::ranges::find_if(
        kinds, [command](const CellKind &kind) { return kind.single == command || kind.plural == command; });
}

} // namespace virtualcontroller
