// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/signalwatch.h"
#include "ui/models/iomodel.h"
#include "ui/models/watchmodel.h"
#include "ui/pages/page.h"
#include "ui/widgets/table.h"

class QLabel;
class QStackedWidget;
class QTabBar;

namespace widgets {
class GoToEdit;
}

namespace pages {

/// The I/O areas of the model, a tab each, and the signals that are watched. Only network inputs can be written.
class IoPage : public Page
{
    Q_OBJECT

public:
    explicit IoPage(const Context &context, QWidget *parent = nullptr);

    [[nodiscard]] QList<robot::TopicRange> topics() const override;

    void goTo(const names::Signal &signal);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    [[nodiscard]] QWidget *head();
    [[nodiscard]] QWidget *watchTab(const Context &context);
    void addAreas(const Context &context);
    void showTab(int tab);
    void onGoTo();
    void act(const QModelIndex &index);
    void openMenu(const QPoint &at);
    void showSentence();
    [[nodiscard]] models::IoModel *model() const;
    [[nodiscard]] bool isWatchTab() const;
    [[nodiscard]] protocol::IoArea area() const;

    const Context m_context;
    protocol::Dialect m_dialect;
    robot::SignalWatch &m_watch;
    QTabBar *m_bar;
    widgets::GoToEdit *m_goTo;
    QLabel *m_sentence;
    QLabel *m_complaint;
    QStackedWidget *m_stack;
    widgets::Table *m_table;
    widgets::Table *m_watchTable;
    QList<models::IoModel *> m_models; ///< By tab, in the order of the dialect's areas.
};

} // namespace pages
