// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "trend/recorder.h"
#include "ui/widgets/dialogsheet.h"

class QLineEdit;
class QListView;

namespace models {
class SignalFilter;
class SignalListModel;
} // namespace models

namespace dialogs {

/// Finds a number by its name and adds it to the trend. It stays open for the next one. Not modal.
class SignalPicker : public widgets::DialogSheet
{
    Q_OBJECT

public:
    /// `recorder` must outlive the dialog.
    SignalPicker(trend::Recorder &recorder, const protocol::Dialect &dialect, QWidget *parent = nullptr);

    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void addCurrent();
    void search(const QString &text);

    trend::Recorder &m_recorder;
    models::SignalListModel *m_model;
    models::SignalFilter *m_filter;
    QLineEdit *m_search;
    QListView *m_list;
};

} // namespace dialogs
