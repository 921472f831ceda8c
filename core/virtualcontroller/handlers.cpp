// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/handlers.h"

#include <algorithm>

namespace virtualcontroller {

const Handler *findHandler(quint16 command)
{
    for (const auto handlers : {monitoringHandlers(), dataHandlers(), controlHandlers(), moveHandlers()}) {
        const auto found = std::ranges::find(handlers, command, &Handler::command);
        if (found != handlers.end())
            return &*found;
    }
    return nullptr;
}

} // namespace virtualcontroller
