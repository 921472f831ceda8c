// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/files/queuecard.h"

#include "ui/models/queuemodel.h"
#include "ui/pages/files/parts.h"
#include <QHeaderView>
#include <QPushButton>
#include <QTableView>

using files::OperationState;
using files::TransferQueue;

namespace pages {

QueueCard::QueueCard(TransferQueue &queue, const protocol::TextCodec &codec, QWidget *parent)
    : Card(tr("Transfers"), parent),
      m_queue {queue},
      m_table {new QTableView},
      m_cancel {button(tr("Cancel"), "cancelTransfer")},
      m_retry {button(tr("Retry failed"), "retryTransfers")},
      m_clear {button(tr("Clear finished"), "clearTransfers")}
{
    m_table->setModel(new models::QueueModel(queue, codec, m_table));
    dressTable();
    auto *row = new QHBoxLayout;
    row->addStretch();
    for (QPushButton *each : {m_cancel, m_retry, m_clear})
        row->addWidget(each);
    body()->addWidget(m_table, 1);
    body()->addLayout(row);
    connect(m_cancel, &QPushButton::clicked, this, &QueueCard::cancelChosen);
    connect(m_retry, &QPushButton::clicked, &queue, &TransferQueue::retryFailed);
    connect(m_clear, &QPushButton::clicked, &queue, &TransferQueue::clearFinished);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, &QueueCard::updateButtons);
    for (const auto signal : {&TransferQueue::added, &TransferQueue::removed, &TransferQueue::changed})
        connect(&queue, signal, this, &QueueCard::updateButtons);
    updateButtons();
}

void QueueCard::dressTable()
{
    m_table->setObjectName(QStringLiteral("transfers"));
    m_table->setAccessibleName(tr("Transfers"));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setShowGrid(false);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setCornerButtonEnabled(false);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(26);
    QHeaderView *header = m_table->horizontalHeader();
    header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    header->setSectionResizeMode(models::QueueModel::State, QHeaderView::Stretch);
    header->setFont(ui::font(ui::Type::Label));
    header->setHighlightSections(false);
    m_table->setColumnWidth(models::QueueModel::Name, 180);
    m_table->setColumnWidth(models::QueueModel::Direction, 150);
    m_table->setColumnWidth(models::QueueModel::Bytes, 150);
}

void QueueCard::updateButtons()
{
    bool hasFailed = false;
    bool hasFinished = false;
    for (int row = 0; row < m_queue.size(); ++row) {
        const OperationState state = m_queue.at(row).state();
        hasFailed = hasFailed || state == OperationState::Failed || state == OperationState::Cancelled;
        hasFinished = hasFinished || state == OperationState::Done || state == OperationState::Cancelled;
    }
    m_cancel->setEnabled(m_table->selectionModel()->hasSelection());
    m_retry->setEnabled(hasFailed);
    m_clear->setEnabled(hasFinished);
}

void QueueCard::cancelChosen()
{
    for (const QModelIndex &index : m_table->selectionModel()->selectedRows())
        m_queue.cancel(index.row());
}

} // namespace pages
