// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/edits.h"
#include "ui/pages/page.h"

class QMenu;
class QSpinBox;

namespace widgets {
class Line;
}

namespace pages {

/// Where the target of a move comes from (the present position, a P variable, where earlier moves began), and the way
/// to keep the present position as a P variable: written once and read back, as on the Variables page.
class PointsBar : public QWidget
{
    Q_OBJECT

public:
    explicit PointsBar(const Context &context, QWidget *parent = nullptr);

    /// Only places in this frame can be taken, and only for an absolute move.
    void setFrame(values::PositionType frame, bool isAbsolute);
    /// Where the group stands; nullopt for what was not read or cannot be kept.
    void setKept(const std::optional<values::Position> &present) { m_present = present; }
    /// A move begins here.
    void remember(const values::Position &position);

Q_SIGNALS:
    void presentWanted();
    void taken(const values::Position &position);

private:
    struct Remembered {
        QDateTime at;
        values::Position position;
    };

    void takeVariable();
    void onRead(const variables::Reference &variable, const values::Result<values::PositionVariable> &read);
    void keep();
    void onApplied();
    void fillMenu();

    robot::Orders &m_orders;
    robot::Edits &m_edits;
    std::optional<variables::Reference> m_keeping; ///< Being written.
    values::PositionType m_frame = values::PositionType::Base;
    bool m_isAbsolute = true;
    std::optional<values::Position> m_present;
    QList<Remembered> m_history; ///< The newest first.
    QSpinBox *m_variable;
    QMenu *m_menu;
    widgets::Line *m_note; ///< What came of taking or keeping a position.
};

} // namespace pages
