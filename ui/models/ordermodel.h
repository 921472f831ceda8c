// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/models/recordmodel.h"

namespace models {

/// Everything that was tried, as the journal has it.
class OrderModel : public RecordModel<journal::OrderRecord>
{
    Q_OBJECT

public:
    enum Column { Time, Controller, Action, Subject, Change, Outcome, Reply, User, Host, Level, Duration, columns };

    /// `store` must outlive the model.
    explicit OrderModel(journal::Store &store, QObject *parent = nullptr);

    void setFilter(const journal::OrderFilter &filter);
    [[nodiscard]] const journal::OrderFilter &filter() const { return m_filter; }

    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;

private:
    journal::Store &m_store;
    journal::OrderFilter m_filter;
};

} // namespace models
