// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/backup.h"

#include <QtConcurrent>
#include <algorithm>

using values::ErrorKind;
using values::FileName;
using values::Result;

namespace files {

/// What is open on disk. Whoever seals shares it, so that the lock is held until that is over.
struct Backup::Writing {
    std::unique_ptr<QLockFile> lock;
    std::unique_ptr<BagWriter> writer;
};

Backup::Backup(session::FileSession &session, BackupOrder order, QObject *parent)
    : Operation {parent},
      m_order {std::move(order)},
      m_archive {m_order.root, m_order.info.controller},
      m_collection {session,
          [this](const FileName &name, const QByteArray &content) { return m_writing->writer->add(name, content); }}
{
    connect(&m_collection, &Operation::progressed, this, &Operation::progressed);
    connect(&m_collection, &Operation::finished, this, &Backup::onCollected);
    connect(&m_sealing, &QFutureWatcherBase::finished, this, [this] {
        const Result<QString> sealed = m_sealing.result();
        m_writing.reset();
        m_path = sealed.value_or(QString {});
        finish(sealed.map([](const QString &) {}));
    });
}

void Backup::run()
{
    m_order.info.taken = QDateTime::currentDateTimeUtc();
    m_order.info.results.clear();
    auto lock = m_archive.lock();
    if (!lock)
        return finish(tl::unexpected(lock.error()));
    m_archive.clearPartials();
    auto writer = BagWriter::create(m_archive.folder(), m_order.info.taken);
    if (!writer)
        return finish(tl::unexpected(writer.error()));
    m_collection.readWhatBackupsHold(m_order.wantsAllParameters);
    m_writing = std::make_shared<Writing>(Writing {*std::move(lock), *std::move(writer)});
    m_collection.reset();
    m_collection.start();
}

void Backup::onCollected()
{
    m_order.info.results = m_collection.results();
    const auto isThere = [](const FileResult &result) { return !result.error; };
    const bool hasFiles = std::ranges::any_of(m_order.info.results, isThere);
    if (m_collection.state() == OperationState::Done && hasFiles)
        return seal();
    m_writing.reset();
    if (m_collection.state() == OperationState::Cancelled)
        return finish(values::failure(ErrorKind::Cancelled));
    if (m_collection.error())
        return finish(tl::unexpected(*m_collection.error()));
    const auto &results = m_order.info.results;
    if (!results.isEmpty())
        return finish(tl::unexpected(*results.first().error));
    finish(values::failure(ErrorKind::Malformed, QStringLiteral("the controller lists no files")));
}

void Backup::seal()
{
    const auto work = [writing = m_writing, archive = m_archive, order = m_order] {
        auto sealed = writing->writer->seal(order.info);
        if (!sealed)
            return sealed;
        return archive.prune(order.retention, order.info.taken).map([&](const QStringList &) { return *sealed; });
    };
    m_sealing.setFuture(QtConcurrent::run(work));
}

} // namespace files
