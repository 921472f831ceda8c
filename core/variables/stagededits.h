// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "variables/value.h"
#include <map>

namespace variables {

/// How far an edit has come. A verified one is no edit any more.
enum class EditState {
    Staged, ///< Not sent yet.
    Writing, ///< Sent; neither answered nor read back.
    Refused, ///< The controller refused it: see Edit::error. Nothing was changed.
    Unknown, ///< Sent once and not answered, or not read back: it may or may not have happened.
    Mismatch, ///< Accepted, but another value was read back.
};

/// A value that somebody wants a variable to have.
struct Edit {
    Reference variable;
    std::optional<Value> was; ///< When it was staged, then when it was sent; nullopt if it was never read.
    Value value;
    EditState state = EditState::Staged;
    std::optional<values::Error> error; ///< With Refused and Unknown; with Staged, why it could not be sent.
    std::optional<Value> readBack; ///< With Mismatch.
};

/// The edits of one controller: what is to be written, what came of it, and how to undo it. It sends nothing and knows
/// no clock. Nothing staged is lost but by discard(), clear() and a verified write.
class StagedEdits
{
public:
    /// Replaces an earlier edit, whatever came of it. An edit back to `now` is none. Does
    /// nothing while the variable is being written.
    void stage(const Reference &variable, const Value &value, const std::optional<Value> &now);
    /// Neither touches an edit that is being written.
    void discard(const Reference &variable);
    void clear();

    [[nodiscard]] const Edit *find(const Reference &variable) const;
    /// In the order of the variables.
    [[nodiscard]] QList<Edit> edits() const;
    /// Those that Apply would send: all but those on their way.
    [[nodiscard]] QList<Edit> toApply() const;
    [[nodiscard]] bool isEmpty() const { return m_edits.empty(); }

    /// What is written from now on is undone together.
    void beginBatch() { m_isNewBatch = true; }
    /// `now` is the last value that was read: what undo goes back to.
    void setWriting(const Reference &variable, const std::optional<Value> &now);
    /// Nothing left the computer: it is staged as before.
    void setNotSent(const Reference &variable, const values::Error &error);
    void setRefused(const Reference &variable, const values::Error &error);
    /// The outcome of the write, or of reading it back, is not known.
    void setUnknown(const Reference &variable, const values::Error &error);
    /// The write was accepted and read back. The same value ends the edit and makes it undoable; another one stays as
    /// Mismatch.
    void setReadBack(const Reference &variable, const Value &value);

    /// The edits that would undo the last batch: what was written becomes what was there.
    [[nodiscard]] QList<Edit> undoable() const;
    /// Stages them, and forgets the batch. They are written like all others.
    void undo();

private:
    [[nodiscard]] Edit *writing(const Reference &variable);
    void setFailed(const Reference &variable, EditState state, const values::Error &error);

    std::map<Reference, Edit> m_edits;
    QList<QList<Edit>> m_batches; ///< Verified edits, none empty; the last is undone first.
    bool m_isNewBatch = true; ///< The next verified edit begins a batch.
};

} // namespace variables
