// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "cellfiles/view.h"
#include <span>

namespace cellfiles {

/// What a file is to a comparison (controller files reference §2).
enum class FileClass {
    Configuration,
    Data, ///< Changes in production, and counts as a difference all the same.
    Log,
    Counter, ///< Noise.
};

/// May a file go back to a controller (reference §13)?
enum class Restore {
    Allowed,
    Care, ///< Only where a person names the file.
    Never,
};

/// One type of file.
struct FileType {
    const char *pattern; ///< "TOOL.CND", "*.PRM"
    const char *title; ///< For title().
    FileClass fileClass = FileClass::Configuration;
    Restore restore = Restore::Care;
    bool isSafety = false; ///< A change of it may move the robot elsewhere, or switch off what protects people.
    int step = 6; ///< In which step of a restore it is sent, from 1: what others refer to comes first.
    View (*view)(QByteArrayView file, const protocol::TextCodec &codec) = nullptr; ///< nullptr: bytes and nothing else.
};

[[nodiscard]] std::span<const FileType> fileTypes();
/// The type of a file by its name, in any case. What nobody knows is configuration, and is compared line by line.
[[nodiscard]] const FileType &fileTypeOf(QByteArrayView name);
/// What the file says. Of an unknown text file: its lines under their headers; of others: nothing.
[[nodiscard]] View viewOf(QByteArrayView name, QByteArrayView file, const protocol::TextCodec &codec);

/// Is this, at a glance, a text? NUL bytes and control characters say no.
[[nodiscard]] bool isText(QByteArrayView file);

} // namespace cellfiles
