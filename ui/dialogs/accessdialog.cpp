// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/accessdialog.h"

#include "ui/conditionwords.h"
#include "ui/widgets/text.h"
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

namespace dialogs {

using robot::Access;
using settings::Passcode;

namespace {

QString purpose()
{
    return PasscodeDialog::tr("The passcode guards against mistakes, not against attackers: whoever can change this "
                              "user's files can remove it.");
}

QLineEdit *passcodeEdit(const char *name)
{
    auto *edit = new QLineEdit;
    edit->setObjectName(QLatin1String(name));
    edit->setEchoMode(QLineEdit::Password);
    return edit;
}

QDialogButtonBox *buttons(QDialog *dialog)
{
    auto *box = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    box->button(QDialogButtonBox::Ok)->setObjectName(QStringLiteral("okButton"));
    box->button(QDialogButtonBox::Cancel)->setObjectName(QStringLiteral("cancelButton"));
    QObject::connect(box, &QDialogButtonBox::rejected, dialog, &QDialog::close);
    return box;
}

} // namespace

PasscodeDialog::PasscodeDialog(Access &access, robot::Level level, QWidget *parent)
    : DialogSheet(parent),
      m_access {access},
      m_level {level},
      m_passcode {passcodeEdit("passcode")},
      m_complaint {widgets::sentence({}, ui::Role::Amber)}
{
    setObjectName(QStringLiteral("passcodeDialog"));
    setWindowTitle(tr("Access level: %1").arg(ui::title(level)));
    auto *form = new QFormLayout(this);
    auto *box = buttons(this);
    m_complaint->setObjectName(QStringLiteral("passcodeComplaint"));
    form->addRow(tr("Passcode"), m_passcode);
    form->addRow(m_complaint);
    form->addRow(widgets::sentence(purpose(), ui::Role::Text2));
    form->addRow(box);
    connect(box, &QDialogButtonBox::accepted, this, &PasscodeDialog::tryEnter);
}

void PasscodeDialog::tryEnter()
{
    m_passcode->setEnabled(false); // one try at a time
    m_complaint->setText(tr("Checking…"));
    m_access.enter(m_level, m_passcode->text(), this, [this](Access::Answer answer) { onAnswered(answer); });
}

void PasscodeDialog::onAnswered(Access::Answer answer)
{
    if (answer == Access::Answer::Entered) {
        close();
        return;
    }
    m_complaint->setText(tr("That is not the passcode."));
    m_passcode->setEnabled(true);
    m_passcode->selectAll();
    m_passcode->setFocus();
}

AccessSettingsDialog::AccessSettingsDialog(robot::AccessRules &rules, QWidget *parent)
    : DialogSheet(parent),
      m_rules {rules},
      m_minutes {new QSpinBox},
      m_passcode {passcodeEdit("newPasscode")},
      m_again {passcodeEdit("newPasscodeAgain")},
      m_complaint {widgets::sentence({}, ui::Role::Amber)}
{
    setObjectName(QStringLiteral("accessSettingsDialog"));
    setWindowTitle(tr("Passcode and idle time"));
    m_minutes->setObjectName(QStringLiteral("idleMinutes"));
    m_minutes->setRange(1, 480);
    m_minutes->setValue(int(rules.settings().idleTime.count()));
    m_minutes->setSuffix(tr(" min"));
    m_complaint->setObjectName(QStringLiteral("passcodeComplaint"));
    auto *form = new QFormLayout(this);
    auto *box = buttons(this);
    form->addRow(tr("Back to Monitor after"), m_minutes);
    form->addRow(tr("New passcode"), m_passcode);
    form->addRow(tr("The same again"), m_again);
    form->addRow(m_complaint);
    form->addRow(widgets::sentence(tr("Leave both empty for no passcode."), ui::Role::Text2));
    form->addRow(widgets::sentence(purpose(), ui::Role::Text2));
    form->addRow(box);
    connect(box, &QDialogButtonBox::accepted, this, &AccessSettingsDialog::save);
}

void AccessSettingsDialog::save()
{
    if (m_passcode->text() != m_again->text()) {
        m_complaint->setText(tr("The two are not the same."));
        return;
    }
    if (m_passcode->text().isEmpty())
        return keep(std::nullopt);
    setEnabled(false);
    m_making.run(
        this, [text = m_passcode->text()] { return Passcode::of(text); },
        [this](const Passcode &passcode) { keep(passcode); });
}

void AccessSettingsDialog::keep(const std::optional<Passcode> &passcode)
{
    m_rules.setSettings({std::chrono::minutes {m_minutes->value()}, passcode});
    close();
}

} // namespace dialogs
