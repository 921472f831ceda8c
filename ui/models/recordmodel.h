// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "journal/store.h"
#include <QAbstractTableModel>

namespace models {

/// What a model of records tells besides its rows.
class RecordModelBase : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Role {
        SortRole = Qt::UserRole, ///< A number, a time or a text that sorts as the column should.
        ListRole, ///< Of a past alarm: its list, as int.
    };

    using QAbstractTableModel::QAbstractTableModel;

    /// Why the journal did not answer, untranslated; empty if it did.
    [[nodiscard]] QString trouble() const { return m_trouble; }
    [[nodiscard]] bool isLoading() const { return m_isLoading; }

Q_SIGNALS:
    /// isLoading() or trouble() may be another.
    void loadingChanged();

protected:
    void setLoading(bool loading, const QString &trouble = {});

private:
    QString m_trouble;
    bool m_isLoading = false;
};

/// Records of the journal, the newest first. It grows at the top as records come in and at the bottom as somebody
/// scrolls there; rows stay where they are.
template <typename Record> class RecordModel : public RecordModelBase
{
public:
    static constexpr int pageSize = 500;
    /// Asks the journal for records that are newer than an id and older than a cursor.
    using Ask = std::function<void(qint64 newerThan, const journal::Cursor &from, int count, QObject *context,
        journal::Store::Handler<journal::Page<Record>> handler)>;

    using RecordModelBase::RecordModelBase;

    [[nodiscard]] const QList<Record> &records() const { return m_records; }
    [[nodiscard]] const Record &at(int row) const { return m_records[row]; }

    /// Shows what `ask` finds instead of what was shown.
    void load(Ask ask)
    {
        m_ask = std::move(ask);
        m_context = std::make_unique<QObject>();
        m_newest = 0;
        m_next = journal::Cursor {};
        removeRows(0, int(m_records.size()));
        loadMore();
    }

    /// Adds what came into the journal since.
    void refresh()
    {
        m_isRefreshDue = isLoading();
        if (!m_ask || m_isRefreshDue)
            return;
        if (m_newest == 0)
            return load(m_ask);
        setLoading(true);
        m_ask(m_newest, {}, mostAtOnce, m_context.get(), [this](const auto &page) { onNewer(page); });
    }

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override
    {
        return parent.isValid() ? 0 : int(m_records.size());
    }
    [[nodiscard]] bool canFetchMore(const QModelIndex &) const override { return m_next && !isLoading(); }
    void fetchMore(const QModelIndex &parent) override
    {
        if (canFetchMore(parent))
            loadMore();
    }

private:
    static constexpr int mostAtOnce = 100'000;

    bool removeRows(int row, int count, const QModelIndex & = {}) override
    {
        if (count == 0)
            return false;
        beginRemoveRows({}, row, row + count - 1);
        m_records.remove(row, count);
        endRemoveRows();
        return true;
    }

    void insert(int row, const QList<Record> &records)
    {
        if (records.isEmpty())
            return;
        beginInsertRows({}, row, row + int(records.size()) - 1);
        m_records = m_records.first(row) + records + m_records.sliced(row);
        endInsertRows();
    }

    void loadMore()
    {
        if (!m_ask || !m_next)
            return;
        setLoading(true);
        m_ask(0, *m_next, pageSize, m_context.get(), [this](const auto &page) { onOlder(page); });
    }

    void onOlder(const values::Result<journal::Page<Record>> &page)
    {
        if (page) {
            m_next = page->next;
            m_newest = std::max(m_newest, page->newest);
            insert(int(m_records.size()), page->records);
        }
        finish(page);
    }

    void onNewer(const values::Result<journal::Page<Record>> &page)
    {
        if (page) {
            m_newest = std::max(m_newest, page->newest);
            insert(0, page->records);
        }
        finish(page);
    }

    void finish(const values::Result<journal::Page<Record>> &page)
    {
        setLoading(false, page ? QString() : page.error().detail);
        if (m_isRefreshDue)
            refresh();
    }

    QList<Record> m_records;
    Ask m_ask;
    std::unique_ptr<QObject> m_context; ///< Of the question under way; another filter ends it.
    std::optional<journal::Cursor> m_next; ///< Where older records begin.
    qint64 m_newest = 0;
    bool m_isRefreshDue = false;
};

} // namespace models
