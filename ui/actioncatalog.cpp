// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/actioncatalog.h"

#include "ui/icons.h"
#include <QCoreApplication>
#include <QWidget>

namespace ui {

namespace {

#define ACTION(text) QT_TRANSLATE_NOOP("Actions", text)
constexpr ActionRow rows[] {
    {ActionId::Hold, "holdAction", ACTION("HOLD (software)"), "Pause; Ctrl+Shift+H", "hold"},
    {ActionId::Access, "accessAction", ACTION("Access level…"), "Ctrl+L", ""},
    {ActionId::OpenInWindow, "openInWindowAction", ACTION("Open this page in its own window"), "Ctrl+Shift+N", ""},
    {ActionId::Connect, "connectAction", ACTION("Connect…"), "Ctrl+O", "connect"},
    {ActionId::Reconnect, "reconnectAction", ACTION("Connect to this controller"), "Ctrl+R", "connect"},
    {ActionId::Disconnect, "disconnectAction", ACTION("Disconnect"), "Ctrl+W", "disconnect"},
    {ActionId::Demo, "demoAction", ACTION("Open the demo"), "Ctrl+Shift+D", "demo"},
    {ActionId::Diagnose, "diagnoseAction", ACTION("Diagnose…"), "Ctrl+D", "diagnose"},
    {ActionId::CopyDiagnosis, "copyDiagnosisAction", ACTION("Copy diagnosis"), "Ctrl+Shift+C", "copy"},
    {ActionId::Shortcuts, "shortcutsAction", ACTION("Keyboard shortcuts"), "F1", ""},
    {ActionId::About, "aboutAction", ACTION("About Pendesk"), "", ""},
    {ActionId::Quit, "quitAction", ACTION("Quit"), "Ctrl+Q", ""},
};
#undef ACTION

QList<QKeySequence> sequences(const char *shortcut)
{
    return QKeySequence::listFromString(QString::fromLatin1(shortcut), QKeySequence::PortableText);
}

} // namespace

std::span<const ActionRow> actionCatalog() { return rows; }

QString text(const ActionRow &row) { return QCoreApplication::translate("Actions", row.text); }

QString shortcutText(const char *shortcut)
{
    QStringList words;
    for (const QKeySequence &sequence : sequences(shortcut))
        words << sequence.toString(QKeySequence::NativeText);
    return words.join(QCoreApplication::translate("Actions", " or "));
}

Actions::Actions(QWidget *window) : QObject(window)
{
    for (const ActionRow &row : rows) {
        auto *action = new QAction(icon(QLatin1String(row.icon)), text(row), this);
        action->setObjectName(QLatin1String(row.name));
        if (row.id != ActionId::Hold)
            action->setShortcuts(sequences(row.shortcut));
        window->addAction(action);
        connect(action, &QAction::triggered, this, [this, id = row.id] { Q_EMIT triggered(id); });
        m_actions.insert(row.id, action);
    }
}

} // namespace ui
