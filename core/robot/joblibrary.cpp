// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/joblibrary.h"

#include "session/filesession.h"
#include <algorithm>

using values::Error;
using values::ErrorKind;
using values::FileName;
using values::Result;

namespace robot {

namespace {

Error noLink() { return {ErrorKind::NotSent, 0, 0, {}}; }

} // namespace

JobLibrary::JobLibrary(Orders &orders, QObject *parent) : QObject {parent}, m_orders {orders}
{
    connect(&orders, &Orders::situationChanged, this, &JobLibrary::onSituationChanged);
    connect(&orders, &Orders::linkDropped, this, &JobLibrary::onLinkDropped);
}

const JobLibrary::Copy &JobLibrary::copy(const FileName &job) const
{
    static const Copy none;
    const auto found = m_copies.find(job);
    return found == m_copies.end() ? none : found->second;
}

void JobLibrary::readList()
{
    if (m_isListing)
        return;
    session::FileSession *files = m_orders.controller().files();
    if (!files)
        return onList(tl::unexpected(noLink()));
    m_isListing = true;
    Q_EMIT listChanged();
    files->list("*.JBI", this, [this](const Result<protocol::FileList> &list) {
        onList(list.map([](const protocol::FileList &found) { return found.names; }));
    });
}

void JobLibrary::onList(const Result<QList<FileName>> &names)
{
    m_isListing = false;
    m_listTrouble.reset();
    if (names) {
        QList<FileName> sorted = *names;
        std::ranges::sort(sorted);
        sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
        m_list.take(sorted, now());
        m_isListOld = false;
    } else {
        m_listTrouble = names.error();
    }
    Q_EMIT listChanged();
}

void JobLibrary::readText(const FileName &job)
{
    Copy &copy = m_copies[job];
    if (copy.isReading)
        return;
    session::FileSession *files = m_orders.controller().files();
    if (!files)
        return onText(job, tl::unexpected(noLink()));
    copy.isReading = true;
    Q_EMIT copyChanged(job);
    files->save(job, this, [this, job](const Result<QByteArray> &text) { onText(job, text); });
}

void JobLibrary::onText(const FileName &job, const Result<QByteArray> &text)
{
    Copy &copy = m_copies[job];
    copy.isReading = false;
    copy.trouble.reset();
    if (text) {
        copy.text.take(*text, now());
        copy.mayBeOld = false;
    } else {
        copy.trouble = text.error();
    }
    Q_EMIT copyChanged(job);
}

/// In TEACH a person may edit at the pendant.
void JobLibrary::onSituationChanged()
{
    const auto &status = m_orders.situation().status;
    if (status && status->isTeach())
        markOld();
}

void JobLibrary::onLinkDropped()
{
    m_isListOld = m_list.value.has_value();
    if (std::exchange(m_isListing, false)) // its answer went with the link
        m_listTrouble = noLink();
    markOld();
    Q_EMIT listChanged();
}

void JobLibrary::markOld()
{
    const bool hasLink = m_orders.situation().isLinkUp;
    for (auto &[job, copy] : m_copies) {
        const bool wasReading = !hasLink && std::exchange(copy.isReading, false);
        if (copy.text.value.has_value() == copy.mayBeOld && !wasReading)
            continue;
        copy.mayBeOld = copy.text.value.has_value();
        Q_EMIT copyChanged(job);
    }
}

} // namespace robot
