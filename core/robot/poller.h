// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/robotstate.h"

namespace robot {

class Poller : public QObject
{
    Q_OBJECT

public:
    /// Somebody's wish to have topics read. Letting go of it ends the reading: a page holds one while it is visible.
    class Interest;
    [[nodiscard]] Interest want(QList<Topic> topics);
};

} // namespace robot
