// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "disk/worker.h"
#include "files/compare.h"
#include "ui/pages/page.h"

class QComboBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace widgets {
class OrderButton;
}

namespace pages {

class ComparisonCard;
class Timeline;

/// The backups of a controller as a timeline; what differs between two of them, or between one and the controller; and
/// the way back.
class BackupPage : public Page
{
    Q_OBJECT

public:
    explicit BackupPage(const Context &context, QWidget *parent = nullptr);

    [[nodiscard]] QList<robot::TopicRange> topics() const override;
    void showLink(const ui::LinkView &link) override;

    /// The folder of all backups, from now on and after a restart.
    void setRoot(const QString &root);
    /// Reads the folder again.
    void reload();
    /// Packs the chosen backup into one .zip file.
    void exportTo(const QString &target);

protected:
    /// The backups of a known controller can be looked at without it.
    [[nodiscard]] bool needsLink() const override { return m_context.station.profile().name.isEmpty(); }

private:
    QWidget *timelineCard();
    void fillComparison();
    void chooseFolder();
    /// In the settings, for the next time.
    void keepChoices();
    void updateButtons();
    void showProgress();
    void onBackedUp();
    void verifyChosen();
    void togglePin();
    void exportChosen();
    void compareChosen();
    void compare(const values::Result<files::FileSet> &older, const values::Result<files::FileSet> &newer,
        const QString &olderName, const QString &newerName);
    void offerRestore(const files::Bag &bag, const files::FileSet &then);
    void readController(const std::function<void(const files::FileSet &)> &handler);
    void planRestore();
    void say(const QString &sentence);

    const Context m_context;
    station::Backups &m_backups;
    bool m_isUp = false;
    disk::Worker m_disk; ///< Looks into folders and backups.
    disk::Worker m_long; ///< Verifies and exports, one after the other.
    bool m_isVerifying = false;
    bool m_isExporting = false;

    Timeline *m_timeline;
    QLabel *m_state;
    QSpinBox *m_keep;
    QSpinBox *m_keepDays;
    QPushButton *m_backUp;
    QPushButton *m_verify;
    QPushButton *m_pin;
    QPushButton *m_export;
    QComboBox *m_with;
    QPushButton *m_compare;
    widgets::OrderButton *m_restore;
    ComparisonCard *m_comparison;
};

} // namespace pages
