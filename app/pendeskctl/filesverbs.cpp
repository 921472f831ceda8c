// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "desk.h"
#include "files/collection.h"
#include "files/durable.h"
#include "files/localname.h"
#include "files/preflight.h"
#include "files/queue.h"
#include "protocol/codes.h"
#include "verbs.h"
#include <QDir>
#include <QJsonArray>
#include <QJsonObject>
#include <QRegularExpression>
#include <memory>

using files::OperationState;
using values::Error;
using values::ErrorKind;
using values::FileName;
using values::Result;

namespace pendeskctl {

namespace {

/// The names among `results` that match `pattern` ("*.JBI", "WELD*").
QStringList matching(const QList<files::FileResult> &results, const QString &pattern, const Desk &desk)
{
    const auto wild = QRegularExpression::fromWildcard(pattern, Qt::CaseInsensitive);
    QStringList names;
    for (const files::FileResult &result : results) {
        const QString name = desk.codec().decode(result.name);
        if (!result.error && wild.match(name).hasMatch())
            names << name;
    }
    return names;
}

/// Which lists a pattern needs: one where it names a type, else all.
QByteArrayList listsFor(const QString &pattern)
{
    const qsizetype dot = pattern.lastIndexOf(u'.');
    const QByteArray list = "*" + pattern.mid(dot).toLatin1().toUpper();
    const auto all = files::Collection::allPatterns();
    return dot >= 0 && all.contains(list) ? QByteArrayList {list} : all;
}

/// Lists and hands the names over; ends the program when a list cannot be had.
void list(Desk &desk, const QString &pattern, const std::function<void(const QStringList &)> &handler)
{
    auto *collection = new files::Collection {desk.files(), {}, &desk};
    collection->setPatterns(listsFor(pattern));
    collection->setListingOnly(true);
    QObject::connect(collection, &files::Operation::finished, &desk, [&desk, collection, pattern, handler] {
        if (collection->error())
            return desk.fail(*collection->error());
        const auto &results = collection->results();
        const auto failed =
            std::ranges::find_if(results, [](const files::FileResult &result) { return result.error.has_value(); });
        if (failed != results.end() && failed->error->kind == ErrorKind::Refused)
            return desk.fail(*failed->error);
        handler(matching(results, pattern, desk));
    });
    collection->start();
}

void printNames(Desk &desk, const QStringList &names)
{
    if (desk.call().isJson)
        print(QJsonValue {QJsonArray::fromStringList(names)});
    for (const QString &name : desk.call().isJson ? QStringList {} : names)
        print(name);
    desk.finish(Done);
}

QString wordsOf(files::ReadBack readBack, int lines)
{
    switch (readBack) {
    case files::ReadBack::NotYet: break;
    case files::ReadBack::Identical: return QStringLiteral("identical");
    case files::ReadBack::Reformatted: return QStringLiteral("reformatted %1 lines").arg(lines);
    case files::ReadBack::Different: return QStringLiteral("different");
    case files::ReadBack::Unreadable: return QStringLiteral("could not be read back");
    }
    return {};
}

/// Carries out a queue, tells of each task, and finds the exit code.
class Transfers : public QObject
{
public:
    Transfers(Desk &desk, int skipped) : QObject {&desk}, m_desk {desk}, m_skipped {skipped}
    {
        connect(&m_queue, &files::TransferQueue::changed, this, &Transfers::onChanged);
        connect(&m_queue, &files::TransferQueue::finished, this, &Transfers::onFinished);
    }

    void add(std::unique_ptr<files::Task> task) { m_queue.add(std::move(task)); }

private:
    void onChanged(int row)
    {
        const files::Task &task = m_queue.at(row);
        if (task.state() == OperationState::Running)
            showProgress(m_desk.call(),
                QStringLiteral("%1/%2  %3  %4 bytes")
                    .arg(row + 1)
                    .arg(m_queue.size())
                    .arg(QString::fromLatin1(task.name().bytes()))
                    .arg(task.bytesDone()));
    }

    void onFinished(files::Task *task)
    {
        tell(*task);
        if (m_queue.isIdle())
            end();
    }

