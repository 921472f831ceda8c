// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/error.h"
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QUrl>
#include <functional>
#include <unordered_map>

namespace journal {

/// The connection to the journal's database: SQLite for a file URL, PostgreSQL for "postgresql://user@host/database".
/// It belongs to the thread that opens it. For the store's worker only; every call may block.
class Database
{
public:
    enum class Use {
        Writing, ///< Makes the file and its tables, and sets a damaged one aside.
        Reading, ///< Answers beside the one that writes, from a database that is as it should be.
    };
    explicit Database(QUrl place, Use use = Use::Writing);
    ~Database();
    Q_DISABLE_COPY_MOVE(Database)

    /// Opens it, unless that is done. For writing the tables are brought up to date; a damaged file is set aside under
    /// another name and a new one begun.
    [[nodiscard]] values::Result<void> open();
    void close();
    [[nodiscard]] const QUrl &place() const { return m_place; }

    /// Runs one statement with a value for each "?". The query is good until the next run of the same statement.
    [[nodiscard]] values::Result<QSqlQuery *> run(const QString &statement, const QVariantList &bound = {});
    /// All of `work` or nothing of it. No other desk writes meanwhile.
    [[nodiscard]] values::Result<void> inTransaction(const std::function<values::Result<void>()> &work);

    /// Statements end with an error as soon as `isWanted` says no; it is asked some hundred times a second.
    void interruptUnless(std::function<bool()> isWanted);

    /// The last error says that the file is damaged. The next open() sets it aside.
    [[nodiscard]] bool isDamaged() const { return m_isDamaged; }
    /// Where a damaged file was put since the last call; empty if none was.
    [[nodiscard]] QString takeSetAside() { return std::exchange(m_setAside, {}); }

private:
    [[nodiscard]] bool isFile() const { return m_place.isLocalFile(); }
    [[nodiscard]] bool isSameFile() const;
    [[nodiscard]] values::Result<void> connect();
    [[nodiscard]] values::Result<void> checkVersion();
    [[nodiscard]] values::Result<void> prepare();
    [[nodiscard]] values::Result<void> migrate();
    [[nodiscard]] values::Result<int> version();
    [[nodiscard]] values::Result<void> setAside();
    [[nodiscard]] values::Result<void> execute(const QString &statement);
    [[nodiscard]] tl::unexpected<values::Error> failure(const QSqlError &error);

    QUrl m_place;
    Use m_use;
    quint64 m_file = 0; ///< Which file is open, whatever name it has by now.
    std::function<bool()> m_isWanted;
    QString m_connection; ///< Qt's name of the connection; empty while closed.
    std::unordered_map<QString, QSqlQuery> m_statements; ///< Prepared ones, by their text.
    QString m_setAside;
    bool m_isDamaged = false;
};

/// A text as it is stored: one that was never given is empty, not NULL.
[[nodiscard]] inline QVariant text(const QString &text) { return text.isNull() ? QStringLiteral("") : text; }
/// A moment as it is stored: milliseconds since 1970, UTC.
[[nodiscard]] inline qint64 stamp(const QDateTime &time) { return time.toMSecsSinceEpoch(); }

} // namespace journal
