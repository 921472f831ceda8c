// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/pages/page.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace models {
class OrderModel;
}

namespace widgets {
class Card;
class Table;
} // namespace widgets

namespace pages {

/// Everything that was tried at the controllers from here, and how it ended.
class JournalPage : public Page
{
    Q_OBJECT

public:
    explicit JournalPage(const Context &context, QWidget *parent = nullptr);

    [[nodiscard]] QList<robot::TopicRange> topics() const override { return {}; }

protected:
    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    /// The journal is this computer's own.
    [[nodiscard]] bool needsLink() const override { return false; }

private:
    [[nodiscard]] QLayout *filters();
    [[nodiscard]] QLayout *tools();
    void fillChoices();
    void applyFilter();
    void showState();
    void showRecord(const QModelIndex &index);
    void exportOrders();

    journal::Store &m_store;
    models::OrderModel *m_model;
    widgets::Card *m_card;
    widgets::Table *m_table;
    QComboBox *m_period;
    QComboBox *m_controller;
    QComboBox *m_action;
    QComboBox *m_outcome;
    QLineEdit *m_search;
    QPushButton *m_copy;
    QPushButton *m_export;
    QLabel *m_state;
    QLabel *m_detail; ///< The chosen record in full.
};

} // namespace pages
