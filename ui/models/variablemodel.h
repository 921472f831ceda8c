// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/edits.h"
#include "robot/namebook.h"
#include "robot/variablehistory.h"
#include <QAbstractTableModel>

namespace models {

/// What the variables of one controller are shown from. All of it outlives the models.
struct VariableDesk {
    const robot::RobotState &state;
    const robot::VariableHistory &history;
    robot::Edits &edits;
    robot::NameBook &book;
    variables::Format &format; ///< Say formatChanged() after a change.
    protocol::Dialect dialect;
};

/// Variables or registers, one a row. Rows change in place; while a cell is edited the poll only moves what it says is
/// live. What was typed is staged, never sent.
class VariableModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Number, Name, Value, Previous, Changed, Note, columns };
    enum Role {
        LiveTextRole = Qt::UserRole, ///< The value that was read last, or "—".
        RangeTextRole, ///< What the editor takes: "0 … 255".
        ReferenceRole, ///< "B007"
    };

    VariableModel(const VariableDesk &desk, QList<variables::Reference> variables, QObject *parent = nullptr);

    [[nodiscard]] const QList<variables::Reference> &variables() const { return m_variables; }
    [[nodiscard]] variables::Reference at(int row) const { return m_variables[row]; }
    /// -1 if it is not there.
    [[nodiscard]] int rowOf(const variables::Reference &variable) const { return m_rows.value(variable, -1); }
    /// For watch pages. One that is there already stays where it is.
    void append(const variables::Reference &variable);
    void removeAt(int row);
    /// Values are written in another way now.
    void formatChanged();
    [[nodiscard]] bool isWritable(int row) const;

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override;
    /// Value stages what was typed, Name gives a local name, Note keeps a remark. False if the text is no value: see
    /// complaint().
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;
    /// Why the text cannot be the value of that row, in a sentence; empty if it can.
    [[nodiscard]] QString complaint(const QModelIndex &index, const QString &typed) const;

private:
    struct Cell {
        QString text;
        int ink = -1; ///< ui::Role; -1 for the usual one.
        int ground = -1;
        bool isHatched = false;
    };

    void reindex();
    void onVariablesChanged(const variables::Range &range);
    void refresh(int firstColumn, int lastColumn);
    [[nodiscard]] QString text(const std::optional<variables::Value> &value) const;
    [[nodiscard]] Cell cell(const QModelIndex &index) const;
    [[nodiscard]] Cell valueCell(const variables::Reference &variable) const;
    [[nodiscard]] bool isRefusedAbove(
        const robot::VariableReading &reading, const variables::Reference &variable) const;
    [[nodiscard]] Cell editCell(const variables::Edit &edit) const;
    [[nodiscard]] QString editWords(const variables::Edit &edit) const;
    [[nodiscard]] Cell nameCell(const variables::Reference &variable) const;
    [[nodiscard]] Cell noteCell(const variables::Reference &variable) const;
    [[nodiscard]] QString editNote(const variables::Edit &edit) const;
    [[nodiscard]] QVariant editText(const QModelIndex &index) const;
    [[nodiscard]] QString toolTip(const QModelIndex &index) const;
    [[nodiscard]] QString accessibleText(const QModelIndex &index) const;

    VariableDesk m_desk;
    QList<variables::Reference> m_variables;
    QHash<variables::Reference, int> m_rows;
};

} // namespace models
