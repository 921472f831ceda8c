// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/models/variablemodel.h"

#include "protocol/codes.h"
#include "ui/widgets/shown.h"
#include "ui/widgets/table.h"
#include <QLocale>

namespace models {

using robot::Freshness;
using variables::Edit;
using variables::EditState;
using variables::Reference;

namespace {

/// Why there is no value stands where a position would stand: there is room, and one that was never taught is no fault.
bool isRefusedHere(const robot::VariableReading &reading, const Reference &variable)
{
    return isPosition(variable.kind) && reading.freshness == Freshness::Refused && reading.refusal;
}

bool isEmptyText(const variables::Value &value)
{
    const auto *string = std::get_if<values::StringVariable32>(&value);
    return string && string->value.bytes().isEmpty();
}

} // namespace

VariableModel::VariableModel(const VariableDesk &desk, QList<Reference> variables, QObject *parent)
    : QAbstractTableModel(parent), m_desk {desk}, m_variables {std::move(variables)}
{
    reindex();
    connect(&desk.history, &robot::VariableHistory::changed, this, &VariableModel::onVariablesChanged);
    connect(&desk.edits, &robot::Edits::changed, this, [this] { refresh(Value, Note); });
    connect(&desk.book, &robot::NameBook::changed, this, [this] { refresh(Name, Note); });
}

void VariableModel::reindex()
{
    m_rows.clear();
    for (int row = 0; row < m_variables.size(); ++row)
        m_rows.insert(m_variables[row], row);
}

void VariableModel::append(const Reference &variable)
{
    if (m_rows.contains(variable))
        return;
    const int row = int(m_variables.size());
    beginInsertRows({}, row, row);
    m_variables += variable;
    m_rows.insert(variable, row);
    endInsertRows();
}

void VariableModel::removeAt(int row)
{
    beginRemoveRows({}, row, row);
    m_variables.removeAt(row);
    reindex();
    endRemoveRows();
}

void VariableModel::formatChanged() { refresh(Value, Note); }

bool VariableModel::isWritable(int row) const
{
    const Reference variable = at(row);
    return variable.number < writableCountOf(variable.kind, m_desk.dialect);
}

void VariableModel::onVariablesChanged(const variables::Range &range)
{
    int first = int(m_variables.size());
    int last = -1;
    for (int number = range.first; number <= range.last; ++number) {
        if (const int row = rowOf({range.kind, number}); row >= 0) {
            first = std::min(first, row);
            last = std::max(last, row);
        }
    }
    if (last >= 0)
        Q_EMIT dataChanged(index(first, Value), index(last, Note));
}

void VariableModel::refresh(int firstColumn, int lastColumn)
{
    if (!m_variables.isEmpty())
        Q_EMIT dataChanged(index(0, firstColumn), index(int(m_variables.size()) - 1, lastColumn));
}

int VariableModel::rowCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : int(m_variables.size()); }

int VariableModel::columnCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : columns; }

QVariant VariableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    const bool isNumber = section == Value || section == Previous;
    if (role == Qt::TextAlignmentRole)
        return int((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Number: return tr("Number");
    case Name: return tr("Name");
    case Value: return tr("Value");
    case Previous: return tr("Previous");
    case Changed: return tr("Changed");
    case Note: return tr("Note");
    default: return {};
    }
}

QString VariableModel::text(const std::optional<variables::Value> &value) const
{
    if (!value)
        return widgets::dash();
    return isEmptyText(*value) ? tr("(empty)") : toText(*value, m_desk.format);
}

VariableModel::Cell VariableModel::cell(const QModelIndex &index) const
{
    const Reference variable = at(index.row());
    switch (index.column()) {
    case Number: return {toString(variable)};
    case Name: return nameCell(variable);
    case Value: return valueCell(variable);
    case Previous: return {text(m_desk.history.of(variable).previous), int(ui::Role::Text2)};
    case Changed: {
        const QDateTime changed = m_desk.history.of(variable).changed;
        return {changed.isValid() ? changed.time().toString(QStringLiteral("HH:mm:ss")) : widgets::dash(),
            int(ui::Role::Text2)};
    }
    case Note: return noteCell(variable);
    default: return {};
    }
}

