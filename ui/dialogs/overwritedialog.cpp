// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/overwritedialog.h"

#include "ui/widgets/text.h"
#include "ui/widgets/tickbox.h"
#include <QCheckBox>
#include <QHBoxLayout>
#include <QPushButton>

namespace dialogs {

OverwriteDialog::OverwriteDialog(
    const QString &name, const QString &where, bool canKeepBoth, int remaining, QWidget *parent)
    : DialogSheet(parent), m_forAll {new widgets::TickBox(tr("For the remaining %n file(s) too", nullptr, remaining))}
{
    setObjectName(QStringLiteral("overwriteDialog"));
    setWindowTitle(tr("“%1” exists").arg(name));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(ui::space::page, ui::space::page, ui::space::page, ui::space::page);
    column->setSpacing(ui::space::gap);
    column->addWidget(widgets::sentence(tr("There is a file “%1” %2 already.").arg(name, where), ui::Role::Text1));
    column->addWidget(m_forAll);
    m_forAll->setObjectName(QStringLiteral("forAll"));
    m_forAll->setVisible(remaining > 0);
    auto *row = new QHBoxLayout;
    addButton(row, tr("&Compare…"), "compare", Choice::Compare);
    row->addStretch();
    addButton(row, tr("&Replace"), "replace", Choice::Replace);
    if (canKeepBoth)
        addButton(row, tr("&Keep both"), "keepBoth", Choice::KeepBoth);
    addButton(row, tr("&Skip"), "skip", Choice::Skip, true);
    column->addLayout(row);
    for (const char *answer : {"replace", "keepBoth"}) {
        if (auto *button = findChild<QPushButton *>(QLatin1String(answer)))
            widgets::writing(button);
    }
    findChild<QPushButton *>(QStringLiteral("skip"))->setFocus();
}

bool OverwriteDialog::isForAll() const { return m_forAll->isChecked(); }

void OverwriteDialog::addButton(QHBoxLayout *row, const QString &text, const char *name, Choice choice, bool isDefault)
{
    auto *button = new QPushButton(text);
    button->setObjectName(QLatin1String(name));
    button->setAutoDefault(isDefault);
    button->setDefault(isDefault);
    connect(button, &QPushButton::clicked, this, [this, choice] {
        m_choice = choice;
        accept();
    });
    row->addWidget(button);
}

} // namespace dialogs
