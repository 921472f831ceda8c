// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/files/filepane.h"

#include "ui/widgets/rowdelegate.h"
#include <QDropEvent>
#include <QListWidget>

namespace pages {

namespace {

constexpr int keyRole = Qt::UserRole;

} // namespace

FilePane::FilePane(const QString &title, const QString &name, QWidget *parent)
    : Card(title, parent), m_tools {new QHBoxLayout}, m_list {new QListWidget}
{
    body()->addLayout(m_tools);
    body()->addWidget(m_list, 1);
    m_list->setObjectName(name);
    m_list->setAccessibleName(title);
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setUniformItemSizes(true);
    widgets::RowDelegate::dress(m_list);
    m_list->setDragDropMode(QAbstractItemView::DragDrop);
    m_list->setDefaultDropAction(Qt::CopyAction);
    m_list->viewport()->installEventFilter(this);
    connect(m_list, &QListWidget::itemSelectionChanged, this, &FilePane::chosenChanged);
    connect(m_list, &QListWidget::itemActivated, this,
        [this](const QListWidgetItem *item) { Q_EMIT activated(item->data(keyRole).toByteArray()); });
}

/// Nothing is put into the list itself: the files are sent, and show up when they have arrived.
bool FilePane::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Drop) {
        auto *drop = static_cast<QDropEvent *>(event);
        if (drop->source() && drop->source() != m_list) {
            drop->setDropAction(Qt::CopyAction);
            drop->accept();
            Q_EMIT dropped();
        }
        return true;
    }
    return Card::eventFilter(watched, event);
}

void FilePane::showFiles(const QList<QByteArray> &keys, const QStringList &words)
{
    for (int row = m_list->count() - 1; row >= 0; --row) {
        if (!keys.contains(m_list->item(row)->data(keyRole).toByteArray()))
            delete m_list->takeItem(row);
    }
    for (int row = 0; row < keys.size(); ++row) {
        const auto *item = m_list->item(row);
        if (item && item->data(keyRole).toByteArray() == keys[row])
            continue;
        auto *added = new QListWidgetItem(words[row]);
        added->setData(keyRole, keys[row]);
        m_list->insertItem(row, added);
    }
    setNote(tr("%n file(s)", nullptr, int(keys.size())));
}

void FilePane::setStale(bool isStale) { widgets::setTextRole(m_list, isStale ? ui::Role::Text3 : ui::Role::Text1); }

QList<QByteArray> FilePane::chosen() const
{
    QList<QByteArray> keys;
    for (const QListWidgetItem *item : m_list->selectedItems())
        keys << item->data(keyRole).toByteArray();
    return keys;
}

} // namespace pages
