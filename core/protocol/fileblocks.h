// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/effect.h"
#include "protocol/filelimits.h"
#include "protocol/packet.h"
#include "values/filename.h"
#include <QList>
#include <span>

namespace protocol {

/// A service of the file port (reference §7).
struct FileService {
    Service service;
    const char *name; ///< Plain English, lower case.
    Effect effect;
};

[[nodiscard]] std::span<const FileService> fileServices();
/// nullptr if there is none.
[[nodiscard]] const FileService *findFileService(Service service);

// The requests. All packets of a transfer share the id of its request.

[[nodiscard]] Request deleteFile(const values::FileName &name);
[[nodiscard]] Request loadFile(const values::FileName &name); ///< Computer to controller.
[[nodiscard]] Request saveFile(const values::FileName &name); ///< Controller to computer.
/// `pattern` such as "*.JBI"; the only wild card that is known to work is "*" before an extension.
[[nodiscard]] Request listFiles(QByteArrayView pattern);

[[nodiscard]] QByteArray encodeFileRequest(const Request &request, quint8 id);
/// What the client answers to data block `block`, bit 31 included (reference §1.4).
[[nodiscard]] QByteArray encodeAcknowledgement(Service service, quint8 id, quint32 block);

// Loading: the computer sends blocks.

/// What we send in a block unless told otherwise; 479 is the limit (reference §12, conflict 18).
constexpr qsizetype blockSize = 400;

/// How many blocks `content` takes. It is not empty: an empty file cannot be sent (reference §7.6).
[[nodiscard]] quint32 blockCount(QByteArrayView content, qsizetype size = blockSize);
/// The number of block `index`, from 1, of `count`, with the mark of the last one.
[[nodiscard]] constexpr quint32 blockNumber(quint32 index, quint32 count)
{
    return index == count ? index | lastBlock : index;
}
/// Block `index` of `content`, from 1 to blockCount().
[[nodiscard]] QByteArray encodeLoadBlock(QByteArrayView content, quint32 index, quint8 id, qsizetype size = blockSize);

/// The controller's "go ahead" to a load request, whose block number is 0 or that of a single reply (reference §12,
/// conflict 12). An error if it refuses.
[[nodiscard]] values::Result<void> checkGoAhead(const Reply &reply);
/// The controller's answer to load block `block`. Malformed if it acknowledges another one.
[[nodiscard]] values::Result<void> checkAcknowledgement(const Reply &reply, quint32 block);

// Saving and listing: the controller sends blocks.

/// Joins the data blocks of a save or a list.
class BlockCollector
{
public:
    enum class Step {
        Next, ///< Taken; acknowledge it, more will come.
        Repeated, ///< Had it already: acknowledge it again.
        Complete, ///< Taken, and it was the last one; acknowledge it.
    };

    /// Holds at most `limit` bytes.
    explicit BlockCollector(qsizetype limit = fileLimit) : m_limit {limit} { }

    /// The refusal if `reply` is one; Malformed if the block is out of turn, or if fault() says so.
    [[nodiscard]] values::Result<Step> take(const Reply &reply);
    /// Why this cannot become a file any more, whatever comes: a block was empty and not the last one, or there were
    /// more bytes than the limit. Empty while it can.
    [[nodiscard]] const std::optional<values::Error> &fault() const { return m_fault; }

    [[nodiscard]] const QByteArray &content() const { return m_content; }
    [[nodiscard]] bool isComplete() const { return m_isComplete; }

private:
    tl::unexpected<values::Error> broken(const QString &why);

    qsizetype m_limit;
    QByteArray m_content;
    std::optional<values::Error> m_fault;
    quint32 m_last = 0; ///< The number of the newest block, without the mark.
    bool m_isComplete = false;
};

/// The names in a list's content.
struct FileList {
    QList<values::FileName> names;
    QByteArrayList rejected; ///< What no file of ours may be called: shown, never used.
};
/// `content` is all blocks joined: names ended by CR LF (reference §7.4), or by LF alone. Empty lines are dropped.
[[nodiscard]] FileList parseFileList(const QByteArray &content);

} // namespace protocol
