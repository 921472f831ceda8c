// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/variablesheet.h"

#include "ui/dialogs/applydialog.h"
#include "ui/dialogs/positiondialog.h"
#include "ui/pages/variabletransfer.h"
#include "ui/widgets/celleditor.h"
#include "ui/widgets/filesheet.h"
#include "ui/widgets/flow.h"
#include "ui/widgets/gotoedit.h"
#include "ui/widgets/line.h"
#include "ui/widgets/orderbutton.h"
#include "ui/widgets/shown.h"
#include "ui/widgets/text.h"
#include <QKeyEvent>
#include <QPushButton>
#include <QVBoxLayout>

namespace pages {

using models::VariableModel;
using variables::Reference;

namespace {

QPushButton *sheetButton(const char *name, const QString &words)
{
    auto *result = new QPushButton(words);
    result->setObjectName(QLatin1String(name));
    result->setAutoDefault(false);
    return result;
}

} // namespace

VariableSheet::VariableSheet(const Context &context, const models::VariableDesk &desk, robot::Act act, QWidget *parent)
    : QWidget(parent),
      m_desk {desk},
      m_orders {context.station.orders},
      m_act {act},
      m_table {new widgets::Table},
      m_head {new widgets::Flow},
      m_foot {new widgets::Flow},
      m_goTo {new widgets::GoToEdit(this)},
      m_sentence {new widgets::Line(ui::Role::Amber, ui::Type::Body)},
      m_note {new widgets::Line(ui::Role::Text2, ui::Type::Body)},
      m_apply {new widgets::OrderButton(context.station.orders, act, widgets::OrderButton::Reason::Below)},
      m_discard {sheetButton("discardButton", tr("Discard"))},
      m_undo {sheetButton("undoButton", tr("Undo last"))},
      m_transfer {new VariableTransfer(m_desk, m_orders, this)}
{
    const auto check = [this](
                           const QModelIndex &index, const QString &typed) { return m_model->complaint(index, typed); };
    m_table->setObjectName(QStringLiteral("variableTable"));
    m_table->setAccessibleName(act == robot::Act::WriteRegister ? tr("Registers") : tr("Variables"));
    auto *delegate = new widgets::ValueDelegate({VariableModel::Value, VariableModel::Note},
        {VariableModel::LiveTextRole, VariableModel::RangeTextRole}, check, this);
    m_table->setItemDelegate(delegate);
    m_table->setEditingHeight(VariableModel::Value, widgets::ValueDelegate::editingHeight);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setEditTriggers(
        QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed | QAbstractItemView::AnyKeyPressed);
    m_table->verticalHeader()->hide();
    m_table->installEventFilter(this);
    m_sentence->setObjectName(QStringLiteral("sentence"));
    m_note->setObjectName(QStringLiteral("note"));
    m_head->addStretch();
    m_head->addWidget(m_goTo);
    connect(m_goTo, &QLineEdit::returnPressed, this, &VariableSheet::goTo);
    makeFoot();
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(ui::space::gap);
    column->addLayout(m_head);
    column->addWidget(m_sentence);
    column->addWidget(m_table, 1);
    column->addLayout(m_foot);
    column->addWidget(m_note);
    connect(m_table, &widgets::Table::rowsInViewChanged, this, &VariableSheet::topicsChanged);
    connect(delegate, &widgets::ValueDelegate::dropped, this, [this](const QModelIndex &index, const QString &typed) {
        const QString name = toString(m_model->at(index.row()));
        say(tr("%1 stays as it is: %2", "variable: reason").arg(name, m_model->complaint(index, typed)));
    });
    connect(m_table, &QTableView::doubleClicked, this, &VariableSheet::openEditor);
    connect(m_transfer, &VariableTransfer::topicsChanged, this, &VariableSheet::topicsChanged);
    connect(m_transfer, &VariableTransfer::said, this, &VariableSheet::say);
    connect(&m_desk.edits, &robot::Edits::changed, this, &VariableSheet::showEdits);
    connect(&m_desk.edits, &robot::Edits::changed, this, &VariableSheet::topicsChanged);
    showEdits();
}

void VariableSheet::addToHead(QWidget *widget) { m_head->insertWidget(m_head->count() - 2, widget); }

void VariableSheet::addToFoot(QWidget *widget)
{
    m_foot->insertWidget(m_foot->count() - 3, widget);
    m_foot->setAlignment(widget, Qt::AlignTop);
}

void VariableSheet::makeFoot()
{
    auto *importButton = sheetButton("importButton", tr("Import…"));
    auto *exportButton = sheetButton("exportButton", tr("Export…"));
    m_apply->button()->setProperty("primary", true);
    for (QWidget *widget : std::initializer_list<QWidget *> {m_apply, m_discard, m_undo})
        m_foot->addWidget(widget);
    m_foot->addStretch();
    m_foot->addWidget(importButton);
    m_foot->addWidget(exportButton);
    for (QWidget *widget : std::initializer_list<QWidget *> {m_apply, m_discard, m_undo, importButton, exportButton})
        m_foot->setAlignment(widget, Qt::AlignTop);
    connect(m_apply, &widgets::OrderButton::clicked, this, &VariableSheet::openApply);
    connect(
        m_discard, &QPushButton::clicked, this, [this] { m_desk.edits.discard(own(m_desk.edits.staged().edits())); });
    connect(m_undo, &QPushButton::clicked, &m_desk.edits, &robot::Edits::undo);
    connect(importButton, &QPushButton::clicked, this, &VariableSheet::importFile);
    connect(exportButton, &QPushButton::clicked, this, &VariableSheet::exportFile);
}

void VariableSheet::show(VariableModel *model)
{
    m_model = model;
    m_table->setModel(model);
    auto *head = m_table->horizontalHeader();
    const auto isLong = [](const Reference &variable) { return isPosition(variable.kind); };
    const bool hasPositions = std::ranges::any_of(model->variables(), isLong);
    const int widths[] {80, hasPositions ? 140 : 230, hasPositions ? 570 : 200, hasPositions ? 90 : 130, 90};
    for (int column = 0; column < int(std::size(widths)); ++column)
        head->resizeSection(column, widths[column]);
    head->setStretchLastSection(true);
    if (model->rowCount() > 0)
        m_table->setCurrentIndex(model->index(0, VariableModel::Value));
    Q_EMIT topicsChanged();
}

QList<robot::TopicRange> VariableSheet::topics() const
{
    QList<robot::TopicRange> result = m_transfer->topics();
    for (const Reference &variable : own(m_desk.edits.staged().edits()))
        result << robot::TopicRange {robot::topicOf(variable)};
    if (!m_model)
        return result;
    const auto rows = m_table->rowsInView();
    for (int row = rows.first; row <= std::min(rows.last, m_model->rowCount() - 1); ++row)
        result << robot::TopicRange {robot::topicOf(m_model->at(row))};
    return result;
}

bool VariableSheet::select(const Reference &variable)
{
    const int row = m_model->rowOf(variable);
    if (row < 0)
        return false;
    const QModelIndex index = m_model->index(row, VariableModel::Value);
    m_table->setCurrentIndex(index);
    m_table->scrollTo(index, QAbstractItemView::PositionAtCenter);
    m_table->setFocus();
    return true;
}

/// A reference, or the words of a name.
void VariableSheet::goTo()
{
    auto variable = variables::referenceFromText(m_goTo->text(), m_desk.dialect);
    if (!variable) {
        const auto found = m_desk.book.names().findVariables(m_goTo->text(), 1);
        if (found.isEmpty() || m_goTo->text().trimmed().isEmpty())
            return say(variable.error().detail);
        variable = found.first();
    }
    say({});
    if (!select(*variable))
        Q_EMIT wanted(*variable);
}

void VariableSheet::say(const QString &sentence, bool isTrouble)
{
    m_sentence->setRole(isTrouble ? ui::Role::Amber : ui::Role::Text2);
    m_sentence->setWords(sentence);
}

void VariableSheet::setNote(const QString &note) { m_note->setWords(note); }

bool VariableSheet::eventFilter(QObject *watched, QEvent *event)
{
    if (watched != m_table || event->type() != QEvent::KeyPress || m_table->isEditing())
        return QWidget::eventFilter(watched, event);
    const auto *key = static_cast<QKeyEvent *>(event);
    if (key->matches(QKeySequence::Copy))
        return m_transfer->copy(selected()), true;
    if (key->matches(QKeySequence::Paste))
        return paste(), true;
    if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter)
        return openEditor(m_table->currentIndex().siblingAtColumn(VariableModel::Value)), true;
    if (key->key() == Qt::Key_Delete && m_table->currentIndex().isValid())
        return m_desk.edits.discard(m_model->at(m_table->currentIndex().row())), true;
    return QWidget::eventFilter(watched, event);
}

