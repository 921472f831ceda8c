// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "trend/signal.h"
#include <QAbstractListModel>
#include <QSortFilterProxyModel>

namespace models {

/// Signals with their labels, for a picker. It does not change.
class SignalListModel : public QAbstractListModel
{
    Q_OBJECT

public:
    SignalListModel(const QList<trend::Signal> &list, const QStringList &labels, QObject *parent = nullptr);

    [[nodiscard]] const trend::Signal &signalOf(int row) const { return m_signals[row]; }
    [[nodiscard]] const QString &label(int row) const { return m_labels[row]; }

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;

private:
    QList<trend::Signal> m_signals;
    QStringList m_labels;
};

/// The rows whose label holds every word of a search, in any order and case.
class SignalFilter : public QSortFilterProxyModel
{
    Q_OBJECT

public:
    SignalFilter(SignalListModel &source, QObject *parent);

    void search(const QString &text);

protected:
    [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex &parent) const override;

private:
    const SignalListModel &m_source;
    QStringList m_words;
};

} // namespace models
