// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "cellfiles/outline.h"
#include <array>

/// Tools, user frames and interference areas (controller files reference §5). Lengths are in micrometres, angles in
/// 0.0001 degrees, weights in grams, as in the file without its points.
namespace cellfiles {

/// X Y Z in micrometres, Rx Ry Rz in 0.0001 degrees.
using Frame = std::array<qint64, 6>;
using Vector3 = std::array<qint64, 3>;

struct Tool {
    int number = 0;
    int line = 0;
    QString name;
    Frame point {};
    Vector3 centreOfGravity {};
    qint64 weight = 0; ///< Grams.
    Vector3 inertia {}; ///< 0.001 kg m².
    int entryKind = 0; ///< 0 or 1 not entered, 2 by hand, 3 seen with a measured load.
    QByteArray crc; ///< Of a controller with the functional safety unit; empty elsewhere.
    bool isWhole = true; ///< False if a line of it could not be read; what could is here.

    bool operator==(const Tool &) const = default;
};
/// TOOL.CND
[[nodiscard]] Parsed<QList<Tool>> toolsFrom(QByteArrayView file, const protocol::TextCodec &codec);

struct UserFrame {
    int number = 0; ///< 1 to 63.
    int line = 0;
    QString name;
    int tool = 0; ///< With which it was taught.
    std::array<QList<qint64>, 3> taught {}; ///< Pulses at ORG, XX and XY.
    std::optional<Frame> frame; ///< BUSER, in base coordinates; nullopt if the file does not have it.

    bool operator==(const UserFrame &) const = default;
};
/// UFRAME.CND: the frames that are defined.
[[nodiscard]] Parsed<QList<UserFrame>> userFramesFrom(QByteArrayView file, const protocol::TextCodec &codec);

enum class CubeCoordinates { Base, Robot, User, Other };

struct Cube {
    int number = 0; ///< 1 to 64.
    int line = 0;
    QString name;
    int method = 0; ///< 0: not set.
    int group = 0;
    int coordinatesField = 0; ///< As in the file; 129 and 193 are seen on unused rows.
    std::array<qint64, 8> upper {}; ///< Micrometres where the coordinates are base, robot or user.
    std::array<qint64, 8> lower {};
    int userFrame = 0;

    [[nodiscard]] bool isSet() const { return method != 0; }
    [[nodiscard]] CubeCoordinates coordinates() const;
    bool operator==(const Cube &) const = default;
};
/// CUBEINTF.CND, and the last part of OPEORG.DAT.
[[nodiscard]] Parsed<QList<Cube>> cubesFrom(QByteArrayView file, const protocol::TextCodec &codec);
[[nodiscard]] Cube cubeFrom(std::span<const Line> rows, Warnings &warnings);

} // namespace cellfiles
