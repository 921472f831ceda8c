// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "variables/stagededits.h"

#include <utility>

namespace variables {

void StagedEdits::stage(const Reference &variable, const Value &value, const std::optional<Value> &now)
{
    const auto found = m_edits.find(variable);
    if (found != m_edits.end() && found->second.state == EditState::Writing)
        return;
    if (now && isSame(*now, value))
        m_edits.erase(variable);
    else
        m_edits.insert_or_assign(variable, Edit {variable, now, value, EditState::Staged, {}, {}});
}

void StagedEdits::discard(const Reference &variable)
{
    if (const auto *edit = find(variable); edit && edit->state != EditState::Writing)
        m_edits.erase(variable);
}

void StagedEdits::clear()
{
    std::erase_if(m_edits, [](const auto &entry) { return entry.second.state != EditState::Writing; });
}

const Edit *StagedEdits::find(const Reference &variable) const
{
    const auto found = m_edits.find(variable);
    return found == m_edits.end() ? nullptr : &found->second;
}

QList<Edit> StagedEdits::edits() const
{
    QList<Edit> result;
    for (const auto &[variable, edit] : m_edits)
        result += edit;
    return result;
}

QList<Edit> StagedEdits::toApply() const
{
    QList<Edit> result = edits();
    result.removeIf([](const Edit &edit) { return edit.state == EditState::Writing; });
    return result;
}

void StagedEdits::setWriting(const Reference &variable, const std::optional<Value> &now)
{
    const auto found = m_edits.find(variable);
    Q_ASSERT(found != m_edits.end());
    const Value value = found->second.value;
    found->second = Edit {variable, now, value, EditState::Writing, {}, {}};
}

Edit *StagedEdits::writing(const Reference &variable)
{
    const auto found = m_edits.find(variable);
    const bool isWriting = found != m_edits.end() && found->second.state == EditState::Writing;
    return isWriting ? &found->second : nullptr;
}

void StagedEdits::setFailed(const Reference &variable, EditState state, const values::Error &error)
{
    if (Edit *edit = writing(variable)) {
        edit->state = state;
        edit->error = error;
    }
}

void StagedEdits::setNotSent(const Reference &variable, const values::Error &error)
{
    setFailed(variable, EditState::Staged, error);
}

void StagedEdits::setRefused(const Reference &variable, const values::Error &error)
{
    setFailed(variable, EditState::Refused, error);
}

void StagedEdits::setUnknown(const Reference &variable, const values::Error &error)
{
    setFailed(variable, EditState::Unknown, error);
}

void StagedEdits::setReadBack(const Reference &variable, const Value &value)
{
    Edit *edit = writing(variable);
    if (!edit)
        return;
    if (isSame(edit->value, value)) {
        if (std::exchange(m_isNewBatch, false))
            m_batches.emplace_back();
        m_batches.last() += *edit;
        m_edits.erase(variable);
    } else {
        edit->state = EditState::Mismatch;
        edit->readBack = value;
    }
}

QList<Edit> StagedEdits::undoable() const
{
    QList<Edit> result;
    if (m_batches.isEmpty())
        return result;
    for (const Edit &done : m_batches.last()) {
        if (done.was)
            result += Edit {done.variable, done.value, *done.was, EditState::Staged, {}, {}};
    }
    return result;
}

void StagedEdits::undo()
{
    for (const Edit &edit : undoable())
        stage(edit.variable, edit.value, edit.was);
    if (!m_batches.isEmpty())
        m_batches.removeLast();
    beginBatch();
}

} // namespace variables
