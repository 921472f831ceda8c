// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/models/joblistmodel.h"

#include "ui/words.h"
#include <QSize>
#include <algorithm>

namespace models {

using values::FileName;

namespace {

constexpr int rowHeight = 26;

} // namespace

JobListModel::JobListModel(protocol::Encoding encoding, QObject *parent)
    : QAbstractListModel(parent), m_codec {encoding}
{
}

/// Both lists are sorted: what is gone is taken out, then what is new is put in.
void JobListModel::setJobs(const QList<FileName> &jobs)
{
    for (int row = int(m_jobs.size()) - 1; row >= 0; --row) {
        if (std::ranges::binary_search(jobs, m_jobs[row]))
            continue;
        beginRemoveRows({}, row, row);
        m_jobs.removeAt(row);
        endRemoveRows();
    }
    for (int row = 0; row < jobs.size(); ++row) {
        if (row < m_jobs.size() && m_jobs[row] == jobs[row])
            continue;
        beginInsertRows({}, row, row);
        m_jobs.insert(row, jobs[row]);
        endInsertRows();
    }
}

void JobListModel::setExecuting(const QByteArray &job)
{
    if (job == m_executing)
        return;
    const QByteArray before = std::exchange(m_executing, job);
    announce(rowOf(before));
    announce(rowOf(job));
}

void JobListModel::setFavourite(int row, bool isFavourite)
{
    if (isFavourite)
        m_favourites.insert(base(row));
    else
        m_favourites.remove(base(row));
    announce(row);
    Q_EMIT favouritesChanged();
}

void JobListModel::setFavourites(const QSet<QByteArray> &favourites)
{
    m_favourites = favourites;
    if (!m_jobs.isEmpty())
        Q_EMIT dataChanged(index(0), index(int(m_jobs.size()) - 1));
}

int JobListModel::rowOf(QByteArrayView base) const
{
    const auto found = std::ranges::find_if(m_jobs, [&](const FileName &job) { return job.base() == base; });
    return found == m_jobs.end() ? -1 : int(found - m_jobs.begin());
}

int JobListModel::rowCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : int(m_jobs.size()); }

QString JobListModel::name(int row) const { return ui::controllerText(m_jobs[row].base(), m_codec.encoding()); }

QVariant JobListModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const bool isFavourite = m_favourites.contains(base(index.row()));
    const bool isExecuting = base(index.row()) == m_executing;
    const QString text = name(index.row());
    switch (role) {
    case Qt::DisplayRole: return (isFavourite ? QStringLiteral("★ ") : QString()) + text;
    case NameRole: return text;
    case FavouriteRole: return isFavourite;
    case Qt::ToolTipRole:
        if (isExecuting)
            return tr("%1 is being executed.").arg(text);
        return text;
    case Qt::SizeHintRole: return QSize(0, rowHeight);
    case Qt::AccessibleTextRole: return isFavourite ? tr("%1, favourite").arg(text) : text;
    case Qt::FontRole: {
        QFont font = ui::font(ui::Type::Body);
        font.setBold(isExecuting);
        return font;
    }
    default: return {};
    }
}

void JobListModel::announce(int row)
{
    if (row >= 0)
        Q_EMIT dataChanged(index(row), index(row));
}

JobFilter::JobFilter(JobListModel *jobs, QObject *parent) : QSortFilterProxyModel(parent)
{
    setSourceModel(jobs);
    setDynamicSortFilter(true);
    sort(0);
}

void JobFilter::setText(const QString &text)
{
    m_text = text.trimmed();
    invalidateFilter();
}

bool JobFilter::filterAcceptsRow(int row, const QModelIndex &parent) const
{
    const QString name = sourceModel()->index(row, 0, parent).data(JobListModel::NameRole).toString();
    return name.contains(m_text, Qt::CaseInsensitive);
}

bool JobFilter::lessThan(const QModelIndex &left, const QModelIndex &right) const
{
    const bool isLeftFirst = left.data(JobListModel::FavouriteRole).toBool();
    if (isLeftFirst != right.data(JobListModel::FavouriteRole).toBool())
        return isLeftFirst;
    return left.data(JobListModel::NameRole).toString() < right.data(JobListModel::NameRole).toString();
}

} // namespace models
