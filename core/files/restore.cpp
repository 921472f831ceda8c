// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/restore.h"

#include "cellfiles/filetypes.h"
#include <QCoreApplication>
#include <algorithm>
#include <set>

using values::Error;
using values::ErrorKind;
using values::FileName;
using values::Result;

namespace files {

namespace {

struct RestoreTexts {
    Q_DECLARE_TR_FUNCTIONS(files::Restore)
};

/// Why a file of the bag must not be sent; empty if nothing stands against it.
QString obstacle(const FileName &name, const FileSet &bag, Change change, const RestoreWish &wish)
{
    const cellfiles::FileType &type = cellfiles::fileTypeOf(name.bytes());
    if (!bag.hashes.contains(name))
        return RestoreTexts::tr("It is not in the backup.");
    if (type.restore == cellfiles::Restore::Never)
        return RestoreTexts::tr("It belongs to this one controller, or only tells what happened: it is never sent.");
    if (wish.isAnotherRobot && (wish.names.isEmpty() || type.restore != cellfiles::Restore::Allowed || type.step > 3))
        return RestoreTexts::tr("It comes from another robot.");
    if (change == Change::Unread)
        return RestoreTexts::tr("What the controller has could not be read.");
    const auto content = bag.content(name);
    if (!content)
        return RestoreTexts::tr("In the backup it is not as it was written.");
    for (const inform::Finding &finding : preflight(name, *content, wish.jobsInUse)) {
        if (finding.isError())
            return explain(finding, protocol::TextCodec {});
    }
    return {};
}

RestoreItem itemOf(const FileName &name, Change change, const FileSet &bag, const RestoreWish &wish)
{
    if (change == Change::Same || change == Change::OnlyNoise)
        return {name, RestoreStep::Same};
    const QString reason = obstacle(name, bag, change, wish);
    if (!reason.isEmpty())
        return {name, RestoreStep::NotAllowed, reason};
    RestoreItem item {name, change == Change::Gone ? RestoreStep::New : RestoreStep::Changed};
    item.needsCare = cellfiles::fileTypeOf(name.bytes()).restore == cellfiles::Restore::Care && wish.names.isEmpty();
    if (item.needsCare)
        item.reason =
            RestoreTexts::tr("It changes how the robot moves, or what protects people: look at the differences "
                             "and choose it.");
    return item;
}

/// The jobs that a job calls.
QByteArrayList callsOf(const QByteArray &job)
{
    constexpr QByteArrayView call = "CALL JOB:";
    QByteArrayList names;
    for (qsizetype at = job.indexOf(call); at >= 0; at = job.indexOf(call, at + 1)) {
        const QByteArrayView rest = QByteArrayView {job}.sliced(at + call.size());
        const auto end = std::ranges::find_if(rest, [](char c) { return c == ' ' || c == '\r' || c == '\n'; });
        names << rest.first(end - rest.begin()).toByteArray();
    }
    return names;
}

/// Puts called jobs before their callers, in the order of their names otherwise. Circles end where they began.
class CallOrder
{
public:
    explicit CallOrder(const FileSet &bag) : m_bag {bag} { }

    /// A number for each job that is wanted; lower ones are sent first.
    [[nodiscard]] std::map<FileName, int> ranks(const QList<FileName> &names)
    {
        for (const FileName &name : names) {
            if (isJobFile(name))
                visit(name);
        }
        return m_ranks;
    }

private:
    void visit(const FileName &first)
    {
        // Depth first with a stack of our own: a chain of calls may be as long as there are jobs.
        std::vector<FileName> stack {first};
        while (!stack.empty()) {
            const FileName name = stack.back();
            const bool isNew = m_seen.insert(name).second;
            const auto before = stack.size();
            if (isNew)
                pushCalled(name, stack);
            if (stack.size() > before)
                continue;
            stack.pop_back();
            m_ranks.try_emplace(name, int(m_ranks.size()));
        }
    }

    void pushCalled(const FileName &name, std::vector<FileName> &stack)
    {
        const auto content = m_bag.hashes.contains(name) ? m_bag.content(name) : Result<QByteArray> {QByteArray {}};
        for (const QByteArray &called : callsOf(content.value_or(QByteArray {}))) {
            const auto file = FileName::create(called + ".JBI");
            if (file && m_bag.hashes.contains(*file) && !m_seen.contains(*file))
                stack.push_back(*file);
        }
    }

