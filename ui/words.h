// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/text.h"
#include "robot/holdstate.h"
#include "session/statistics.h"
#include "trend/signal.h"
#include "ui/widgets/shown.h"
#include "values/job.h"
#include "values/position.h"
#include "values/status.h"
#include <QByteArrayView>

namespace ui {

/// The status word (reference §3.4) in the pendant's words, as received: bits that contradict each other stand side by
/// side under a warning shape.
[[nodiscard]] widgets::Word modeWord(const values::Status &status); ///< "REMOTE PLAY", "TEACH + PLAY"
[[nodiscard]] widgets::Word cycleWord(const values::Status &status);
[[nodiscard]] widgets::Word runWord(const values::Status &status);
[[nodiscard]] widgets::Word servoWord(const values::Status &status);
[[nodiscard]] widgets::Word holdWord(const values::Status &status); ///< All causes: "PENDANT + COMMAND".
[[nodiscard]] widgets::Word heldByPendantWord(const values::Status &status);
[[nodiscard]] widgets::Word heldExternallyWord(const values::Status &status);
[[nodiscard]] widgets::Word heldByCommandWord(const values::Status &status);
[[nodiscard]] widgets::Word speedLimitWord(const values::Status &status);
[[nodiscard]] widgets::Word alarmWord(const values::Status &status);
[[nodiscard]] widgets::Word errorWord(const values::Status &status);

/// One line for a tile: "REMOTE PLAY · running", "held by the pendant".
[[nodiscard]] widgets::Word summaryWord(const values::Status &status);

/// Text from the controller. It never throws and drops nothing: a byte that is no letter becomes ⟨8A⟩.
[[nodiscard]] QString controllerText(QByteArrayView bytes, protocol::Encoding encoding = protocol::Encoding::Latin1);

[[nodiscard]] QString jobName(
    const values::ExecutingJob &job, protocol::Encoding encoding); ///< "—" while no job is selected.
[[nodiscard]] QString jobPlace(
    const values::ExecutingJob &job); ///< "line 47 · step 12 · 80 %"; empty while no job is selected.
[[nodiscard]] QString overrideText(const values::ExecutingJob &job); ///< "80 %", "12.5 %"

[[nodiscard]] QString millimetres(qint32 micrometres); ///< Three decimals, by the locale.
[[nodiscard]] QString degrees(qint32 tenThousandths); ///< Four decimals, by the locale.
[[nodiscard]] QString pulses(qint32 pulses); ///< Grouped, by the locale.

/// One word of a position in its unit (reference §5.1), and the unit: "mm", "°", "pulses".
[[nodiscard]] QString axisText(values::PositionType type, int axis, qint32 word);
/// A plotted number with the decimals of its unit, by the locale; the unit does not follow it.
[[nodiscard]] QString quantityText(const trend::Quantity &quantity);
[[nodiscard]] QString axisUnit(values::PositionType type, int axis);
/// The bits of a form word in words: "front · upper arm · flip". The bit that matters on writing only is left out, and
/// so is the one for redundant arms unless it is one.
[[nodiscard]] QString formText(quint32 form, bool isRedundant);
[[nodiscard]] QString extendedFormText(quint32 form);

[[nodiscard]] QString roundTripText(std::optional<std::chrono::microseconds> trip); ///< "2.1 ms", "—"
[[nodiscard]] QString percent(double share); ///< "0.0 %" of a share from 0 to 1.
/// "0.4 s"; minutes from 100 s on. "—" if there is none.
[[nodiscard]] QString ageText(std::optional<std::chrono::milliseconds> age);

/// What stands under HOLD: "held by command", or how to hold.
[[nodiscard]] QString holdCaption(const robot::HoldState &hold);

} // namespace ui
