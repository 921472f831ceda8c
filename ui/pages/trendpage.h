// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "disk/worker.h"
#include "trend/recorder.h"
#include "ui/pages/page.h"
#include <QTimer>

class QComboBox;
class QLabel;
class QListView;
class QPushButton;
class QTableView;

namespace models {
class IncidentModel;
class TrackModel;
} // namespace models

namespace widgets {
class Card;
class Plot;
} // namespace widgets

namespace pages {

/// Any number over time. It shows what the recorder has, streaming or paused, or an incident that was kept. Signals
/// come by drag, by the context menu of a number, or from the picker.
class TrendPage : public Page
{
    Q_OBJECT

public:
    explicit TrendPage(const Context &context, QWidget *parent = nullptr);
    ~TrendPage() override;

    [[nodiscard]] QList<robot::TopicRange> topics() const override;
    void showLink(const ui::LinkView &link) override;

    void openIncident(const trend::IncidentEntry &entry);
    void showIncident(trend::Incident incident);
    void backToLive();
    /// Writes what is in view as CSV.
    [[nodiscard]] values::Result<void> exportTo(const QString &path) const;

protected:
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    [[nodiscard]] QWidget *toolBar();
    [[nodiscard]] QWidget *plotCard();
    [[nodiscard]] QWidget *trackCard();
    [[nodiscard]] QWidget *incidentCard();
    void follow();
    void setTracks();
    void setPaused(bool paused);
    void refresh();
    void refreshNote();
    void pick();
    void removeSelected();
    void chooseFile();
    [[nodiscard]] trend::Range range() const;

    trend::Recorder &m_recorder;
    const settings::Profile &m_profile;
    std::optional<trend::Incident> m_incident; ///< Shown instead of the recorder's tracks.
    std::optional<trend::Moment> m_pausedAt;
    bool m_isLinkUp = false;
    models::TrackModel *m_model;
    disk::Worker m_disk;
    models::IncidentModel *m_incidents;
    widgets::Plot *m_plot;
    widgets::Card *m_card;
    QLabel *m_hint;
    QComboBox *m_span;
    QPushButton *m_pause;
    QPushButton *m_live;
    QTableView *m_table;
    QListView *m_list;
    QTimer m_pace;
};

} // namespace pages
