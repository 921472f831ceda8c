// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/alarmlog.h"
#include "ui/widgets/card.h"

class QComboBox;
class QLineEdit;
class QPushButton;
class QTabWidget;

namespace models {
class AlarmHistoryFilter;
class AlarmHistoryModel;
class CodeStatisticsModel;
} // namespace models

namespace widgets {
class Table;
}

namespace pages {

class AlarmNotes;

/// Past alarms of the controller as the journal has them, what comes most often, and what people noted.
class AlarmHistoryCard : public widgets::Card
{
    Q_OBJECT

public:
    /// All of them must outlive the card.
    AlarmHistoryCard(
        robot::AlarmLog &log, journal::Store &store, const settings::Profile &profile, QWidget *parent = nullptr);

    /// The note of this code is shown.
    void chooseCode(quint32 code);

private:
    [[nodiscard]] QWidget *historyTab();
    [[nodiscard]] QLayout *tools();
    [[nodiscard]] QWidget *statisticsTab();
    void refresh();
    void showReading();
    void loadAll();
    void exportHistory();
    [[nodiscard]] std::optional<values::AlarmHistoryClass> chosenList() const;

    robot::AlarmLog &m_log;
    journal::Store &m_store;
    const settings::Profile &m_profile;
    models::AlarmHistoryModel *m_model;
    models::AlarmHistoryFilter *m_filter;
    models::CodeStatisticsModel *m_statistics;
    QTabWidget *m_tabs;
    widgets::Table *m_table;
    QComboBox *m_list;
    QLineEdit *m_search;
    QLabel *m_state;
    QLabel *m_exported; ///< How the last export ended.
    QPushButton *m_read;
    QPushButton *m_copy;
    QPushButton *m_export;
    AlarmNotes *m_notes;
};

} // namespace pages
