// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QAction>
#include <QHash>
#include <QUuid>
#include <span>

namespace ui {

enum class ActionId {
    Hold,
    Access,
    OpenInWindow,
    Connect,
    Reconnect,
    Disconnect,
    Demo,
    Diagnose,
    CopyDiagnosis,
    Appearance,
    Readiness,
    Help,
    About,
    Quit
};

/// One row an action: menus, rail, shortcuts and the list under F1 are made from it.
struct ActionRow {
    ActionId id;
    const char *name; ///< objectName of the action.
    const char *text; ///< Translated by text().
    const char *shortcut; ///< Portable, several separated by "; "; empty for none.
    const char *icon; ///< Empty for none.
};

[[nodiscard]] std::span<const ActionRow> actionCatalog();
[[nodiscard]] QString text(const ActionRow &row);
/// As the desktop writes it: "Pause or Ctrl+Shift+H".
[[nodiscard]] QString shortcutText(const char *shortcut);

/// The actions of one window.
class Actions : public QObject
{
    Q_OBJECT

public:
    /// The shortcuts work in `window`; HOLD's are HoldKey's business.
    explicit Actions(QWidget *window);

    /// Writes the words anew, in the language that is spoken now.
    void translate();
    [[nodiscard]] QAction *action(ActionId id) const { return m_actions.value(id); }

Q_SIGNALS:
    void triggered(ui::ActionId id);
    /// On a page somebody chose to connect to a controller that the store knows; the page sends it.
    void profileChosen(const QString &name) const;
    /// Somebody chose to look at a controller, connected or not.
    void stationChosen(const QUuid &id) const;

private:
    QHash<ActionId, QAction *> m_actions;
};

inline size_t qHash(ActionId id, size_t seed = 0) { return ::qHash(int(id), seed); }

} // namespace ui