    void tell(const files::Task &task)
    {
        const QString name = m_desk.codec().decode(task.name().bytes());
        QJsonObject json {{QStringLiteral("name"), name}};
        if (task.error()) {
            m_desk.complainOf(*task.error());
            json.insert(QStringLiteral("error"), protocol::explain(*task.error()));
            m_lastFailure = exitCodeOf(*task.error());
            ++m_failures;
        }
        const QString result = resultOf(task);
        json.insert(QStringLiteral("result"), result);
        if (!m_desk.call().isJson)
            print(QStringLiteral("%1  %2").arg(name, result));
        m_report << json;
    }

    QString resultOf(const files::Task &task)
    {
        if (task.error())
            return QStringLiteral("failed");
        if (const auto *upload = qobject_cast<const files::Upload *>(&task)) {
            using enum files::ReadBack;
            m_differs = m_differs || upload->readBack() == Different || upload->readBack() == Unreadable;
            return wordsOf(upload->readBack(), upload->reformattedLines());
        }
        if (const auto *removal = qobject_cast<const files::Removal *>(&task))
            return QStringLiteral("deleted, copy in %1").arg(removal->copy());
        return QStringLiteral("%1 bytes").arg(task.bytesDone());
    }

    void end()
    {
        if (m_desk.call().isJson)
            print(QJsonValue {m_report});
        if (m_failures > 0)
            return m_desk.finish(m_failures == m_queue.size() ? m_lastFailure : Partial);
        m_desk.finish(m_differs ? VerificationFailed : m_skipped > 0 ? Partial : Done);
    }