VariableModel::Cell VariableModel::nameCell(const Reference &variable) const
{
    const names::Name name = m_desk.book.names().of(variable);
    if (name.text.isEmpty())
        return {widgets::dash(), int(ui::Role::Text3)};
    return {name.isLocal ? tr("%1 (local)").arg(name.text) : name.text};
}

/// The row above tells the same reason.
bool VariableModel::isRefusedAbove(const robot::VariableReading &reading, const Reference &variable) const
{
    const int row = rowOf(variable);
    if (row < 1)
        return false;
    const auto above = readingOf(m_desk.state, at(row - 1));
    return isRefusedHere(above, at(row - 1)) && *above.refusal == *reading.refusal;
}

VariableModel::Cell VariableModel::valueCell(const Reference &variable) const
{
    if (const Edit *edit = m_desk.edits.staged().find(variable))
        return editCell(*edit);
    const auto reading = readingOf(m_desk.state, variable);
    if (reading.freshness == Freshness::Live && reading.value)
        return {text(reading.value), isEmptyText(*reading.value) ? int(ui::Role::Text2) : -1};
    if (isRefusedHere(reading, variable) && protocol::isNotTaught(*reading.refusal))
        return {widgets::notTaught(), int(ui::Role::Text2)};
    if (isRefusedHere(reading, variable)) // the reason once; the rows below have it in their tool tips
        return {isRefusedAbove(reading, variable) ? tr("refused") : protocol::explain(*reading.refusal),
            int(ui::Role::Text2)};
    const bool isStale = reading.freshness == Freshness::Stale && reading.value;
    return {text(isStale ? reading.value : std::nullopt), int(ui::Role::Text3), -1, isStale};
}

/// A position fills the cell: of two only the one that matters stands there, both are in the tool tip.
VariableModel::Cell VariableModel::editCell(const Edit &edit) const
{
    const bool isMismatch = edit.state == EditState::Mismatch;
    const QString words = !variables::isPosition(edit.variable.kind) ? editWords(edit)
        : isMismatch                                                 ? tr("reads %1").arg(text(edit.readBack))
                                                                     : tr("→ %1", "new value").arg(text(edit.value));
    return {words, int(isMismatch ? ui::Role::Alarm : ui::Role::Amber),
        int(isMismatch ? ui::Role::AlarmGround : ui::Role::AmberGround)};
}

QString VariableModel::editWords(const Edit &edit) const
{
    if (edit.state == EditState::Mismatch)
        return tr("wrote %1, reads %2").arg(text(edit.value), text(edit.readBack));
    const QString was = text(edit.state == EditState::Staged ? readingOf(m_desk.state, edit.variable).value : edit.was);
    return tr("%1 → %2", "old and new value").arg(was, text(edit.value));
}

QString VariableModel::editNote(const Edit &edit) const
{
    const QString reason = edit.error ? protocol::explain(*edit.error) : QString();
    switch (edit.state) {
    case EditState::Staged: return reason.isEmpty() ? tr("not sent yet") : tr("not sent: %1").arg(reason);
    case EditState::Writing: return tr("being written…");
    case EditState::Refused: return tr("refused: %1").arg(reason);
    case EditState::Unknown: return tr("outcome unknown, look at the robot: %1").arg(reason);
    case EditState::Mismatch: return tr("accepted, but another value was read back");
    }
    return {};
}

VariableModel::Cell VariableModel::noteCell(const Reference &variable) const
{
    if (const Edit *edit = m_desk.edits.staged().find(variable)) {
        const bool isMismatch = edit->state == EditState::Mismatch;
        return {editNote(*edit), int(isMismatch ? ui::Role::Alarm : ui::Role::Amber)};
    }
    const auto reading = readingOf(m_desk.state, variable);
    if (reading.freshness == Freshness::Refused && reading.refusal && !isRefusedHere(reading, variable))
        return {protocol::explain(*reading.refusal), int(ui::Role::Amber)};
    return {m_desk.book.remark(variable), int(ui::Role::Text2)};
}

