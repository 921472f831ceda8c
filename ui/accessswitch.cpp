// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/accessswitch.h"

#include "ui/conditionwords.h"
#include "ui/dialogs/accessdialog.h"
#include "ui/theme.h"
#include "ui/widgets/text.h"
#include <QActionGroup>
#include <QMenu>

namespace ui {

using robot::Level;

AccessSwitch::AccessSwitch(robot::Access &access, QWidget *parent) : QPushButton(parent), m_access {access}
{
    setObjectName(QStringLiteral("accessBadge"));
    setProperty("badge", true);
    setAutoDefault(false);
    QFont small = ui::font(Type::Label);
    small.setWeight(QFont::DemiBold);
    setFont(small);
    auto *menu = new QMenu(this);
    auto *group = new QActionGroup(menu);
    for (const Level level : {Level::Monitor, Level::Operate, Level::Engineer}) {
        QAction *action = menu->addAction(title(level), this, [this, level] { enter(level); });
        action->setObjectName(QLatin1String("level") + QLatin1String(key(level)));
        action->setCheckable(true);
        group->addAction(action);
        m_levels << action;
    }
    menu->addSeparator();
    m_passcode = menu->addAction(tr("Passcode and idle time…"), this,
        [this] { (new dialogs::AccessSettingsDialog(m_access.rules(), window()))->show(); });
    m_passcode->setObjectName(QStringLiteral("accessSettings"));
    setMenu(menu);
    connect(&access, &robot::Access::levelChanged, this, &AccessSwitch::showLevel);
    QStringList texts;
    for (const Level level : {Level::Monitor, Level::Operate, Level::Engineer})
        texts << title(level).toUpper();
    widgets::reserveWidth(this, texts);
    showLevel();
}

void AccessSwitch::showLevel()
{
    const Level level = m_access.level();
    setText(title(level).toUpper());
    setAccessibleName(tr("Access level: %1").arg(title(level)));
    for (qsizetype i = 0; i < m_levels.size(); ++i) {
        m_levels[i]->setChecked(int(level) == i);
        m_levels[i]->setEnabled(i == 0 || !m_access.rules().isMonitorOnly());
    }
    m_passcode->setEnabled(level == Level::Engineer);
    setToolTip(m_access.rules().isMonitorOnly()
            ? tr("This program was started with --monitor-only: it watches and holds.")
            : tr("What may be done from here. It falls back to Monitor after %n minute(s) without key or mouse.",
                nullptr, int(m_access.rules().settings().idleTime.count())));
}

void AccessSwitch::enter(Level level)
{
    if (m_access.needsPasscode(level))
        (new dialogs::PasscodeDialog(m_access, level, window()))->show();
    else
        m_access.enter(level);
    showLevel(); // the menu has ticked what was chosen, whether or not it was entered
}

} // namespace ui
