// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "station/fleet.h"
#include "ui/linkview.h"
#include <QWidget>

class QStackedLayout;

namespace widgets {
class PageLine;
}

namespace ui {
class Actions;
}

namespace pages {

/// What a page is made of. All of it outlives the page: a window makes new pages for another station or language.
struct Context {
    station::Station &station; ///< What is shown, and what is done to it.
    station::Fleet &fleet; ///< All stations of the program.
    settings::ProfileStore &store; ///< The controllers that this user knows.
    const ui::Actions &actions;
};

/// One page of the window: what it shows when there is a link, and the way to a connection when there is none. What
/// must be read while it is visible it only names; it never asks for it itself.
class Page : public QWidget
{
    Q_OBJECT

public:
    explicit Page(const Context &context, QWidget *parent = nullptr);

    /// What must be read while the page is visible; see topicsChanged().
    [[nodiscard]] virtual QList<robot::TopicRange> topics() const = 0;
    /// Stands at the top of the page; see widgets::PageLine.
    void setName(const QString &name);
    /// Called once after creation and whenever the link has something new to say. Call it from an override.
    virtual void showLink(const ui::LinkView &link);
    /// Twice a second.
    virtual void showStatistics(const session::LinkStatistics &) { }

Q_SIGNALS:
    /// topics() is another list than before: another tab, other rows in view.
    void topicsChanged();
    /// The page came into view, or left it: nothing is read for it then.
    void visibilityChanged();

protected:
    /// What the page shows while there is a link. Call it once.
    void setContent(QWidget *content);
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    /// Without a connection there is nothing to show. A page that shows what this computer knows says no.
    [[nodiscard]] virtual bool needsLink() const { return true; }

    /// For tools at the right end of the page line, and for what its values are of where "live" does not say it.
    [[nodiscard]] widgets::PageLine &line() const { return *m_line; }

private:
    widgets::PageLine *m_line;
    QStackedLayout *m_layers;
};

} // namespace pages
