// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/orders.h"
#include "robot/variables.h"
#include "variables/sheet.h"
#include "variables/stagededits.h"

namespace robot {

/// The staged edits of one controller, and the way to it. Each is written by itself, since a plural write of an odd
/// count of bytes would rewrite a neighbour, and read back. They go one after the other; a refusal in the middle leaves
/// the rest to go on. What was not verified stays, with what came of it; what could not be sent stays staged. Nothing
/// is written twice but by a person who applies again.
class Edits : public QObject
{
    Q_OBJECT

public:
    /// `orders` must outlive the edits; `format` is for the journal's words.
    Edits(Orders &orders, const variables::Format &format, QObject *parent = nullptr);

    [[nodiscard]] const variables::StagedEdits &staged() const { return m_staged; }
    [[nodiscard]] bool isApplying() const { return m_isApplying; }
    /// The value that was read last; nullopt if none was.
    [[nodiscard]] std::optional<variables::Value> now(const variables::Reference &variable) const;

    void stage(const variables::Reference &variable, const variables::Value &value);
    void stage(const QList<variables::Difference> &differences);
    void discard(const variables::Reference &variable);
    void discard(const QList<variables::Reference> &variables);
    void clear();
    /// Stages what was there before the last apply(). It is not sent before it is applied.
    void undo();

    /// Writes what of these is staged now, or failed before. Does nothing while it is still at it.
    void apply(const QList<variables::Reference> &variables);
    /// Writes everything that is staged.
    void apply();

Q_SIGNALS:
    /// Edits came, went, or came further.
    void changed();
    /// apply() has come to its end.
    void applied();

private:
    void writeNext();
    template <typename Item> void write(const variables::Reference &variable, const Item &item);
    void onWritten(const variables::Reference &variable, const values::Error &error);
    template <typename Item> void readBack(const variables::Reference &variable);
    void step();
    void finish();
    [[nodiscard]] quint16 instanceOf(const variables::Reference &variable) const;
    [[nodiscard]] Order orderOf(const variables::Edit &edit) const;

    Orders &m_orders;
    variables::Format m_format;
    variables::StagedEdits m_staged;
    QList<variables::Reference> m_left; ///< To be written, the next one first.
    bool m_isApplying = false;
};

} // namespace robot
