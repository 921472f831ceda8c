// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/tabletools.h"

#include "ui/widgets/filesheet.h"
#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QTableView>

namespace widgets {

namespace {

constexpr int cellMargin = 18;
constexpr int leastStretch = 90;

QString line(const QAbstractItemModel *model, const std::function<QVariant(int)> &cell)
{
    QStringList cells;
    for (int column = 0; column < model->columnCount(); ++column)
        cells += cell(column).toString().replace(u'\t', u' ').replace(u'\n', u' ');
    return cells.join(u'\t') + u'\n';
}

QList<int> rowsToCopy(const QTableView *table)
{
    QList<int> rows;
    for (const QModelIndex &index : table->selectionModel()->selectedRows())
        rows += index.row();
    std::ranges::sort(rows);
    for (int row = 0; rows.isEmpty() && row < table->model()->rowCount(); ++row)
        rows += row;
    return rows;
}

} // namespace

void fitColumns(QTableView *table, const QStringList &samples)
{
    QHeaderView *header = table->horizontalHeader();
    QFont bold = table->font();
    bold.setWeight(QFont::DemiBold);
    int stretched = std::min(leastStretch, header->defaultSectionSize()) / 2;
    for (int column = 0; column < samples.size(); ++column) {
        const QString head = table->model()->headerData(column, Qt::Horizontal).toString();
        const int headNeed = QFontMetrics(header->font()).horizontalAdvance(head) + cellMargin;
        if (samples[column].isEmpty()) {
            header->setSectionResizeMode(column, QHeaderView::Stretch);
            stretched = std::max(stretched, headNeed);
            continue;
        }
        const int need = QFontMetrics(bold).horizontalAdvance(samples[column]) + cellMargin;
        header->resizeSection(column, std::max(need, headNeed));
    }
    header->setMinimumSectionSize(stretched);
}

QString rowsAsText(const QTableView *table)
{
    const QAbstractItemModel *model = table->model();
    QString text = line(model, [&](int column) { return model->headerData(column, Qt::Horizontal); });
    for (const int row : rowsToCopy(table))
        text += line(model, [&](int column) { return model->index(row, column).data(); });
    return text;
}

void copyFrom(QTableView *table, QAbstractButton *button)
{
    auto *action = new QAction(table);
    action->setShortcut(QKeySequence::Copy);
    action->setShortcutContext(Qt::WidgetShortcut);
    table->addAction(action);
    const auto copy = [table] { QApplication::clipboard()->setText(rowsAsText(table)); };
    QObject::connect(action, &QAction::triggered, table, copy);
    QObject::connect(button, &QAbstractButton::clicked, table, copy);
}

void askForFile(QWidget *parent, const QString &title, const QString &name,
    const std::function<void(const QString &path, journal::Format format)> &then)
{
    const QString csv = QCoreApplication::translate("QFileDialog", "Comma-separated values (*.csv)");
    const QString json = QCoreApplication::translate("QFileDialog", "JSON (*.json)");
    auto *dialog = askForPath({"exportDialog", PathKind::NewFile, title, name, {csv, json}, QStringLiteral("csv")},
        parent, [then](const QString &path) {
            const bool isJson = path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive);
            then(path, isJson ? journal::Format::Json : journal::Format::Csv);
        });
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog, [dialog, json](const QString &filter) {
        dialog->setDefaultSuffix(filter == json ? QStringLiteral("json") : QStringLiteral("csv"));
    });
}

} // namespace widgets
