// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/appearancedialog.h"

#include "ui/language.h"
#include "ui/widgets/text.h"
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>

namespace dialogs {

namespace {

QComboBox *choice(const char *name)
{
    auto *box = new QComboBox;
    box->setObjectName(QLatin1String(name));
    box->addItem(AppearanceDialog::tr("As the desktop"), QString());
    return box;
}

/// A word that is no choice any more counts as none.
void select(QComboBox *box, const QString &word) { box->setCurrentIndex(std::max(box->findData(word), 0)); }

} // namespace

AppearanceDialog::AppearanceDialog(const settings::Appearance &now, QWidget *parent)
    : DialogSheet(parent), m_language {choice("language")}, m_scheme {choice("scheme")}
{
    setObjectName(QStringLiteral("appearanceDialog"));
    setWindowTitle(tr("Language and look"));
    for (const ui::Language &language : ui::languages())
        m_language->addItem(QString::fromUtf8(language.name), QLatin1String(language.code));
    m_scheme->addItem(tr("Light"), QStringLiteral("light"));
    m_scheme->addItem(tr("Dark"), QStringLiteral("dark"));
    select(m_language, now.language);
    select(m_scheme, now.scheme);
    auto *form = new QFormLayout(this);
    form->addRow(tr("&Language"), m_language);
    form->addRow(tr("L&ook"), m_scheme);
    form->addRow(widgets::sentence(
        tr("Words of the robot and text from the controller stay as they are on the pendant."), ui::Role::Text2));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setObjectName(QStringLiteral("okButton"));
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        close();
        Q_EMIT chosen({m_language->currentData().toString(), m_scheme->currentData().toString()});
    });
}

} // namespace dialogs
