// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/operation.h"
#include "journal/record.h"

namespace files {

enum class Direction {
    Download, ///< Controller to computer.
    Upload, ///< Computer to controller.
    Delete,
};

/// What the controller has after an upload.
enum class ReadBack {
    NotYet,
    Identical,
    Reformatted, ///< The same but for blanks, line ends and dates.
    Different,
    Unreadable, ///< The controller took the file and did not give it back: nobody knows.
};

/// One file on its way.
class Task : public Operation
{
    Q_OBJECT

public:
    [[nodiscard]] Direction direction() const { return m_direction; }
    [[nodiscard]] const values::FileName &name() const { return m_name; }
    /// The file or folder on this computer; empty for none.
    [[nodiscard]] const QString &localPath() const { return m_localPath; }
    [[nodiscard]] qint64 bytesDone() const { return m_bytesDone; }
    /// 0 where nobody knows: a controller does not tell the size of a file beforehand.
    [[nodiscard]] qint64 bytesTotal() const { return m_bytesTotal; }
    /// 0 before it can be told.
    [[nodiscard]] double bytesPerSecond() const;
    /// Empty where the size is unknown.
    [[nodiscard]] std::optional<session::Milliseconds> remaining() const;
    /// For the journal, when it is over. Who, where and with which controller is left to the caller.
    [[nodiscard]] virtual journal::OrderRecord record() const;

protected:
    Task(session::FileSession &session, Direction direction, values::FileName name, QString localPath, QObject *parent);

    void interrupt() override;
    [[nodiscard]] values::ErrorKind lossKind() const override;
    /// Reads the file, again if nobody answered: up to three times in all.
    void save(session::FileSession::ContentHandler handler, int tries = 3);
    void load(const QByteArray &content, session::FileSession::DoneHandler handler);
    void remove(session::FileSession::DoneHandler handler);
    [[nodiscard]] session::FileSession::Progress counter();

private:
    Direction m_direction;
    values::FileName m_name;
    QString m_localPath;
    session::FileSession::TransferId m_transfer = 0;
    qint64 m_bytesDone = 0;
    qint64 m_bytesTotal = 0;
};

/// Reads a file of the controller and then, when it is whole, writes it to `localPath`. A file that was there before is
/// replaced at once or stays.
class Download : public Task
{
    Q_OBJECT

public:
    Download(session::FileSession &session, const values::FileName &name, const QString &localPath,
        QObject *parent = nullptr);

protected:
    void run() override;
};

/// Sends a file and reads it back. Whether it may replace one must have been asked; `guard` is asked at the last moment
/// whether it may now.
class Upload : public Task
{
    Q_OBJECT

public:
    /// The content is that of `localPath`, read when it is the turn of this upload.
    Upload(session::FileSession &session, const values::FileName &name, const QString &localPath, Guard guard,
        QObject *parent = nullptr);
    Upload(session::FileSession &session, const values::FileName &name, QByteArray content, Guard guard,
        QObject *parent = nullptr);

    [[nodiscard]] ReadBack readBack() const { return m_readBack; }
    /// How many lines the controller wrote otherwise.
    [[nodiscard]] int reformattedLines() const { return m_reformattedLines; }
    [[nodiscard]] const QByteArray &sent() const { return m_content; }
    [[nodiscard]] const QByteArray &received() const { return m_received; }
    [[nodiscard]] journal::OrderRecord record() const override;

protected:
    void run() override;

private:
    void send();
    void compareWith(const values::Result<QByteArray> &received);

    Guard m_guard;
    QByteArray m_content;
    QByteArray m_received;
    ReadBack m_readBack = ReadBack::NotYet;
    int m_reformattedLines = 0;
};

/// Reads a file, keeps it in a folder of this computer, and then deletes it at the controller. Without the copy nothing
/// is deleted.
class Removal : public Task
{
    Q_OBJECT

public:
    Removal(session::FileSession &session, const values::FileName &name, const QString &folderOfCopies, Guard guard,
        QObject *parent = nullptr);

    /// Where the copy is; empty before.
    [[nodiscard]] const QString &copy() const { return m_copy; }
    [[nodiscard]] journal::OrderRecord record() const override;

protected:
    void run() override;

private:
    [[nodiscard]] values::Result<void> keep(const QByteArray &content);
    void removeIfKept(const values::Result<QByteArray> &content);

    Guard m_guard;
    QString m_copy;
};

/// How `received` came back of `sent`, and in how many lines they differ.
[[nodiscard]] std::pair<ReadBack, int> judgeReadBack(const QByteArray &sent, const QByteArray &received);

/// A path in `folder` for `name` that is free: "HOME.JBI", "HOME (2).JBI".
[[nodiscard]] QString freePath(const QString &folder, const values::FileName &name);

} // namespace files
