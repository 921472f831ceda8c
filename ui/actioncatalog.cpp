// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/actioncatalog.h"

#include "ui/icons.h"
#include <QCoreApplication>
#include <QWidget>

namespace ui {

namespace {

constexpr ActionRow actionRows[] {
    {ActionId::Hold, "holdAction", QT_TRANSLATE_NOOP("Actions", "HOLD (software)"), "Pause; Ctrl+Shift+H", "hold"},
    {ActionId::Access, "accessAction", QT_TRANSLATE_NOOP("Actions", "Access level…"), "Ctrl+L", ""},
    {ActionId::OpenInWindow, "openInWindowAction", QT_TRANSLATE_NOOP("Actions", "Open this page in its own window"),
        "Ctrl+Shift+N", ""},
    {ActionId::Connect, "connectAction", QT_TRANSLATE_NOOP("Actions", "Connect…"), "Ctrl+O", "connect"},
    {ActionId::Reconnect, "reconnectAction", QT_TRANSLATE_NOOP("Actions", "Connect to this controller"), "Ctrl+R",
        "connect"},
    {ActionId::Disconnect, "disconnectAction", QT_TRANSLATE_NOOP("Actions", "Disconnect"), "Ctrl+W", "disconnect"},
    {ActionId::Demo, "demoAction", QT_TRANSLATE_NOOP("Actions", "Open the demo"), "Ctrl+Shift+D", "demo"},
    {ActionId::Diagnose, "diagnoseAction", QT_TRANSLATE_NOOP("Actions", "Diagnose…"), "Ctrl+D", "diagnose"},
    {ActionId::CopyDiagnosis, "copyDiagnosisAction", QT_TRANSLATE_NOOP("Actions", "Copy diagnosis"), "Ctrl+Shift+C",
        "copy"},
    {ActionId::Appearance, "appearanceAction", QT_TRANSLATE_NOOP("Actions", "Language and look…"), "Ctrl+,",
        "settings"},
    {ActionId::Readiness, "readinessAction", QT_TRANSLATE_NOOP("Actions", "Readiness…"), "Ctrl+Shift+R", ""},
    {ActionId::Help, "helpAction", QT_TRANSLATE_NOOP("Actions", "Help and shortcuts"), "F1", ""},
    {ActionId::About, "aboutAction", QT_TRANSLATE_NOOP("Actions", "About Pendesk"), "", ""},
    {ActionId::Quit, "quitAction", QT_TRANSLATE_NOOP("Actions", "Quit"), "Ctrl+Q", ""},
};

QList<QKeySequence> sequences(const char *shortcut)
{
    return QKeySequence::listFromString(QString::fromLatin1(shortcut), QKeySequence::PortableText);
}

} // namespace

std::span<const ActionRow> actionCatalog() { return actionRows; }

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
    for (const ActionRow &row : actionRows) {
        auto *action = new QAction(icon(QLatin1String(row.icon)), text(row), this);
        action->setObjectName(QLatin1String(row.name));
        if (row.id != ActionId::Hold)
            action->setShortcuts(sequences(row.shortcut));
        window->addAction(action);
        connect(action, &QAction::triggered, this, [this, id = row.id] { Q_EMIT triggered(id); });
        m_actions.insert(row.id, action);
    }
}

void Actions::translate()
{
    for (const ActionRow &row : actionRows)
        m_actions[row.id]->setText(text(row));
}

} // namespace ui