    const FileSet &m_bag;
    std::set<FileName> m_seen;
    std::map<FileName, int> m_ranks;
};

/// In the order in which they are sent.
QList<FileName> ordered(QList<FileName> names, const FileSet &bag)
{
    const auto ranks = CallOrder {bag}.ranks(names);
    const auto key = [&](const FileName &name) {
        const auto rank = ranks.find(name);
        return std::pair {cellfiles::fileTypeOf(name.bytes()).step, rank == ranks.end() ? 0 : rank->second};
    };
    std::ranges::stable_sort(names, {}, key);
    return names;
}

bool isGood(ReadBack readBack) { return readBack == ReadBack::Identical || readBack == ReadBack::Reformatted; }

} // namespace

QList<RestoreItem> planRestore(const FileSet &bag, const FileSet &controller, const RestoreWish &wish)
{
    std::map<FileName, Change> changes;
    // What a controller reformats by itself. Times of day within data are data.
    const NoiseFilter reformatting {
        {QStringLiteral("job-dates"), QStringLiteral("blanks"), QStringLiteral("line-ends")}};
    for (const FileChange &change : compare(bag, controller, reformatting))
        changes[change.name] = change.change;
    QList<FileName> wanted = wish.names;
    if (wanted.isEmpty()) {
        for (const auto &[name, hash] : bag.hashes)
            wanted << name;
    }
    QList<RestoreItem> plan;
    for (const FileName &name : ordered(wanted, bag)) {
        const auto change = changes.find(name);
        plan << itemOf(name, change == changes.end() ? Change::Unread : change->second, bag, wish);
    }
    return plan;
}

Restore::Restore(session::FileSession &session, FileSet bag, QList<RestoreItem> plan, BackupOrder freshBackup,
    Guard guard, QObject *parent)
    : Operation {parent},
      m_bag {std::move(bag)},
      m_plan {std::move(plan)},
      m_guard {std::move(guard)},
      m_backup {session, std::move(freshBackup)}
{
    m_files = &session;
    connect(&m_backup, &Operation::progressed, this, &Operation::progressed);
    connect(&m_backup, &Operation::finished, this, &Restore::onBackedUp);
}

int Restore::filesTotal() const { return int(std::ranges::count_if(m_plan, &RestoreItem::isSent)); }

std::optional<FileName> Restore::current() const { return m_upload ? std::optional {m_upload->name()} : std::nullopt; }

void Restore::run()
{
    m_next = 0;
    m_done = 0;
    m_refusals.clear();
    m_guard(this, [this](const Result<void> &permission) {
        if (!permission)
            return finish(permission);
        m_backup.reset();
        m_backup.start();
    });
}

void Restore::interrupt()
{
    m_backup.cancel();
    if (m_upload)
        m_upload->cancel();
}

void Restore::onBackedUp()
{
    if (m_backup.state() != OperationState::Done)
        return finish(tl::unexpected(m_backup.error().value_or(Error {ErrorKind::Cancelled})));
    const auto bag = Bag::open(m_backup.path());
    if (!bag)
        return finish(tl::unexpected(bag.error()));
    m_before = bag->files();
    if (isCancelling())
        return finish(values::failure(ErrorKind::Cancelled));
    if (!isStillAsPlanned())
        return finish(values::failure(
            ErrorKind::NotSent, QStringLiteral("the controller's files have changed since the plan was made")));
    sendNext();
}

bool Restore::isStillAsPlanned() const
{
    return std::ranges::all_of(m_plan, [this](const RestoreItem &item) {
        const bool isThere = m_before.hashes.contains(item.name);
        const bool isKnown = isThere || !m_before.unread.contains(item.name);
        const bool shouldBeThere = item.step != RestoreStep::New;
        return !item.isSent()
            || (isKnown && isThere == shouldBeThere
                && (!isThere || m_before.hashes.at(item.name) != m_bag.hashes.at(item.name)));
    });
}

void Restore::sendNext()
{
    const auto next = std::find_if(m_plan.begin() + m_next, m_plan.end(), std::mem_fn(&RestoreItem::isSent));
    m_next = int(next - m_plan.begin());
    m_upload.reset();
    if (next == m_plan.end())
        return m_refusals.isEmpty() ? finish({}) : finish(tl::unexpected(*m_refusals.first().error));
    if (isCancelling())
        return finish(values::failure(ErrorKind::Cancelled));
    if (!m_files)
        return finish(values::failure(ErrorKind::NotSent, QStringLiteral("the link was closed")));
    const auto content = m_bag.content(next->name);
    if (!content)
        return finish(tl::unexpected(content.error()));
    m_upload = std::make_unique<Upload>(*m_files, next->name, *content, m_guard);
    connect(m_upload.get(), &Operation::progressed, this, &Operation::progressed);
    connect(m_upload.get(), &Operation::finished, this, &Restore::onSent, Qt::QueuedConnection);
    m_upload->start();
}

void Restore::onSent()
{
    Q_EMIT tried(m_upload.get());
    if (m_upload->state() == OperationState::Cancelled)
        return finish(values::failure(ErrorKind::Cancelled));
    if (m_upload->error() && m_upload->error()->kind == ErrorKind::Refused) {
        m_refusals << FileResult {m_upload->name().bytes(), m_upload->error()};
        return goOn();
    }
    if (m_upload->error())
        return finish(tl::unexpected(*m_upload->error()));
    if (!isGood(m_upload->readBack()))
        return finish(values::failure(ErrorKind::Malformed,
            m_upload->readBack() == ReadBack::Different
                ? QStringLiteral("the controller gave another file back than it was sent")
                : QStringLiteral("the file could not be read back")));
    ++m_done;
    goOn();
}

void Restore::goOn()
{
    ++m_next;
    Q_EMIT progressed();
    sendNext();
}

bool Restore::canPutBack() const
{
    return isOver() && state() != OperationState::Done && m_upload && m_before.hashes.contains(m_upload->name());
}

std::unique_ptr<Upload> Restore::putBack() const
{
    const auto content = canPutBack() && m_files ? m_before.content(m_upload->name())
                                                 : Result<QByteArray> {values::failure(ErrorKind::LocalFile)};
    return content ? std::make_unique<Upload>(*m_files, m_upload->name(), *content, m_guard) : nullptr;
}

} // namespace files
