// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QByteArrayView>
#include <QStringView>
#include <array>
#include <optional>
#include <span>

namespace protocol {

enum class Model { DX100, DX200, FS100, YRC1000, YRC1000micro };
inline constexpr std::array allModels {Model::DX100, Model::DX200, Model::FS100, Model::YRC1000, Model::YRC1000micro};

/// Instances first..last, both included.
struct InstanceRange {
    quint16 first;
    quint16 last;

    [[nodiscard]] constexpr bool contains(quint32 instance) const { return instance >= first && instance <= last; }
    [[nodiscard]] constexpr int count() const { return last - first + 1; }
};

/// The I/O areas of the pendant (reference §4.1), in the order of the pendant's menus.
enum class IoArea {
    UserInput,
    UserOutput,
    ExternalInput,
    NetworkInput, ///< The only one that HSES may write.
    ExternalOutput,
    NetworkOutput,
    SystemInput,
    SystemOutput,
    PanelInput,
    AuxiliaryRelay,
    ControlStatus,
    PseudoInput,
};

struct IoRange {
    IoArea area;
    InstanceRange groups; ///< Groups of eight signals: 2701 is #27010 to #27017.
};

/// Which instance a variable has (parameter RS022, reference §10.1): its number, or its number plus one.
enum class Numbering : quint16 { FromZero = 0, FromOne = 1 };

/// The instance of variable `number`, for B I D R S P BP EX. Registers and I/O groups always have their number.
constexpr quint16 variableInstance(int number, Numbering numbering) { return quint16(number + int(numbering)); }

/// What differs between controller models, as data. Values that the reference does not know for a model are marked
/// there.
struct Dialect {
    Model model;
    const char *key; ///< As in settings and on the command line: "yrc1000".
    const char *name; ///< As on the pendant: "YRC1000".
    int robots; ///< Highest R number, likewise bases and stations (reference §2.1).
    int bases;
    int stations;
    int tasks; ///< Master task and sub tasks (reference §3.5).
    quint16 lastMasterJob; ///< Highest instance of 0x87 for master jobs (reference §6.1).
    int applications; ///< For 0x88 and 0x89.
    int stringSize; ///< Bytes of an S variable: 16 or 32 (reference §4.3).
    bool hasMoves; ///< 0x8A 0x8B.
    bool hasAlarmTexts; ///< 0x30A 0x30B.
    bool hasTemperatures; ///< 0x411 0x413.
    std::span<const IoRange> io;
    int variables = 100; ///< B000 to B099, likewise I D R S; more with the extended-variable option (reference §4.3).
    int positionVariables = 128; ///< P000 to P127, likewise BP EX (reference §4.4).
    Numbering numbering = Numbering::FromZero; ///< As set on the controller.

    /// The area that `group` lies in, nullopt outside all of them.
    [[nodiscard]] std::optional<IoArea> ioArea(quint32 group) const;
    [[nodiscard]] InstanceRange ioRange(IoArea area) const;
};

/// The model that a system software version tells ("YAS2.02.11A": a YRC1000); nullopt where the reference knows no
/// such version (§0, §2).
[[nodiscard]] std::optional<Model> modelOfSoftware(QByteArrayView version);

[[nodiscard]] const Dialect &dialect(Model model);
/// The dialect with this key or name, any case; nullptr if there is none.
[[nodiscard]] const Dialect *findDialect(QStringView keyOrName);

/// Registers M000 to M999; only the first 560 can be written (reference §4.2; §12, conflict 24).
constexpr InstanceRange registers {0, 999};
constexpr InstanceRange writableRegisters {0, 559};

} // namespace protocol
