// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "cellfiles/conditions.h"
#include <QMap>
#include <bit>

/// The files that hold a position of every control group: ABSO.DAT, HOME2.DAT and OPEORG.DAT (controller files
/// reference §11). What any of them says is bound to one arm.
namespace cellfiles {

/// One control group of a group line, in its order: robots, bases, stations.
struct Group {
    QString name; ///< "R1", "B1", "S1".
    int axes = 0; ///< Bit 0 is the first axis.

    [[nodiscard]] int axisCount() const { return std::popcount(unsigned(axes)); }
    bool operator==(const Group &) const = default;
};
/// The 36 numbers of a group line: mask, 32 axis masks, and how many robots, stations and bases there are.
[[nodiscard]] QList<Group> groupsFrom(QByteArrayView text, int line, Warnings &warnings);

struct HomeAxis {
    bool isValid = true;
    qint64 pulses = 0;

    bool operator==(const HomeAxis &) const = default;
};
struct HomeGroup {
    Group group;
    QList<HomeAxis> axes;

    bool operator==(const HomeGroup &) const = default;
};
struct HomePositions {
    QByteArray crc; ///< Of a controller with the functional safety unit.
    QList<HomeGroup> groups;
    QList<qint64> speeds; ///< OPEORG alone: hundredths of a percent, a group.
    QList<Cube> cubes; ///< OPEORG alone: number 64 is that of robot 1.
};
/// The home offsets of the encoders.
[[nodiscard]] Parsed<HomePositions> encoderOffsetsFrom(QByteArrayView file);
/// HOME2.DAT or OPEORG.DAT.
[[nodiscard]] Parsed<HomePositions> homePositionsFrom(QByteArrayView file);

/// PSEUDOIN.DAT: switches of the ladder. The byte k (from 0), bit b is #(87000 + (k + 1) * 10 + b); on a DX100 it
/// counts from 82000.
struct PseudoInputs {
    QList<qint64> bytes;
    QMap<int, QString> names; ///< By index from 0.

    [[nodiscard]] QList<int> on(int base) const;
};
constexpr int pseudoInputBase = 87'000;
constexpr int pseudoInputBaseDx100 = 82'000;
/// The offset of the signal that lets HSES command the controller: bit 5 of the first byte.
constexpr int commandRemoteSelect = 15;
[[nodiscard]] Parsed<PseudoInputs> pseudoInputsFrom(QByteArrayView file, const protocol::TextCodec &codec);

} // namespace cellfiles
