// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "motion/limits.h"
#include "protocol/dialect.h"
#include "protocol/packet.h"
#include "protocol/text.h"
#include "values/position.h"
#include <QDateTime>
#include <QStringList>
#include <QUuid>
#include <array>
#include <chrono>
#include <map>

namespace settings {

/// Everything Pendesk must be told about one controller.
struct Profile {
    QUuid id; ///< Never shown, never changed: what is kept about the controller goes by it. Null: nobody stored it yet.
    QString name; ///< Shown everywhere; unique among the profiles.
    QString folder; ///< Its folders at this computer, see folderName().
    QStringList formerNames; ///< Older entries of the journal go by them.
    int tag = 0; ///< The colour of the bar beside the name, 1 to 3; 0 for none.
    QString host; ///< Name or IPv4 address.
    quint16 port = protocol::robotPort; ///< UDP, robot control.
    quint16 filePort = protocol::filePort; ///< UDP, file control.
    protocol::Model model = protocol::Model::YRC1000;
    protocol::Encoding encoding = protocol::Encoding::Latin1; ///< Of the pendant's language.
    protocol::Numbering numbering = protocol::Numbering::FromZero; ///< Of variables (RS022).
    QDateTime numberingVerified; ///< When it was compared with the pendant, UTC; invalid: never.
    QString numberingSoftware; ///< The software version it was compared with.
    std::chrono::milliseconds readTimeout {300}; ///< One try of a read; 20 ms to 60 s.
    std::chrono::milliseconds fileTimeout {3000};
    std::chrono::milliseconds servoTimeout {8000};
    int readRepeats = 2; ///< 0 to 10.
    int window = 1; ///< Requests outstanding at once, 1 to 8.
    int requestsPerSecond = 100; ///< Ceiling; 1 to 10000.
    /// By the pulse instance of a control group, for each of its axes; 0 where it is not known. HSES does not tell it
    /// (reference §5.1), so degrees are shown only where a person entered it.
    std::map<quint16, std::array<double, values::maxAxes>> pulsesPerDegree;
    motion::Wishes motion; ///< Limits of jogging and moving below the ceilings of the program.
    bool isSimulation = false; ///< The embedded virtual controller: the window says SIMULATION.

    bool operator==(const Profile &) const = default;

    /// The name of its folders of backups and incidents: the first name it had here, so that renaming moves no files.
    [[nodiscard]] QString folderName() const { return folder.isEmpty() ? name : folder; }
    /// All names it has had, the present one first.
    [[nodiscard]] QStringList names() const { return QStringList {name} + formerNames; }

    /// The model's dialect, with this controller's numbering.
    [[nodiscard]] protocol::Dialect dialect() const
    {
        protocol::Dialect result = protocol::dialect(model);
        result.numbering = numbering;
        return result;
    }
};

} // namespace settings
