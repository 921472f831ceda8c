// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/models/signallistmodel.h"

#include "ui/widgets/plottable.h"
#include <algorithm>

namespace models {

SignalListModel::SignalListModel(const QList<trend::Signal> &list, const QStringList &labels, QObject *parent)
    : QAbstractListModel(parent), m_signals {list}, m_labels {labels}
{
    Q_ASSERT(list.size() == labels.size());
}

int SignalListModel::rowCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : int(m_signals.size()); }

QVariant SignalListModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    if (role == Qt::DisplayRole)
        return m_labels[index.row()];
    return role == widgets::signalRole ? QVariant(trend::key(m_signals[index.row()])) : QVariant();
}

SignalFilter::SignalFilter(SignalListModel &source, QObject *parent) : QSortFilterProxyModel(parent), m_source {source}
{
    setSourceModel(&source);
}

void SignalFilter::search(const QString &text)
{
    m_words = text.split(u' ', Qt::SkipEmptyParts);
    invalidateFilter();
}

bool SignalFilter::filterAcceptsRow(int row, const QModelIndex &) const
{
    return std::ranges::all_of(
        m_words, [&](const QString &word) { return m_source.label(row).contains(word, Qt::CaseInsensitive); });
}

} // namespace models
