// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/text.h"
#include "values/filename.h"
#include <QAbstractListModel>
#include <QSet>
#include <QSortFilterProxyModel>

namespace models {

/// The jobs on a controller by name. Rows change in place, so that selection and scroll survive a new list.
class JobListModel : public QAbstractListModel
{
    Q_OBJECT

public:
    enum Role { FavouriteRole = Qt::UserRole, NameRole };

    explicit JobListModel(protocol::Encoding encoding, QObject *parent = nullptr);

    /// `jobs` in the order of their bytes, none twice.
    void setJobs(const QList<values::FileName> &jobs);
    /// The job that is being executed, without extension; empty for none.
    void setExecuting(const QByteArray &job);
    void setFavourite(int row, bool isFavourite);
    /// Names without extension, as the controller writes them.
    void setFavourites(const QSet<QByteArray> &favourites);
    [[nodiscard]] const QSet<QByteArray> &favourites() const { return m_favourites; }

    [[nodiscard]] const values::FileName &job(int row) const { return m_jobs[row]; }
    /// -1 if it is not in the list.
    [[nodiscard]] int rowOf(QByteArrayView base) const;
    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;

Q_SIGNALS:
    void favouritesChanged();

private:
    [[nodiscard]] QString name(int row) const;
    [[nodiscard]] QByteArray base(int row) const { return m_jobs[row].base().toByteArray(); }
    void announce(int row);

    protocol::TextCodec m_codec;
    QList<values::FileName> m_jobs;
    QSet<QByteArray> m_favourites;
    QByteArray m_executing;
};

/// Favourites first, then by name; those that contain what was typed.
class JobFilter : public QSortFilterProxyModel
{
    Q_OBJECT

public:
    explicit JobFilter(JobListModel *jobs, QObject *parent = nullptr);

    void setText(const QString &text);

protected:
    [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex &parent) const override;
    [[nodiscard]] bool lessThan(const QModelIndex &left, const QModelIndex &right) const override;

private:
    QString m_text;
};

} // namespace models
