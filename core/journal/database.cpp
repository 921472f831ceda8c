// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "journal/database.h"

#include "disk/durable.h"
#include "journal/queries.h"
#include "journal/schema.h"
#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QSqlDriver>
#include <QSqlError>
#include <atomic>
#ifdef PENDESK_HAS_SQLITE
#include <sqlite3.h>
#endif
#ifdef Q_OS_UNIX
#include <sys/stat.h>
#endif

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

/// The inode; 0 if there is no regular file, or none that could be told from another.
quint64 fileNumber(const QString &path)
{
#ifdef Q_OS_UNIX
    struct stat about {
    };
    const bool isThere = ::stat(QFile::encodeName(path).constData(), &about) == 0 && S_ISREG(about.st_mode);
    return isThere ? about.st_ino : 0;
#else
    return QFileInfo {path}.isFile() ? 1 : 0;
#endif
}

/// Who writes for longer is waited for by trying again, so that the end of the program need not wait for them.
constexpr auto busyOptions = "QSQLITE_BUSY_TIMEOUT=800";

void configure(QSqlDatabase &database, const QUrl &place, Database::Use use)
{
    if (place.isLocalFile()) {
        database.setDatabaseName(place.toLocalFile());
        const auto readOnly = use == Database::Use::Reading ? QStringLiteral(";QSQLITE_OPEN_READONLY") : QString();
        database.setConnectOptions(QLatin1String(busyOptions) + readOnly);
        return;
    }
    database.setHostName(place.host());
    database.setPort(place.port(5432));
    database.setUserName(place.userName());
    database.setPassword(place.password());
    database.setDatabaseName(place.path().mid(1));
    database.setConnectOptions(QStringLiteral("connect_timeout=5"));
}

#ifdef PENDESK_HAS_SQLITE
/// The handle, if Qt uses the very library that this program is linked with.
sqlite3 *handleOf(const QSqlDatabase &database)
{
    const QVariant handle = database.driver()->handle();
    if (qstrcmp(handle.typeName(), "sqlite3*") != 0)
        return nullptr;
    QSqlQuery query {QStringLiteral("SELECT sqlite_source_id()"), database};
    const bool isSame = query.next() && query.value(0).toString() == QLatin1String(sqlite3_sourceid());
    return isSame ? *static_cast<sqlite3 *const *>(handle.constData()) : nullptr;
}
constexpr int stepsBetweenQuestions = 20'000; ///< A few milliseconds.
#endif

} // namespace

Database::Database(QUrl place, Use use) : m_place {std::move(place)}, m_use {use} { }

Database::~Database() { close(); }

/// Somebody may have removed the file, or put another one there: writing on would write into nothing.
bool Database::isSameFile() const { return !isFile() || fileNumber(m_place.toLocalFile()) == m_file; }

Result<void> Database::open()
{
    if (!m_connection.isEmpty() && !isSameFile())
        close();
    if (!m_connection.isEmpty() && !m_isDamaged)
        return {};
    const auto setAsideIfWriting = [this]() -> Result<void> {
        close();
        if (m_use == Use::Writing)
            return setAside();
        m_isDamaged = false; // whoever writes puts a new one there
        return {};
    };
    Result<void> opened = m_isDamaged ? setAsideIfWriting() : Result<void> {};
    opened = opened.and_then([this] { return connect(); });
    if (!opened && m_isDamaged && m_use == Use::Writing)
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
    const QString path = m_place.toLocalFile();
    const QDir folder = QFileInfo {path}.dir();
    if (isFile() && m_use == Use::Writing && !folder.exists() && !disk::makePrivateFolder(folder.path()))
        return values::failure(ErrorKind::LocalFile, tr("The folder of the journal cannot be made."));
    m_connection = freshName();
    QSqlDatabase database =
        QSqlDatabase::addDatabase(isFile() ? QStringLiteral("QSQLITE") : QStringLiteral("QPSQL"), m_connection);
    configure(database, m_place, m_use);
    if (!database.open())
        return failure(database.lastError());
    if (isFile() && m_use == Use::Writing)
        QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner); // before SQLite makes files beside it
    m_file = fileNumber(path);
    interruptUnless(m_isWanted);
    return m_use == Use::Writing ? prepare() : checkVersion();
}

void Database::interruptUnless(std::function<bool()> isWanted)
{
    m_isWanted = std::move(isWanted);
#ifdef PENDESK_HAS_SQLITE
    if (m_connection.isEmpty() || !isFile())
        return;
    const auto ask = [](void *wanted) { return (*static_cast<std::function<bool()> *>(wanted))() ? 0 : 1; };
    if (sqlite3 *handle = handleOf(QSqlDatabase::database(m_connection, false)))
        sqlite3_progress_handler(handle, stepsBetweenQuestions, m_isWanted ? +ask : nullptr, &m_isWanted);
#endif
}

Result<void> Database::checkVersion()
{
    const auto present = version();
    if (!present)
        return tl::unexpected(present.error());
    if (*present != schemaSteps(sqliteDialect()).size())
        return values::failure(ErrorKind::LocalFile, QStringLiteral("another version"));
    return {};
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
        if (auto done = step == 1 ? countKeptAlarms(*this) : Result<void> {}; !done)
            return done;
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