void VariableSheet::openEditor(const QModelIndex &index)
{
    if (!index.isValid() || index.column() != VariableModel::Value)
        return;
    const Reference variable = m_model->at(index.row());
    if (!m_model->isWritable(index.row()))
        return say(tr("%1 can only be read over HSES.").arg(toString(variable)));
    if (isPosition(variable.kind))
        return editPosition(variable);
    m_table->setCurrentIndex(index);
    m_table->edit(index);
}

void VariableSheet::editPosition(const Reference &variable)
{
    const auto *edit = m_desk.edits.staged().find(variable);
    const auto value = edit ? std::optional {edit->value} : now(variable);
    auto *dialog = new dialogs::PositionDialog(m_orders, variable, value, m_desk.format, this);
    const auto showLive = [this, dialog, variable] {
        const auto live = now(variable);
        dialog->showLive(live ? toText(*live, m_desk.format) : widgets::dash());
    };
    connect(&m_desk.history, &robot::VariableHistory::changed, dialog, showLive);
    connect(dialog, &dialogs::PositionDialog::valueAccepted, this,
        [this, variable](const variables::Value &typed) { m_desk.edits.stage(variable, typed); });
    showLive();
    dialog->show();
}

std::optional<variables::Value> VariableSheet::now(const Reference &variable) const
{
    return readingOf(m_desk.state, variable).value;
}

