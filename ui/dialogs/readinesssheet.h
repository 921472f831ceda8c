// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/numbering.h"
#include "robot/readiness.h"
#include "ui/widgets/dialogsheet.h"

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace dialogs {

class LadderView;
class ReadinessRowView;

/// What this controller allows now, followed live: a row a subject, with what it rests on and what helps. Not modal;
/// it only reads, and only while it is visible. Deletes itself when closed.
class ReadinessSheet : public widgets::DialogSheet
{
    Q_OBJECT

public:
    /// All of them must outlive the sheet.
    ReadinessSheet(
        robot::Orders &orders, robot::NumberingGuard &guard, settings::ProfileStore &store, QWidget *parent = nullptr);
    ~ReadinessSheet() override;

    /// What stands on the sheet, for support.
    [[nodiscard]] QString toText() const;

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    [[nodiscard]] QWidget *makeRows();
    [[nodiscard]] QWidget *makeButtons();
    [[nodiscard]] robot::ReadinessFacts facts() const;
    [[nodiscard]] robot::Probe probe(robot::Topic topic) const;
    void follow();
    void onLinkStateChanged();
    void knockAtFiles();
    void showFacts();
    void showLink(bool isStale);
    void copy();
    void openNumberingTest();

    robot::Orders &m_orders;
    robot::NumberingGuard &m_guard;
    settings::ProfileStore &m_store;
    QLabel *m_link;
    QList<ReadinessRowView *> m_rows;
    QPushButton *m_copy;
    QPushButton *m_test;
    LadderView *m_ladder; ///< Never shown; what it finds is copied too.
    robot::Poller::Interest m_interest; ///< While visible.
    robot::Probe m_files;
};

} // namespace dialogs
