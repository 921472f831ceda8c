// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/error.h"
#include <QByteArray>
#include <QByteArrayView>

namespace values {

/// The name of a file on a controller, in the pendant's encoding: "DEMO01.JBI" (reference §7, §8). It can only hold a
/// plain name, so a name that a controller sent never leads out of a folder of this computer.
class FileName
{
public:
    static constexpr qsizetype maxBaseSize = 32;
    static constexpr qsizetype maxExtensionSize = 8;

    /// BadInput unless `bytes` are a base of 1 to 32 bytes and perhaps an extension, without control characters, wild
    /// cards, path separators or a dot in front.
    static Result<FileName> create(QByteArrayView bytes);
    /// The image of the batch backup, the only file with a path (reference §7.5).
    static FileName batchBackup() { return FileName {"/SPDRV/CMOSBK.BIN"}; }

    [[nodiscard]] const QByteArray &bytes() const { return m_bytes; }
    /// Without the extension; for a job, the name that 0x73 and 0x87 use.
    [[nodiscard]] QByteArrayView base() const;
    /// "JBI"; empty if there is none.
    [[nodiscard]] QByteArrayView extension() const;

    friend auto operator<=>(const FileName &a, const FileName &b) { return a.m_bytes.compare(b.m_bytes) <=> 0; }
    friend bool operator==(const FileName &, const FileName &) = default;

private:
    explicit FileName(QByteArray bytes) : m_bytes {std::move(bytes)} { }

    QByteArray m_bytes;
};

} // namespace values
