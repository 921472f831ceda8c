// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/orders.h"

namespace settings {
class ProfileStore;
}

namespace robot {

/// A variable's value as the person reads it on the pendant.
struct PendantValue {
    int number = 0; ///< Of a B variable.
    int value = 0;
};

/// What comparing the pendant with the wire says about RS022 (reference §10.1).
enum class NumberingVerdict {
    FromZero, ///< Instance = number.
    FromOne, ///< Instance = number + 1.
    Ambiguous, ///< Both would fit: the neighbours hold the same values.
    Neither, ///< The values were read wrong, or they changed meanwhile.
};

/// Compares what the pendant shows with `instances`, the B variables on the wire, of which the first one is instance
/// `firstInstance`. Neither if a needed instance is missing.
[[nodiscard]] NumberingVerdict judgeNumbering(
    const QList<PendantValue> &pendant, const QList<values::ByteVariable> &instances, int firstInstance);

/// Numbers of B variables that tell the two numberings apart: their value and the next one differ. At most `most`.
[[nodiscard]] QList<int> tellingNumbers(const QList<values::ByteVariable> &instances, int firstInstance, int most);

/// The numbering of the profile is known: a simulation's is; a real controller's was compared with its pendant, and its
/// software is still the same.
[[nodiscard]] bool isNumberingKnown(
    const settings::Profile &profile, const std::optional<values::SystemInformation> &system);

/// Lets variables be written only while the numbering is known.
class NumberingGuard : public QObject
{
    Q_OBJECT

public:
    /// `orders` must outlive the guard.
    explicit NumberingGuard(Orders &orders, QObject *parent = nullptr);

    /// Looks again: the profile says something else now.
    void update();
    /// The person compared it with the pendant: the result is kept, in the store too if it knows the profile. Nothing
    /// happens before the controller told its software.
    void keep(protocol::Numbering numbering, settings::ProfileStore &store);

private:
    Orders &m_orders;
};

} // namespace robot
