// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "virtualcontroller/memory.h"
#include <tl/expected.hpp>

/// What the controller does with its files, apart from packets. All refusals are added statuses (reference §7.6, §9).
namespace virtualcontroller::filestore {

/// The names that a list filter asks for, each ended by CR LF (reference §7.4): empty, "*", "**" and "*.JBI" mean the
/// jobs, "*.DAT" and the like another type, "*.*" everything.
[[nodiscard]] tl::expected<QByteArray, quint16> list(const Memory &memory, const QByteArray &filter);
/// The contents of a file.
[[nodiscard]] tl::expected<QByteArray, quint16> save(const Memory &memory, const QByteArray &name);
/// Deletes a job; other files cannot be deleted. An added status, or 0.
[[nodiscard]] quint16 remove(Memory &memory, const QByteArray &name);
/// Whether a file of that name may be loaded at all: an added status, or 0.
[[nodiscard]] quint16 loadRefusal(const Memory &memory, const QByteArray &name);
/// Takes a file over. A job is kept under the name that it gives itself (reference §7.8). An added status, or 0.
[[nodiscard]] quint16 load(Memory &memory, const QByteArray &name, const QByteArray &contents);

} // namespace virtualcontroller::filestore
