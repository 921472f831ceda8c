// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/numbering.h"
#include "settings/profilestore.h"
#include "ui/pages/variablesheet.h"

class QLabel;
class QPushButton;
class QTabBar;

namespace pages {

/// B I D R S P BP EX, a tab each, and watch pages of any of them, which are kept for this controller.
class VariablesPage : public Page
{
    Q_OBJECT

public:
    explicit VariablesPage(const Context &context, QWidget *parent = nullptr);

    [[nodiscard]] QList<robot::TopicRange> topics() const override;

    /// Opens the tab of the variable and makes it current.
    void goTo(const variables::Reference &variable);
    /// Adds a watch page and opens it.
    void addWatchPage(const QString &name);

private:
    struct Tab {
        QString name;
        models::VariableModel *model;
        bool isWatch;
    };

    void addTab(const QString &name, const QList<variables::Reference> &variables, bool isWatch);
    void loadWatchPages();
    void keepWatchPages();
    void openMenu(const QPoint &at);
    void openTabMenu(const QPoint &at);
    void openNumberingTest();
    void onVerified(protocol::Numbering numbering);
    void showNumbering();
    void watch(int page);
    void unwatch();

    settings::ProfileStore &m_store;
    settings::Notes m_notes;
    robot::Orders &m_orders;
    robot::NumberingGuard &m_guard;
    variables::Format m_format;
    models::VariableDesk m_desk;
    VariableSheet *m_sheet;
    QTabBar *m_bar;
    QPushButton *m_test;
    QList<Tab> m_tabs;
};

} // namespace pages
