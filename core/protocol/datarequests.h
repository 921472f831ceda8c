// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/requestkinds.h"

namespace protocol {

/// The commands that carry a kind of item: one at a time, and several in a row (reference §4).
template <quint16 singleCommand, quint16 pluralCommand, bool scalar> struct ItemCommands {
    static constexpr quint16 single = singleCommand;
    static constexpr quint16 plural = pluralCommand;
    static constexpr bool isScalar = scalar; ///< Has a single element.
};

template <typename Item> struct CommandsOf;
template <> struct CommandsOf<values::IoGroup> : ItemCommands<0x78, 0x300, true> {
};
template <> struct CommandsOf<values::Register> : ItemCommands<0x79, 0x301, true> {
};
template <> struct CommandsOf<values::ByteVariable> : ItemCommands<0x7A, 0x302, true> {
};
template <> struct CommandsOf<values::IntegerVariable> : ItemCommands<0x7B, 0x303, true> {
};
template <> struct CommandsOf<values::DoubleVariable> : ItemCommands<0x7C, 0x304, true> {
};
template <> struct CommandsOf<values::RealVariable> : ItemCommands<0x7D, 0x305, true> {
};
template <> struct CommandsOf<values::StringVariable16> : ItemCommands<0x7E, 0x306, true> {
};
template <> struct CommandsOf<values::StringVariable32> : ItemCommands<0x8C, 0x30C, true> {
};
template <> struct CommandsOf<values::PositionVariable> : ItemCommands<0x7F, 0x307, false> {
};
template <> struct CommandsOf<values::BasePosition> : ItemCommands<0x80, 0x308, false> {
};
template <> struct CommandsOf<values::ExternalPosition> : ItemCommands<0x81, 0x309, false> {
};

/// ReadItem<values::Register> {5} reads M005. The instance of a variable comes from variableInstance().
template <typename Item, typename Commands = CommandsOf<Item>>
using ReadItem =
    std::conditional_t<Commands::isScalar, ReadElement<Commands::single, Item>, ReadAll<Commands::single, Item>>;

/// WriteItem<values::Register> {5, {123}} writes M005.
template <typename Item, typename Commands = CommandsOf<Item>>
using WriteItem =
    std::conditional_t<Commands::isScalar, WriteElement<Commands::single, Item>, WriteAll<Commands::single, Item>>;

/// ReadItems<values::Register>::create(0, 100) reads M000 to M099.
template <typename Item> using ReadItems = ReadPlural<CommandsOf<Item>::plural, Item>;
template <typename Item> using WriteItems = WritePlural<CommandsOf<Item>::plural, Item>;

/// One element of a position variable: ReadItemElement<values::PositionVariable> {1, 3} reads the tool of P001.
template <typename Item> using ReadItemElement = ReadElement<CommandsOf<Item>::single, Item>;
template <typename Item> using WriteItemElement = WriteElement<CommandsOf<Item>::single, Item>;

} // namespace protocol
