// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/task.h"

#include "disk/durable.h"
#include "files/bagtext.h"
#include "files/compare.h"
#include "files/localname.h"
#include "protocol/codes.h"
#include <QDir>

using values::Error;
using values::ErrorKind;
using values::FileName;
using values::Result;

namespace files {

namespace {

QString actionOf(Direction direction)
{
    switch (direction) {
    case Direction::Download: return QStringLiteral("download-file");
    case Direction::Upload: return QStringLiteral("upload-file");
    case Direction::Delete: return QStringLiteral("delete-file");
    }
    return {};
}

journal::Outcome outcomeOf(const Operation &operation)
{
    if (operation.state() == OperationState::Done)
        return journal::Outcome::Done;
    switch (operation.error().value_or(Error {ErrorKind::Cancelled}).kind) {
    case ErrorKind::Refused: return journal::Outcome::Refused;
    case ErrorKind::UnknownOutcome: return journal::Outcome::Unknown;
    case ErrorKind::Cancelled: return journal::Outcome::Cancelled;
    default: return journal::Outcome::Withheld;
    }
}

/// "sha256 … , 512 bytes", by which a file can be found again.
QString fingerprint(const QByteArray &content)
{
    return QStringLiteral("%1 bytes, sha256 %2").arg(content.size()).arg(QString::fromLatin1(sha256(content)));
}

QString wordsOf(ReadBack readBack)
{
    switch (readBack) {
    case ReadBack::NotYet: break;
    case ReadBack::Identical: return QStringLiteral("read back identical");
    case ReadBack::Reformatted: return QStringLiteral("reformatted by the controller");
    case ReadBack::Different: return QStringLiteral("read back different");
    case ReadBack::Unreadable: return QStringLiteral("could not be read back");
    }
    return {};
}

} // namespace

Task::Task(session::FileSession &session, Direction direction, FileName name, QString localPath, QObject *parent)
    : Operation {parent}, m_direction {direction}, m_name {std::move(name)}, m_localPath {std::move(localPath)}
{
    use(session);
}

void Task::interrupt()
{
    if (session())
        session()->cancel(m_transfer);
}

values::ErrorKind Task::lossKind() const
{
    return m_direction == Direction::Download ? ErrorKind::NoAnswer : ErrorKind::UnknownOutcome;
}

session::FileSession::Progress Task::counter()
{
    m_bytesDone = 0;
    return [this](qint64 done, qint64 total) {
        m_bytesDone = done;
        m_bytesTotal = total;
        Q_EMIT progressed();
    };
}

void Task::save(session::FileSession::ContentHandler handler, int tries)
{
    const auto take = [this, handler = std::move(handler), tries](const Result<QByteArray> &content) {
        const bool isSilence = !content && content.error().kind == ErrorKind::NoAnswer;
        if (isSilence && tries > 1 && !isCancelling())
            return save(handler, tries - 1);
        if (content)
            m_bytesDone = content->size();
        handler(content);
    };
    m_transfer = session()->save(m_name, this, take, counter());
}

void Task::load(const QByteArray &content, session::FileSession::DoneHandler handler)
{
    m_transfer = session()->load(m_name, content, this, std::move(handler), counter());
}

void Task::remove(session::FileSession::DoneHandler handler)
{
    m_transfer = session()->remove(m_name, this, std::move(handler));
}

double Task::bytesPerSecond() const
{
    const auto milliseconds = duration().count();
    return milliseconds > 0 ? double(m_bytesDone) * 1000 / double(milliseconds) : 0;
}

std::optional<session::Milliseconds> Task::remaining() const
{
    const double rate = bytesPerSecond();
    if (m_bytesTotal == 0 || rate <= 0)
        return std::nullopt;
    return session::Milliseconds {qint64(double(m_bytesTotal - m_bytesDone) * 1000 / rate)};
}

journal::OrderRecord Task::record() const
{
    journal::OrderRecord record;
    record.at = QDateTime::currentDateTimeUtc().addMSecs(-duration().count());
    record.action = actionOf(m_direction);
    record.subject = QString::fromLatin1(m_name.bytes());
    record.outcome = outcomeOf(*this);
    record.duration = duration();
    if (error()) {
        record.status = error()->status;
        record.added = error()->addedStatus;
        record.reply = protocol::explain(*error());
    } else if (state() == OperationState::Cancelled) {
        record.reply = QStringLiteral("cancelled");
    }
    return record;
}

Download::Download(session::FileSession &session, const FileName &name, const QString &localPath, QObject *parent)
    : Task {session, Direction::Download, name, localPath, parent}
{
}

void Download::run()
{
    save([this](const Result<QByteArray> &content) {
        finish(content.and_then([this](const QByteArray &bytes) { return disk::replaceFile(localPath(), bytes); }));
    });
}

Upload::Upload(
    session::FileSession &session, const FileName &name, const QString &localPath, Guard guard, QObject *parent)
    : Task {session, Direction::Upload, name, localPath, parent}, m_guard {std::move(guard)}
{
}

Upload::Upload(session::FileSession &session, const FileName &name, QByteArray content, Guard guard, QObject *parent)
    : Task {session, Direction::Upload, name, {}, parent}, m_guard {std::move(guard)}, m_content {std::move(content)}
{
}

void Upload::run()
{
    m_readBack = ReadBack::NotYet;
    if (!localPath().isEmpty()) {
        auto content = disk::readFile(localPath());
        if (!content)
            return finish(tl::unexpected(content.error()));
        m_content = *std::move(content);
    }
    m_guard(this, [this](const Result<void> &permission) {
        if (!permission)
            return finish(permission);
        if (isCancelling())
            return finish(values::failure(ErrorKind::Cancelled));
        send();
    });
}

void Upload::send()
{
    load(m_content, [this](const Result<void> &done) {
        if (!done)
            return finish(done);
        save([this](const Result<QByteArray> &received) { compareWith(received); });
    });
}

void Upload::compareWith(const Result<QByteArray> &received)
{
    if (received) {
        m_received = *received;
        std::tie(m_readBack, m_reformattedLines) = judgeReadBack(m_content, m_received);
    } else {
        m_readBack = ReadBack::Unreadable;
    }
    finish({});
}

journal::OrderRecord Upload::record() const
{
    journal::OrderRecord record = Task::record();
    record.newValue = fingerprint(m_content);
    if (record.reply.isEmpty())
        record.reply = wordsOf(m_readBack);
    return record;
}

Removal::Removal(
    session::FileSession &session, const FileName &name, const QString &folderOfCopies, Guard guard, QObject *parent)
    : Task {session, Direction::Delete, name, folderOfCopies, parent}, m_guard {std::move(guard)}
{
}

void Removal::run()
{
    m_guard(this, [this](const Result<void> &permission) {
        if (!permission)
            return finish(permission);
        save([this](const Result<QByteArray> &content) { removeIfKept(content); });
    });
}

Result<void> Removal::keep(const QByteArray &content)
{
    if (!QDir {}.mkpath(localPath()))
        return values::failure(ErrorKind::LocalFile, QStringLiteral("%1: the folder cannot be made").arg(localPath()));
    m_copy = freePath(localPath(), name());
    return disk::replaceFile(m_copy, content);
}

void Removal::removeIfKept(const Result<QByteArray> &content)
{
    const auto kept = content.and_then([this](const QByteArray &bytes) { return keep(bytes); });
    if (!kept)
        return finish(kept);
    if (isCancelling())
        return finish(values::failure(ErrorKind::Cancelled));
    remove([this](const Result<void> &done) { finish(done); });
}

journal::OrderRecord Removal::record() const
{
    journal::OrderRecord record = Task::record();
    record.oldValue = m_copy.isEmpty() ? QString {} : QStringLiteral("copy in %1").arg(m_copy);
    return record;
}

std::pair<ReadBack, int> judgeReadBack(const QByteArray &sent, const QByteArray &received)
{
    if (sent == received)
        return {ReadBack::Identical, 0};
    const auto lines = compareText(sent, received, NoiseFilter::none());
    const int differing = int(std::ranges::count(lines, false, &ComparedLine::isSame));
    const auto flat = [](const QByteArray &content) {
        QByteArrayList result = NoiseFilter {}.cleanLines(content);
        for (QByteArray &line : result)
            line = line.simplified();
        result.removeAll({});
        return result;
    };
    return {flat(sent) == flat(received) ? ReadBack::Reformatted : ReadBack::Different, differing};
}

QString freePath(const QString &folder, const FileName &name)
{
    const QString local = toLocalName(name.bytes());
    const qsizetype dot = local.lastIndexOf(u'.');
    const QString base = dot < 0 ? local : local.first(dot);
    const QString extension = dot < 0 ? QString {} : local.sliced(dot);
    QString path = folder + u'/' + local;
    for (int number = 2; QFileInfo::exists(path); ++number)
        path = QStringLiteral("%1/%2 (%3)%4").arg(folder, base).arg(number).arg(extension);
    return path;
}

} // namespace files
