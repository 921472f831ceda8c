// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/widgets/table.h"
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <functional>

namespace widgets {

/// Edits one value in a table. The poll never touches what is typed: under the field stands what is live, and beside it
/// what the field takes, or why it does not take this. Enter is only accepted with a value.
class CellEditor : public QLineEdit
{
    Q_OBJECT

public:
    /// Why a text is no value, in a sentence; empty if it is one.
    using Check = std::function<QString(const QString &typed)>;

    CellEditor(const QString &text, const QString &hint, Check check, QWidget *parent);
    ~CellEditor() override;

    void showLive(const QString &text);
    /// Where the field and the two labels stand.
    void place(const QRect &field, const QRect &live, const QRect &hint);
    /// The field was left: a text that is no value goes, and that is told.
    void leave();

Q_SIGNALS:
    void dropped(const QString &typed);

private:
    void judge();

    QString m_hint;
    Check m_check;
    QPointer<QLabel> m_liveLabel;
    QPointer<QLabel> m_hintLabel;
};

/// Paints a table and edits its values with CellEditor. The other editable columns get a plain field.
class ValueDelegate : public TableDelegate
{
    Q_OBJECT

Q_SIGNALS:
    /// An editor was left with a text that is no value.
    void dropped(const QModelIndex &index, const QString &typed) const;

public:
    struct Columns {
        int value;
        int hint; ///< The column that lends its room to the hint.
    };
    struct Roles {
        int live;
        int hint;
    };
    using Check = std::function<QString(const QModelIndex &index, const QString &typed)>;

    ValueDelegate(Columns columns, Roles roles, Check check, QObject *parent);

    static constexpr int editingHeight = 52; ///< Of a row with an open editor.

    QWidget *createEditor(QWidget *parent, const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    void setEditorData(QWidget *editor, const QModelIndex &index) const override;
    void setModelData(QWidget *editor, QAbstractItemModel *model, const QModelIndex &index) const override;
    void updateEditorGeometry(
        QWidget *editor, const QStyleOptionViewItem &option, const QModelIndex &index) const override;

protected:
    bool eventFilter(QObject *editor, QEvent *event) override;

private:
    Columns m_columns;
    Roles m_roles;
    Check m_check;
};

} // namespace widgets
