// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "journal/database.h"

#include "journal/schema.h"
#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QSqlError>
#include <atomic>

using values::ErrorKind;
using values::Result;

namespace journal {

namespace {

QString tr(const char *text) { return QCoreApplication::translate("journal::Store", text); }

/// SQLITE_CORRUPT and SQLITE_NOTADB.
bool saysDamaged(const QSqlError &error)
{
    return error.nativeErrorCode() == u"11" || error.nativeErrorCode() == u"26";
}

QString freshName()
{
    static std::atomic_int count = 0;
    return QStringLiteral("journal-%1").arg(++count);
}

void configure(QSqlDatabase &database, const QUrl &place)
{
    if (place.isLocalFile()) {
        database.setDatabaseName(place.toLocalFile());
        database.setConnectOptions(QStringLiteral("QSQLITE_BUSY_TIMEOUT=5000"));
        return;
    }
    database.setHostName(place.host());
    database.setPort(place.port(5432));
    database.setUserName(place.userName());
    database.setPassword(place.password());
    database.setDatabaseName(place.path().mid(1));
    database.setConnectOptions(QStringLiteral("connect_timeout=5"));
}

} // namespace

Database::Database(QUrl place) : m_place {std::move(place)} { }

Database::~Database() { close(); }

Result<void> Database::open()
{
    if (!m_connection.isEmpty() && isFile() && !QFileInfo(m_place.toLocalFile()).isFile())
        close(); // somebody removed the file: writing on would write into nothing
    if (!m_connection.isEmpty() && !m_isDamaged)
        return {};
    Result<void> opened = m_isDamaged ? setAside() : Result<void> {};
    opened = opened.and_then([this] { return connect(); });
    if (!opened && m_isDamaged)
        opened = setAside().and_then([this] { return connect(); });
    if (!opened)
        close();
    return opened;
}

void Database::close()
{
    m_statements.clear();
    if (!m_connection.isEmpty())
        QSqlDatabase::removeDatabase(std::exchange(m_connection, {}));
}

Result<void> Database::connect()
{
    if (isFile() && !QFileInfo(m_place.toLocalFile()).dir().mkpath(QStringLiteral(".")))
        return values::failure(ErrorKind::LocalFile, tr("The folder of the journal cannot be made."));
    m_connection = freshName();
    QSqlDatabase database =
        QSqlDatabase::addDatabase(isFile() ? QStringLiteral("QSQLITE") : QStringLiteral("QPSQL"), m_connection);
    configure(database, m_place);
    if (!database.open())
        return failure(database.lastError());
    return prepare();
}

Result<void> Database::prepare()
{
    if (isFile()) {
        auto configured = execute(QStringLiteral("PRAGMA journal_mode=WAL")).and_then([this] {
            return execute(QStringLiteral("PRAGMA synchronous=NORMAL"));
        });
        if (!configured)
            return configured;
    }
    const auto counted =
        execute(QStringLiteral("CREATE TABLE IF NOT EXISTS journal_version (number INTEGER NOT NULL)"));
    return counted.and_then([this] { return inTransaction([this] { return migrate(); }); });
}

Result<int> Database::version()
{
    return run(QStringLiteral("SELECT MAX(number) FROM journal_version")).map([](QSqlQuery *query) {
        const int number = query->next() ? query->value(0).toInt() : 0;
        query->finish();
        return number;
    });
}

Result<void> Database::migrate()
{
    const auto present = version();
    if (!present)
        return tl::unexpected(present.error());
    const auto steps = schemaSteps(isFile() ? sqliteDialect() : postgresDialect());
    if (*present > steps.size())
        return values::failure(ErrorKind::LocalFile, tr("The journal was made by a newer version of Pendesk."));
    for (qsizetype step = *present; step < steps.size(); ++step) {
        for (const QString &statement : steps[step]) {
            if (auto done = execute(statement); !done)
                return done;
        }
        if (auto done = execute(QStringLiteral("INSERT INTO journal_version VALUES (%1)").arg(step + 1)); !done)
            return done;
    }
    return {};
}

/// The file, and what SQLite wrote beside it, under a name with the time.
Result<void> Database::setAside()
{
    close();
    const QFileInfo file {m_place.toLocalFile()};
    const QString stamp = QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMdd'T'HHmmsszzz'Z'"));
    const QString aside =
        file.dir().filePath(QStringLiteral("%1.damaged-%2.%3").arg(file.completeBaseName(), stamp, file.suffix()));
    if (!QFile::rename(file.filePath(), aside))
        return values::failure(ErrorKind::LocalFile, tr("The damaged journal cannot be given another name."));
    for (const char *beside : {"-wal", "-shm"})
        QFile::rename(file.filePath() + QLatin1String(beside), aside + QLatin1String(beside));
    m_isDamaged = false;
    m_setAside = aside;
    return {};
}

Result<QSqlQuery *> Database::run(const QString &statement, const QVariantList &bound)
{
    auto found = m_statements.find(statement);
    if (found == m_statements.end()) {
        QSqlQuery query {QSqlDatabase::database(m_connection, false)};
        query.setForwardOnly(true);
        if (!query.prepare(statement))
            return failure(query.lastError());
        found = m_statements.emplace(statement, std::move(query)).first;
    }
    QSqlQuery &query = found->second;
    for (int i = 0; i < bound.size(); ++i)
        query.bindValue(i, bound[i]);
    if (!query.exec())
        return failure(query.lastError());
    return &query;
}

Result<void> Database::execute(const QString &statement)
{
    QSqlQuery query {QSqlDatabase::database(m_connection, false)};
    if (!query.exec(statement))
        return failure(query.lastError());
    return {};
}

Result<void> Database::inTransaction(const std::function<Result<void>()> &work)
{
    for (const QString &statement : (isFile() ? sqliteDialect() : postgresDialect()).begin) {
        if (auto begun = execute(statement); !begun)
            return begun;
    }
    Result<void> done = work();
    if (done)
        done = execute(QStringLiteral("COMMIT"));
    if (!done)
        static_cast<void>(execute(QStringLiteral("ROLLBACK"))); // what went wrong before says more
    return done;
}

tl::unexpected<values::Error> Database::failure(const QSqlError &error)
{
    m_isDamaged |= isFile() && saysDamaged(error);
    const QString words = error.databaseText().isEmpty() ? error.driverText() : error.databaseText();
    return values::failure(ErrorKind::LocalFile, words);
}

} // namespace journal
