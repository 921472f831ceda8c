// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/variables.h"
#include <QHash>

namespace robot {

/// What a variable was before it was what it is, as far as it was watched.
struct VariablePast {
    std::optional<variables::Value> latest;
    std::optional<variables::Value> previous; ///< nullopt: no change was seen yet.
    QDateTime changed; ///< When the change was seen, local time.
};

/// Remembers the last change of every variable and register that is read.
class VariableHistory : public QObject
{
    Q_OBJECT

public:
    /// `state` must outlive the history.
    explicit VariableHistory(const RobotState &state, QObject *parent = nullptr);

    [[nodiscard]] VariablePast of(const variables::Reference &variable) const { return m_past.value(variable); }

Q_SIGNALS:
    /// Variables first..last of a kind were read, refused, or grew stale. The history knows already.
    void changed(const variables::Range &range);

private:
    void onChanged(const TopicRange &range);
    void look(const variables::Reference &variable);

    const RobotState &m_state;
    QHash<variables::Reference, VariablePast> m_past;
};

} // namespace robot
