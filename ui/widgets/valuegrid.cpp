// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/valuegrid.h"

#include "ui/widgets/text.h"
#include "ui/widgets/valuelabel.h"
#include <QGridLayout>
#include <QPainter>

namespace widgets {

namespace {

constexpr int rowGap = 7;
constexpr int firstValue = 2; ///< Column of the layout, behind name and unit.

} // namespace

ValueGrid::ValueGrid(const QList<ValueColumn> &columns, int rows, QWidget *parent)
    : QWidget(parent), m_grid {new QGridLayout(this)}, m_isColumnVisible(columns.size(), true), m_rowCount {rows}
{
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(12);
    m_grid->setVerticalSpacing(rowGap);
    addHead(columns);
    for (int row = 0; row < rows; ++row)
        addRow(columns, row);
    for (int column = 0; column < int(columns.size()); ++column)
        m_grid->setColumnStretch(firstValue + column, 1);
}

void ValueGrid::addHead(const QList<ValueColumn> &columns)
{
    for (int column = 0; column < int(columns.size()); ++column) {
        QLabel *head = text(columns[column].title, ui::Type::Label, ui::Role::Text2);
        head->setAlignment(Qt::AlignRight | Qt::AlignBottom);
        head->setWordWrap(true);
        head->setToolTip(columns[column].toolTip);
        m_grid->addWidget(head, 0, firstValue + column);
        m_heads << head;
    }
}

void ValueGrid::addRow(const QList<ValueColumn> &columns, int row)
{
    Row added {text({}, ui::Type::Body, ui::Role::Text2), text({}, ui::Type::Label, ui::Role::Text3), {}};
    m_grid->addWidget(added.name, row + 1, 0);
    m_grid->addWidget(added.unit, row + 1, 1);
    for (int column = 0; column < int(columns.size()); ++column) {
        auto *value = new ValueLabel(columns[column].type);
        value->setObjectName(columns[column].name + QString::number(row + 1));
        value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        value->setTabular(true);
        value->setReserve(columns[column].reserve);
        value->setRole(columns[column].role);
        m_grid->addWidget(value, row + 1, firstValue + column);
        added.values << value;
    }
    m_rows << added;
}

void ValueGrid::setRowName(int row, const QString &name, const QString &unit)
{
    m_rows[row].name->setText(name);
    m_rows[row].unit->setText(unit);
    for (qsizetype column = 0; column < m_heads.size(); ++column)
        m_rows[row].values[column]->setTitle(tr("%1, %2").arg(name, m_heads[column]->text()));
}

void ValueGrid::setRowCount(int count)
{
    if (count == m_rowCount)
        return;
    m_rowCount = count;
    updateVisibility();
}

void ValueGrid::setColumnVisible(int column, bool isVisible)
{
    if (m_isColumnVisible[column] == isVisible)
        return;
    m_isColumnVisible[column] = isVisible;
    updateVisibility();
}

void ValueGrid::updateVisibility()
{
    for (int column = 0; column < int(m_heads.size()); ++column)
        m_heads[column]->setVisible(m_isColumnVisible[column]);
    for (int row = 0; row < int(m_rows.size()); ++row) {
        m_rows[row].name->setVisible(row < m_rowCount);
        m_rows[row].unit->setVisible(row < m_rowCount);
        for (int column = 0; column < int(m_heads.size()); ++column)
            m_rows[row].values[column]->setVisible(row < m_rowCount && m_isColumnVisible[column]);
    }
    update();
}

void ValueGrid::show(int row, int column, const Shown &shown) { m_rows[row].values[column]->show(shown); }

QString ValueGrid::toText() const
{
    const auto visible = [this](auto text) {
        QStringList cells;
        for (int column = 0; column < int(m_heads.size()); ++column) {
            if (m_isColumnVisible[column])
                cells << text(column);
        }
        return cells.join(u'\t');
    };
    QStringList lines {u'\t' + visible([this](int column) { return m_heads[column]->text(); })};
    for (const Row &row : m_rows.first(m_rowCount)) {
        const QString unit = row.unit->text();
        lines << (unit.isEmpty() ? row.name->text() : QStringLiteral("%1 (%2)").arg(row.name->text(), unit)) + u'\t'
                + visible([&](int column) { return row.values[column]->shown().word.text; });
    }
    return lines.join(u'\n');
}

void ValueGrid::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setPen(ui::color(ui::Role::Hairline, this));
    for (int row = 0; row < m_rowCount; ++row) {
        const int y = m_rows[row].name->geometry().top() - rowGap / 2 - 1;
        painter.drawLine(0, y, width(), y);
    }
}

} // namespace widgets
