// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/queue.h"
#include "protocol/text.h"
#include "ui/widgets/card.h"

class QPushButton;
class QTableView;

namespace pages {

/// The transfers with their progress, and what can be done about them.
class QueueCard : public widgets::Card
{
    Q_OBJECT

public:
    /// `queue` must outlive it.
    QueueCard(files::TransferQueue &queue, const protocol::TextCodec &codec, QWidget *parent = nullptr);

private:
    void dressTable();
    void updateButtons();
    void cancelChosen();

    files::TransferQueue &m_queue;
    QTableView *m_table;
    QPushButton *m_cancel;
    QPushButton *m_retry;
    QPushButton *m_clear;
};

} // namespace pages