QVariant VariableModel::editText(const QModelIndex &index) const
{
    const Reference variable = at(index.row());
    switch (index.column()) {
    case Name: return m_desk.book.names().of(variable).text;
    case Note: return m_desk.book.remark(variable);
    case Value: break;
    default: return {};
    }
    if (const Edit *edit = m_desk.edits.staged().find(variable))
        return toText(edit->value, m_desk.format);
    const auto reading = readingOf(m_desk.state, variable);
    return reading.value ? toText(*reading.value, m_desk.format) : QString();
}

QString VariableModel::toolTip(const QModelIndex &index) const
{
    const Reference variable = at(index.row());
    const auto reading = readingOf(m_desk.state, variable);
    switch (index.column()) {
    case Name: {
        const QString own = m_desk.book.names().own(variable);
        const bool isLocal = m_desk.book.names().of(variable).isLocal;
        return isLocal && !own.isEmpty() ? tr("The controller calls it “%1”.").arg(own) : QString();
    }
    case Value:
        if (const Edit *edit = m_desk.edits.staged().find(variable))
            return editWords(*edit);
        if (reading.freshness == Freshness::Stale)
            return widgets::lastSeen(reading.clock);
        return reading.refusal ? protocol::explain(*reading.refusal) : cell(index).text;
    case Previous:
    case Note: return cell(index).text;
    default: return {};
    }
}

QString VariableModel::accessibleText(const QModelIndex &index) const
{
    const QString head = headerData(index.column(), Qt::Horizontal, Qt::DisplayRole).toString();
    QString words = tr("%1, %2: %3", "B007, value: 17").arg(toString(at(index.row())), head, cell(index).text);
    const bool isStale = readingOf(m_desk.state, at(index.row())).freshness == Freshness::Stale;
    return index.column() == Value && isStale ? tr("%1. %2").arg(words, toolTip(index)) : words;
}

QVariant VariableModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const auto orNothing = [](int value) { return value < 0 ? QVariant() : QVariant(value); };
    const bool isNumber = index.column() == Value || index.column() == Previous;
    switch (role) {
    case Qt::DisplayRole: return cell(index).text;
    case Qt::EditRole: return editText(index);
    case Qt::ToolTipRole: return toolTip(index);
    case Qt::AccessibleTextRole: return accessibleText(index);
    case Qt::TextAlignmentRole: return int((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    case LiveTextRole: return text(readingOf(m_desk.state, at(index.row())).value);
    case RangeTextRole: return rangeText(at(index.row()).kind, m_desk.format);
    case ReferenceRole: return toString(at(index.row()));
    case widgets::InkRole: return orNothing(cell(index).ink);
    case widgets::GroundRole: return orNothing(cell(index).ground);
    case widgets::HatchedRole: return cell(index).isHatched;
    case widgets::BoldRole: return index.column() == Value && cell(index).ink != int(ui::Role::Text2);
    default: return {};
    }
}

Qt::ItemFlags VariableModel::flags(const QModelIndex &index) const
{
    Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    const bool isText = index.column() == Name || index.column() == Note;
    const bool isValue = index.column() == Value && index.isValid() && isWritable(index.row())
        && !variables::isPosition(at(index.row()).kind);
    return isText || isValue ? flags | Qt::ItemIsEditable : flags;
}

QString VariableModel::complaint(const QModelIndex &index, const QString &typed) const
{
    const auto value = fromText(at(index.row()).kind, typed, m_desk.format);
    return value ? QString() : value.error().detail;
}

bool VariableModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (!index.isValid() || role != Qt::EditRole || !(flags(index) & Qt::ItemIsEditable))
        return false;
    const Reference variable = at(index.row());
    const QString typed = value.toString();
    if (index.column() == Name) {
        m_desk.book.setLocalName(variable, typed == m_desk.book.names().own(variable) ? QString() : typed);
        return true;
    }
    if (index.column() == Note) {
        m_desk.book.setRemark(variable, typed);
        return true;
    }
    const auto read = fromText(variable.kind, typed, m_desk.format);
    if (read)
        m_desk.edits.stage(variable, *read);
    return read.has_value();
}

} // namespace models
