// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/applydialog.h"

#include "ui/widgets/shown.h"
#include "ui/widgets/table.h"
#include "ui/widgets/text.h"
#include <QDialogButtonBox>
#include <QPushButton>
#include <QStandardItemModel>
#include <QVBoxLayout>

namespace dialogs {

namespace {

QStandardItemModel *modelOf(const robot::Edits &edits, const QList<variables::Reference> &variables,
    const variables::Format &format, QObject *parent)
{
    auto *model = new QStandardItemModel(0, 3, parent);
    model->setHorizontalHeaderLabels(
        {ApplyDialog::tr("Variable"), ApplyDialog::tr("Old value"), ApplyDialog::tr("New value")});
    for (const auto &variable : variables) {
        const auto now = edits.now(variable);
        const QString was = now ? toText(*now, format) : widgets::dash();
        QList<QStandardItem *> row;
        for (const QString &text : {toString(variable), was, toText(edits.staged().find(variable)->value, format)})
            row << new QStandardItem(text);
        row.last()->setData(true, widgets::BoldRole);
        model->appendRow(row);
    }
    return model;
}

} // namespace

ApplyDialog::ApplyDialog(robot::Edits &edits, const QList<variables::Reference> &list, const QString &controller,
    const variables::Format &format, QWidget *parent)
    : DialogSheet(parent)
{
    setObjectName(QStringLiteral("applyDialog"));
    setWindowTitle(tr("Apply — %1").arg(controller));
    const bool hasPositions =
        std::ranges::any_of(list, [](const variables::Reference &variable) { return isPosition(variable.kind); });
    resize(hasPositions ? 1230 : 560, 420);
    auto *table = new widgets::Table;
    table->setObjectName(QStringLiteral("applyTable"));
    table->setAccessibleName(tr("What will be written"));
    table->setModel(modelOf(edits, list, format, this));
    table->verticalHeader()->hide();
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setColumnWidth(1, hasPositions ? 520 : 180);
    table->horizontalHeader()->setStretchLastSection(true);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Cancel)->setObjectName(QStringLiteral("cancelButton"));
    auto *apply = buttons->addButton(tr("Write %n value(s)", nullptr, int(list.size())), QDialogButtonBox::AcceptRole);
    apply->setObjectName(QStringLiteral("applyConfirm"));
    apply->setProperty("primary", true);
    widgets::writing(apply);
    buttons->button(QDialogButtonBox::Cancel)->setDefault(true); // Enter writes nothing
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(ui::space::page, ui::space::page, ui::space::page, ui::space::page);
    column->setSpacing(ui::space::gap);
    column->addWidget(widgets::text(
        tr("Write %n value(s) to %1", nullptr, int(list.size())).arg(controller), ui::Type::State, ui::Role::Text1));
    column->addWidget(widgets::sentence(
        tr("Each is written once and read back. What does not read back as it was written stays here and is marked."),
        ui::Role::Text2));
    column->addWidget(table, 1);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::accepted, this, [this, &edits, list] {
        accept();
        edits.apply(list);
    });
}

} // namespace dialogs
