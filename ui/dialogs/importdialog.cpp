// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/importdialog.h"

#include "ui/widgets/shown.h"
#include "ui/widgets/table.h"
#include "ui/widgets/text.h"
#include <QDialogButtonBox>
#include <QPushButton>
#include <QStandardItemModel>
#include <QVBoxLayout>

namespace dialogs {

using variables::Preview;

namespace {

widgets::Table *tableOf(
    const QString &name, const QString &title, const QStringList &head, const QList<QStringList> &rows)
{
    auto *table = new widgets::Table;
    auto *model = new QStandardItemModel(0, int(head.size()), table);
    model->setHorizontalHeaderLabels(head);
    for (const QStringList &texts : rows) {
        QList<QStandardItem *> row;
        for (const QString &text : texts)
            row << new QStandardItem(text);
        model->appendRow(row);
    }
    table->setObjectName(name);
    table->setAccessibleName(title);
    table->setModel(model);
    table->verticalHeader()->hide();
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->horizontalHeader()->setStretchLastSection(true);
    return table;
}

QList<QStringList> problemRows(const Preview &preview)
{
    QList<QStringList> rows;
    for (const auto &problem : preview.problems)
        rows << QStringList {problem.line > 0 ? QString::number(problem.line) : widgets::dash(), problem.reason};
    return rows;
}

QList<QStringList> differenceRows(const Preview &preview, const variables::Format &format)
{
    QList<QStringList> rows;
    for (const auto &difference : preview.differences)
        rows << QStringList {QString::number(difference.line), toString(difference.variable),
            difference.was ? toText(*difference.was, format) : widgets::dash(), toText(difference.value, format)};
    return rows;
}

} // namespace

ImportDialog::ImportDialog(
    const Preview &preview, const QString &controller, const variables::Format &format, QWidget *parent)
    : DialogSheet(parent)
{
    setObjectName(QStringLiteral("importDialog"));
    setWindowTitle(tr("Take over values — %1").arg(controller));
    resize(680, 520);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Cancel)->setObjectName(QStringLiteral("cancelButton"));
    const int count = int(preview.differences.size());
    auto *stage = buttons->addButton(tr("Stage %n value(s)", nullptr, count), QDialogButtonBox::AcceptRole);
    stage->setObjectName(QStringLiteral("stageButton"));
    stage->setProperty("primary", true);
    stage->setEnabled(preview.problems.isEmpty() && count > 0);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(ui::space::page, ui::space::page, ui::space::page, ui::space::page);
    column->setSpacing(ui::space::gap);
    column->addWidget(widgets::text(tr("%n value(s) would change", nullptr, count), ui::Type::State, ui::Role::Text1));
    column->addWidget(widgets::sentence(
        tr("%n value(s) are there already. Staging sends nothing to the controller.", nullptr, preview.unchanged),
        ui::Role::Text2));
    if (!preview.problems.isEmpty()) {
        auto *reason = widgets::sentence(
            tr("%n line(s) cannot be read, so nothing is taken over:", nullptr, int(preview.problems.size())),
            ui::Role::Amber);
        reason->setObjectName(QStringLiteral("problemSentence"));
        column->addWidget(reason);
        column->addWidget(tableOf(QStringLiteral("problemTable"), tr("Lines that cannot be read"),
                              {tr("Line"), tr("What is wrong")}, problemRows(preview)),
            1);
    }
    column->addWidget(
        tableOf(QStringLiteral("differenceTable"), tr("Values that would change"),
            {tr("Line"), tr("Variable"), tr("Old value"), tr("New value")}, differenceRows(preview, format)),
        1);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::accepted, this, [this, differences = preview.differences] {
        accept();
        Q_EMIT differencesAccepted(differences);
    });
}

} // namespace dialogs
