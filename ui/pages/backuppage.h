// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/backup.h"
#include "files/compare.h"
#include "ui/pages/files/fileorders.h"
#include "ui/pages/page.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QSpinBox;
class QTreeWidget;

namespace widgets {
class Card;
class DiffView;
class OrderButton;
} // namespace widgets

namespace pages {

/// The backups of a controller as a timeline; what differs between two of them, or between one and the controller; and
/// the way back.
class BackupPage : public Page
{
    Q_OBJECT

public:
    explicit BackupPage(const Context &context, QWidget *parent = nullptr);

    [[nodiscard]] QList<robot::TopicRange> topics() const override;
    void showLink(const ui::LinkView &link) override;

    /// The folder of all backups.
    void setRoot(const QString &root);
    /// Reads the folder again.
    void reload();

private:
    QWidget *timelineCard();
    QWidget *comparisonCard();
    [[nodiscard]] files::Archive archive() const;
    [[nodiscard]] std::optional<files::ArchiveEntry> chosen() const;
    [[nodiscard]] files::BackupOrder order() const;
    [[nodiscard]] files::NoiseFilter noise() const;
    [[nodiscard]] files::Retention retention() const;
    [[nodiscard]] QString text(const values::FileName &name) const;
    void showEntries(const QList<files::ArchiveEntry> &entries);
    void updateButtons();
    void backUp();
    void onBackedUp();
    void verifyChosen();
    void togglePin();
    void compareChosen();
    void readController(const std::function<void(const files::FileSet &)> &handler);
    void showComparison(const files::FileSet &older, const files::FileSet &newer);
    void showFile();
    void planRestore();
    void say(const QString &sentence);

    const Context m_context;
    FileOrders m_orders;
    QString m_root;
    bool m_isUp = false;
    QList<files::ArchiveEntry> m_entries; ///< Newest first, as the tree shows them.
    QHash<QString, int> m_changes; ///< By id: files that differ from the backup before.
    QFutureWatcher<QHash<QString, int>> m_counting;
    QFutureWatcher<files::Verification> m_verifying;
    std::unique_ptr<files::Backup> m_backup;
    std::unique_ptr<files::Snapshot> m_snapshot;
    files::FileSet m_older; ///< Of the comparison that is shown.
    files::FileSet m_newer;

    QTreeWidget *m_timeline;
    QLabel *m_state;
    QSpinBox *m_keep;
    QSpinBox *m_keepDays;
    QPushButton *m_backUp;
    QPushButton *m_verify;
    QPushButton *m_pin;
    QComboBox *m_with;
    QList<QCheckBox *> m_noise;
    QPushButton *m_compare;
    widgets::OrderButton *m_restore;
    widgets::Card *m_comparison;
    QTreeWidget *m_files;
    widgets::DiffView *m_diff;
};

} // namespace pages
