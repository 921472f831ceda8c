// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/collection.h"

#include <algorithm>

using values::Error;
using values::ErrorKind;
using values::FileName;
using values::Result;

namespace files {

namespace {

constexpr int maxSilences = 5; ///< After that nobody is there any more.

constexpr QByteArrayView allParameters = "ALL.PRM";

/// The order in which files are read: every transfer is an entry in the controller's log, so the log comes first; what
/// takes longest comes last (controller files reference §13).
int readingRank(const FileName &name)
{
    constexpr std::array<QByteArrayView, 3> first {"LOGDATA.DAT", "ALMHIST.DAT", "SYSTEM.SYS"};
    constexpr std::array<QByteArrayView, 6> types {"JBI", "CND", "DAT", "LST", "SYS", "PRM"};
    const auto early = std::ranges::find(first, QByteArrayView {name.bytes()});
    if (early != first.end())
        return int(early - first.begin());
    const auto type = std::ranges::find(types, name.extension());
    return int(first.size() + (type - types.begin())) + (QByteArrayView {name.bytes()} == allParameters ? 10 : 0);
}

} // namespace

QByteArrayList Collection::allPatterns() { return {"*.JBI", "*.DAT", "*.CND", "*.PRM", "*.SYS", "*.LST"}; }

Collection::Collection(session::FileSession &session, Sink sink, QObject *parent)
    : Operation {parent}, m_sink {std::move(sink)}
{
    use(session);
}

void Collection::readWhatBackupsHold(bool withAllParameters)
{
    m_unlisted = {"PANELBOX.LOG"};
    m_skipsRepeated = !withAllParameters;
}

void Collection::interrupt()
{
    if (session())
        session()->cancel(m_transfer);
}

void Collection::run()
{
    m_toList = m_patterns;
    m_listed.clear();
    m_toRead.clear();
    m_results.clear();
    m_bytes = 0;
    m_total = 0;
    m_silences = 0;
    listNext();
}

void Collection::note(const QByteArray &name, const std::optional<Error> &error)
{
    m_results << FileResult {name, error};
    Q_EMIT progressed();
}

/// True, after ending everything, if it makes no sense to go on.
bool Collection::isHopeless(const std::optional<Error> &error)
{
    const ErrorKind kind = error.value_or(Error {ErrorKind::Refused}).kind;
    const bool isSilent = kind == ErrorKind::NoAnswer || kind == ErrorKind::Network;
    m_silences = isSilent ? m_silences + 1 : 0;
    if (!isCancelling() && kind != ErrorKind::Cancelled && kind != ErrorKind::LocalFile && m_silences < maxSilences)
        return false;
    finish(tl::unexpected(isCancelling() ? Error {ErrorKind::Cancelled} : *error));
    return true;
}

void Collection::listNext()
{
    if (m_toList.isEmpty())
        return beginReading();
    list(m_toList.takeFirst());
}

void Collection::beginReading()
{
    const auto single = {FileName::create("RC.PRM"), FileName::create("RS.PRM"), FileName::create("SV.PRM")};
    const bool hasSingle = std::ranges::all_of(single, [this](const auto &name) { return m_listed.contains(*name); });
    for (const QByteArray &bytes : m_isListingOnly ? QByteArrayList {} : m_unlisted) {
        const FileName name = *FileName::create(bytes);
        if (!m_filter || m_filter(name))
            m_listed.insert(name);
    }
    if (m_skipsRepeated && hasSingle)
        m_listed.erase(*FileName::create(allParameters));
    m_toRead = {m_listed.begin(), m_listed.end()};
    std::ranges::stable_sort(m_toRead, {}, readingRank);
    const auto isListed = [this](const FileName &name) { return !m_unlisted.contains(name.bytes()); };
    m_total = int(m_results.size() + std::ranges::count_if(m_toRead, isListed));
    readNext();
}

void Collection::list(const QByteArray &pattern)
{
    m_transfer = session()->list(
        pattern, this, [this, pattern](const Result<protocol::FileList> &listed) { takeList(pattern, listed); });
}

void Collection::takeList(const QByteArray &pattern, const Result<protocol::FileList> &listed)
{
    const std::optional<Error> error = listed ? std::nullopt : std::optional {listed.error()};
    if (isHopeless(error))
        return;
    if (isSilence())
        return list(pattern);
    if (error) {
        note(pattern, error);
    } else {
        for (const FileName &name : listed->names) {
            if (!m_filter || m_filter(name))
                m_listed.insert(name);
        }
        for (const QByteArray &name : listed->rejected)
            note(name, Error {ErrorKind::BadInput, 0, 0, {}});
    }
    listNext();
}

void Collection::readNext()
{
    if (m_isListingOnly) {
        for (const FileName &name : m_toRead)
            m_results << FileResult {name.bytes(), {}};
        m_toRead.clear();
    }
    if (m_toRead.isEmpty()) {
        m_current.clear();
        return finish({});
    }
    read(m_toRead.takeFirst());
}

void Collection::read(const FileName &name)
{
    m_current = name.bytes();
    m_transfer =
        session()->save(name, this, [this, name](const Result<QByteArray> &content) { takeFile(name, content); });
}

void Collection::takeFile(const FileName &name, const Result<QByteArray> &content)
{
    const auto taken = content.and_then([&](const QByteArray &bytes) { return m_sink(name, bytes); });
    const std::optional<Error> error = taken ? std::nullopt : std::optional {taken.error()};
    if (isHopeless(error))
        return;
    if (isSilence())
        return read(name);
    const bool isNotOffered = error && error->kind == ErrorKind::Refused && m_unlisted.contains(name.bytes());
    m_bytes += content ? content->size() : 0;
    if (!isNotOffered) {
        m_total += m_unlisted.contains(name.bytes()) ? 1 : 0;
        note(name.bytes(), error);
    }
    readNext();
}

Snapshot::Snapshot(session::FileSession &session, QObject *parent)
    : Collection {session,
        [this](const FileName &name, const QByteArray &content) -> Result<void> {
            m_contents[name] = content;
            return {};
        },
        parent}
{
    readWhatBackupsHold();
}

FileSet Snapshot::files() const
{
    FileSet set = fileSetOf(m_contents);
    markUnread(set, results());
    return set;
}

} // namespace files
