// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/joblibrary.h"
#include "ui/models/joblistmodel.h"
#include "ui/pages/page.h"
#include "ui/widgets/card.h"

class QLineEdit;
class QListView;
class QPushButton;

namespace pages {

/// The jobs on the controller: what is typed filters them, favourites stand first.
class JobListCard : public widgets::Card
{
    Q_OBJECT

public:
    /// `library` must outlive the card.
    JobListCard(const Context &context, robot::JobLibrary &library, QWidget *parent = nullptr);

    /// Makes it the current one if it is in the list and not filtered away.
    void choose(QByteArrayView base);
    [[nodiscard]] models::JobListModel &model() { return *m_model; }

Q_SIGNALS:
    void chosen(const values::FileName &job);

private:
    void makeWidgets();
    void showList();
    void showExecuting();
    void onCurrentChanged(const QModelIndex &current);
    void toggleFavourite();
    [[nodiscard]] QString note() const;
    [[nodiscard]] QString age() const;

    const robot::RobotState &m_state;
    robot::JobLibrary &m_library;
    models::JobListModel *m_model;
    models::JobFilter *m_filter;
    QLineEdit *m_text;
    QListView *m_view;
    QLabel *m_empty;
    QPushButton *m_favourite;
    QPushButton *m_read;
};

} // namespace pages