QString VariableSheet::controllerName() const { return m_orders.controller().profile().name; }

void VariableSheet::showEdits()
{
    const int count = int(own(m_desk.edits.staged().toApply()).size());
    const bool isApplying = m_desk.edits.isApplying();
    m_apply->setText(isApplying ? tr("Writing…") : tr("Apply %n…", nullptr, count));
    m_apply->setComplaint(isApplying ? tr("The values are being written.")
            : count == 0             ? tr("Nothing is staged: press Enter in a value.")
                                     : QString());
    m_discard->setEnabled(count > 0 && !isApplying);
    m_undo->setEnabled(!own(m_desk.edits.staged().undoable()).isEmpty() && !isApplying);
    m_discard->setToolTip(m_discard->isEnabled() ? QString() : tr("Nothing is staged."));
    m_undo->setToolTip(m_undo->isEnabled() ? tr("Stages the values that stood there before.")
                                           : tr("Nothing was written that could be undone."));
}

void VariableSheet::openApply()
{
    (new dialogs::ApplyDialog(
         m_desk.edits, own(m_desk.edits.staged().toApply()), controllerName(), m_desk.format, this))
        ->show();
}

QList<Reference> VariableSheet::own(const QList<variables::Edit> &edits) const
{
    const bool areRegisters = m_act == robot::Act::WriteRegister;
    QList<Reference> result;
    for (const auto &edit : edits) {
        if ((edit.variable.kind == variables::Kind::M) == areRegisters)
            result << edit.variable;
    }
    return result;
}

QList<Reference> VariableSheet::selected() const
{
    QList<Reference> result;
    for (const QModelIndex &row : m_table->selectionModel()->selectedRows())
        result << m_model->at(row.row());
    return result;
}

void VariableSheet::paste()
{
    if (const QModelIndex current = m_table->currentIndex(); current.isValid())
        m_transfer->paste(m_model->at(current.row()));
}

void VariableSheet::importFile()
{
    widgets::askForPath(
        {"importFileDialog", widgets::PathKind::OldFile, tr("Import values"), {}, {tr("CSV files (*.csv)")}}, this,
        [this](const QString &path) { m_transfer->importFrom(path); });
}

void VariableSheet::exportFile()
{
    widgets::askForPath({"exportFileDialog", widgets::PathKind::NewFile, tr("Export values"), {},
                            {tr("CSV files (*.csv)")}, QStringLiteral("csv")},
        this, [this](const QString &path) { m_transfer->exportTo(path, m_model->variables()); });
}

} // namespace pages