    Desk &m_desk;
    files::TransferQueue m_queue;
    QJsonArray m_report;
    ExitCode m_lastFailure = Done;
    int m_failures = 0;
    int m_skipped;
    bool m_differs = false;
};

/// Patterns become the names that the controller has; other names stay.
void expand(Desk &desk, const QStringList &words, const QStringList &done,
    const std::function<void(const QStringList &)> &handler)
{
    if (words.isEmpty())
        return handler(done);
    const auto goOn = [&desk, rest = words.sliced(1), done, handler](
                          const QStringList &names) { expand(desk, rest, done + names, handler); };
    const QString word = words.first();
    if (word.contains(u'*') || word.contains(u'?'))
        list(desk, word, goOn);
    else
        goOn({word});
}

Result<FileName> nameOf(const QString &text, const Desk &desk)
{
    return desk.codec().encode(text).and_then([](const QByteArray &bytes) { return FileName::create(bytes); });
}

/// Makes a task for each name and carries them out.
void transfer(
    Desk &desk, const QStringList &names, const std::function<std::unique_ptr<files::Task>(const FileName &)> &taskFor)
{
    std::vector<std::unique_ptr<files::Task>> tasks;
    int skipped = 0;
    for (const QString &text : names) {
        const auto name = nameOf(text, desk);
        if (!name)
            return desk.fail(name.error());
        if (auto task = taskFor(*name))
            tasks.push_back(std::move(task));
        else
            ++skipped;
    }
    if (tasks.empty())
        return desk.finish(skipped > 0 ? Partial : Done);
    auto *transfers = new Transfers {desk, skipped};
    for (auto &task : tasks)
        transfers->add(std::move(task));
}

int get(const Call &call, const QStringList &words, const QString &folder)
{
    if (!QDir {folder}.exists() && !QDir {}.mkpath(folder)) {
        complain(tr("The folder “%1” cannot be made.").arg(folder));
        return LocalFile;
    }
    return run(call, [=](Desk &desk) {
        expand(desk, words, {}, [&desk, folder](const QStringList &names) {
            auto locals = std::make_shared<files::LocalNames>();
            transfer(desk, names, [&desk, folder, locals](const FileName &name) -> std::unique_ptr<files::Task> {
                const QString path = folder + u'/' + locals->take(name);
                if (QFileInfo::exists(path) && !desk.call().mayWrite) {
                    complain(tr("%1 exists and is left alone; --yes replaces it.").arg(path));
                    return nullptr;
                }
                return std::make_unique<files::Download>(desk.files(), name, path);
            });
        });
    });
}

/// Tells what the pre-flight found; false if one of it stands against sending.
bool passes(const FileName &name, const QString &path, const Call &call)
{
    const auto content = files::readFile(path);
    if (!content) {
        complain(content.error().detail);
        return false;
    }
    const auto findings = files::preflight(name, *content);
    for (const files::Finding &finding : findings) {
        if (finding.stops() || !call.isQuiet)
            complain(QStringLiteral("%1: %2").arg(path, explain(finding)));
    }
    return files::mayBeSent(findings);
}

int put(const Call &call, const QStringList &paths, bool mayReplace)
{
    std::map<QString, QString> pathOf; // by the name at the controller
    for (const QString &path : paths) {
        const QString local = QFileInfo {path}.fileName();
        const auto name = files::fromLocalName(local);
        if (!name)
            return mistake(tr("“%1” is no name that a controller takes.").arg(local));
        if (!passes(*name, path, call))
            return LocalFile;
        pathOf[QString::fromLatin1(name->bytes())] = path;
    }
    if (const auto end = requireYes(call))
        return *end;
    return run(call, [=](Desk &desk) {
        list(desk, QStringLiteral("*"), [&desk, pathOf, mayReplace](const QStringList &there) {
            QStringList names;
            for (const auto &[name, path] : pathOf)
                names << name;
            transfer(
                desk, names, [&desk, pathOf, mayReplace, there](const FileName &name) -> std::unique_ptr<files::Task> {
                    const QString text = QString::fromLatin1(name.bytes());
                    if (!mayReplace && there.contains(text)) {
                        complain(tr("%1 exists at the controller and is left alone; --replace replaces it.").arg(text));
                        return nullptr;
                    }
                    return std::make_unique<files::Upload>(desk.files(), name, pathOf.at(text), desk.guard());
                });
        });
    });
}

int rm(const Call &call, const QStringList &words, const QString &folder)
{
    if (const auto end = requireYes(call))
        return *end;
    return run(call, [=](Desk &desk) {
        expand(desk, words, {}, [&desk, folder](const QStringList &names) {
            transfer(desk, names, [&desk, folder](const FileName &name) {
                return std::make_unique<files::Removal>(desk.files(), name, folder, desk.guard());
            });
        });
    });
}

} // namespace

int runJobs(const QStringList &arguments)
{
    Call call;
    QCommandLineParser parser;
    if (const auto end = read(call, parser, {tr("Lists the jobs."), {}}, arguments))
        return *end;
    return run(call, [](Desk &desk) {
        list(desk, QStringLiteral("*.JBI"), [&desk](QStringList names) {
            for (QString &name : names)
                name.chop(4);
            printNames(desk, names);
        });
    });
}

int runFiles(const QStringList &arguments)
{
    Call call;
    QCommandLineParser parser;
    const QCommandLineOption to {QStringLiteral("to"), tr("The folder for what comes; for rm, for the copies."),
        QStringLiteral("DIR"), QStringLiteral(".")};
    const QCommandLineOption replace {QStringLiteral("replace"), tr("put: replace what the controller has.")};
    const VerbHelp help {
        tr("Lists, reads, sends and deletes files. Sent files are read back; before a file is deleted, a "
           "copy is written here."),
        QStringLiteral("ls [PATTERN] | get NAME… | put FILE… | rm NAME…"), {to, replace}};
    if (const auto end = read(call, parser, help, arguments))
        return *end;
    const QString what = call.words.value(0);
    const QStringList words = call.words.mid(1);
    if (what == u"ls" && words.size() <= 1)
        return run(call, [words](Desk &desk) {
            list(desk, words.value(0, QStringLiteral("*")),
                [&desk](const QStringList &names) { printNames(desk, names); });
        });
    if (words.isEmpty())
        return mistake(tr("Say “ls”, “get NAME…”, “put FILE…” or “rm NAME…”."));
    if (what == u"get")
        return get(call, words, parser.value(to));
    if (what == u"put")
        return put(call, words, parser.isSet(replace));
    if (what == u"rm")
        return rm(call, words, parser.value(to));
    return mistake(tr("Say “ls”, “get NAME…”, “put FILE…” or “rm NAME…”."));
}

} // namespace pendeskctl
