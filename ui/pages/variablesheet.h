// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/models/variablemodel.h"
#include "ui/pages/page.h"
#include "ui/widgets/table.h"

class QLabel;
class QPushButton;

namespace widgets {
class Flow;
class GoToEdit;
class Line;
class OrderButton;
} // namespace widgets

namespace dialogs {
class PositionDialog;
}

namespace pages {

class VariableTransfer;

/// A table of variables or registers with everything that is done to them: go to, edit, stage, apply, undo, paste, CSV.
/// The variables and the registers page are made of it.
class VariableSheet : public QWidget
{
    Q_OBJECT

public:
    /// `act` is what Apply does. All of it must outlive the sheet.
    VariableSheet(const Context &context, const models::VariableDesk &desk, robot::Act act, QWidget *parent = nullptr);

    void show(models::VariableModel *model);
    using QWidget::show;
    [[nodiscard]] models::VariableModel *model() const { return m_model; }
    [[nodiscard]] widgets::Table *table() const { return m_table; }
    /// What the poller must read: the rows that can be seen, what is staged wherever it stands, and what is being
    /// imported or exported.
    [[nodiscard]] QList<robot::TopicRange> topics() const;
    /// Makes the row current; false if it is not in this table.
    bool select(const variables::Reference &variable);
    /// A sentence beside the buttons, such as that about the numbering.
    void setNote(const QString &note);
    /// At the left end of the line above the table.
    void addToHead(QWidget *widget);
    /// Beside the buttons below it.
    void addToFoot(QWidget *widget);

Q_SIGNALS:
    void topicsChanged();
    /// A variable of another table was asked for.
    void wanted(const variables::Reference &variable);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void makeFoot();
    void goTo();
    void say(const QString &sentence, bool isTrouble = true);
    void openEditor(const QModelIndex &index);
    void editPosition(const variables::Reference &variable);
    void showEdits();
    void openApply();
    /// Of these edits, those of variables or of registers, whichever this sheet is for.
    [[nodiscard]] QList<variables::Reference> own(const QList<variables::Edit> &edits) const;
    [[nodiscard]] QList<variables::Reference> selected() const;
    void paste();
    void importFile();
    void exportFile();
    [[nodiscard]] std::optional<variables::Value> now(const variables::Reference &variable) const;
    [[nodiscard]] QString controllerName() const;

    models::VariableDesk m_desk;
    robot::Orders &m_orders;
    robot::Act m_act;
    models::VariableModel *m_model = nullptr;
    widgets::Table *m_table;
    widgets::Flow *m_head;
    widgets::Flow *m_foot;
    widgets::GoToEdit *m_goTo;
    widgets::Line *m_sentence;
    widgets::Line *m_note;
    widgets::OrderButton *m_apply;
    QPushButton *m_discard;
    QPushButton *m_undo;
    VariableTransfer *m_transfer;
};

} // namespace pages
