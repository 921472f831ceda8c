// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/celleditor.h"

#include "ui/widgets/text.h"
#include <QFocusEvent>
#include <QValidator>

namespace widgets {

namespace {

constexpr int fieldHeight = 28;

/// Takes every text while it is typed, and Enter only with one that is a value.
class Judge : public QValidator
{
public:
    Judge(const CellEditor::Check &check, QObject *parent) : QValidator(parent), m_check {check} { }
    State validate(QString &text, int &) const override { return m_check(text).isEmpty() ? Acceptable : Intermediate; }

private:
    CellEditor::Check m_check;
};

} // namespace

CellEditor::CellEditor(const QString &text, const QString &hint, Check check, QWidget *parent)
    : QLineEdit(text, parent),
      m_hint {hint},
      m_check {std::move(check)},
      m_liveLabel {widgets::text({}, ui::Type::Label, ui::Role::Text2, parent)},
      m_hintLabel {widgets::text(hint, ui::Type::Body, ui::Role::Text2, parent)}
{
    setObjectName(QStringLiteral("cellEditor"));
    m_liveLabel->setObjectName(QStringLiteral("liveLabel"));
    m_hintLabel->setObjectName(QStringLiteral("hintLabel"));
    m_liveLabel->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setAlignment(Qt::AlignRight);
    setValidator(new Judge(m_check, this));
    connect(this, &QLineEdit::textChanged, this, &CellEditor::judge);
    m_liveLabel->show();
    m_hintLabel->show();
    judge();
}

CellEditor::~CellEditor()
{
    delete m_liveLabel;
    delete m_hintLabel;
}

void CellEditor::showLive(const QString &text) { m_liveLabel->setText(tr("live: %1").arg(text)); }

void CellEditor::place(const QRect &field, const QRect &live, const QRect &hint)
{
    setGeometry(field);
    m_liveLabel->setGeometry(live);
    m_hintLabel->setGeometry(hint);
    for (QLabel *label : {m_liveLabel.data(), m_hintLabel.data()}) { // they cover what the cells say
        QPalette ground = label->palette();
        ground.setColor(QPalette::Window, ui::color(ui::Role::AccentGround, this));
        label->setPalette(ground);
        label->setBackgroundRole(QPalette::Window);
        label->setAutoFillBackground(true);
    }
}

void CellEditor::leave()
{
    if (!hasAcceptableInput())
        Q_EMIT dropped(text());
}

void CellEditor::judge()
{
    const QString complaint = m_check(text());
    m_hintLabel->setText(complaint.isEmpty() ? m_hint : complaint);
    m_hintLabel->setToolTip(m_hintLabel->text());
    setTextRole(m_hintLabel, complaint.isEmpty() ? ui::Role::Text2 : ui::Role::Amber);
    setAccessibleDescription(m_hintLabel->text());
}

ValueDelegate::ValueDelegate(Columns columns, Roles roles, Check check, QObject *parent)
    : TableDelegate(parent), m_columns {columns}, m_roles {roles}, m_check {std::move(check)}
{
}

QWidget *ValueDelegate::createEditor(
    QWidget *parent, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    if (index.column() != m_columns.value) {
        auto *field = new QLineEdit(index.data(Qt::EditRole).toString(), parent);
        field->setObjectName(QStringLiteral("textEditor"));
        field->setAccessibleName(index.data(Qt::AccessibleTextRole).toString());
        return field;
    }
    const QPersistentModelIndex at(index);
    const auto check = [this, at](const QString &typed) { return at.isValid() ? m_check(at, typed) : QString(); };
    auto *editor =
        new CellEditor(index.data(Qt::EditRole).toString(), index.data(m_roles.hint).toString(), check, parent);
    connect(editor, &CellEditor::dropped, this, [this, at](const QString &typed) {
        if (at.isValid())
            Q_EMIT dropped(at, typed);
    });
    editor->setFont(option.font);
    editor->setAccessibleName(index.data(Qt::AccessibleTextRole).toString());
    return editor;
}

/// Called on every change of the cell, which must not reach what is typed.
void ValueDelegate::setEditorData(QWidget *editor, const QModelIndex &index) const
{
    if (auto *cell = qobject_cast<CellEditor *>(editor))
        cell->showLive(index.data(m_roles.live).toString());
}

void ValueDelegate::setModelData(QWidget *editor, QAbstractItemModel *model, const QModelIndex &index) const
{
    if (const auto *field = qobject_cast<QLineEdit *>(editor))
        model->setData(index, field->text());
}

/// Another window in front ends no typing: it goes on where it was when this one comes back.
bool ValueDelegate::eventFilter(QObject *editor, QEvent *event)
{
    const bool isLeaving = event->type() == QEvent::FocusOut;
    if (isLeaving && static_cast<QFocusEvent *>(event)->reason() == Qt::ActiveWindowFocusReason)
        return false;
    const bool isHandled = TableDelegate::eventFilter(editor, event);
    if (auto *cell = qobject_cast<CellEditor *>(editor); cell && isLeaving && cell->isHidden())
        cell->leave();
    return isHandled;
}

void ValueDelegate::updateEditorGeometry(
    QWidget *editor, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    auto *cell = qobject_cast<CellEditor *>(editor);
    if (!cell)
        return editor->setGeometry(option.rect);
    const auto *view = qobject_cast<const QTableView *>(option.widget);
    const QRect row = option.rect;
    const QRect hint = view ? view->visualRect(index.siblingAtColumn(m_columns.hint)) : QRect();
    cell->place({row.left(), row.top(), row.width(), fieldHeight},
        {row.left(), row.top() + fieldHeight, row.width() - 8, editingHeight - fieldHeight - 1},
        hint.adjusted(8, 1, -8, -2));
}

} // namespace widgets
