// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/numbering.h"

#include "settings/profilestore.h"

namespace robot {

using values::ByteVariable;

namespace {

bool fits(const QList<PendantValue> &pendant, const QList<ByteVariable> &instances, int firstInstance, int shift)
{
    return std::ranges::all_of(pendant, [&](const PendantValue &seen) {
        const qsizetype index = seen.number + shift - firstInstance;
        return index >= 0 && index < instances.size() && instances[index].value == seen.value;
    });
}

} // namespace

NumberingVerdict judgeNumbering(
    const QList<PendantValue> &pendant, const QList<ByteVariable> &instances, int firstInstance)
{
    const bool fromZero = fits(pendant, instances, firstInstance, 0);
    const bool fromOne = fits(pendant, instances, firstInstance, 1);
    if (fromZero && fromOne)
        return NumberingVerdict::Ambiguous;
    return fromZero ? NumberingVerdict::FromZero : fromOne ? NumberingVerdict::FromOne : NumberingVerdict::Neither;
}

QList<int> tellingNumbers(const QList<ByteVariable> &instances, int firstInstance, int most)
{
    QList<int> numbers;
    for (qsizetype i = 0; i + 1 < instances.size() && numbers.size() < most; ++i) {
        if (instances[i] != instances[i + 1])
            numbers << firstInstance + int(i);
    }
    return numbers;
}

bool isNumberingKnown(const settings::Profile &profile, const std::optional<values::SystemInformation> &system)
{
    if (profile.isSimulation)
        return true;
    return system && profile.numberingVerified.isValid()
        && QString::fromLatin1(system->software.bytes()) == profile.numberingSoftware;
}

NumberingGuard::NumberingGuard(Orders &orders, QObject *parent) : QObject {parent}, m_orders {orders}
{
    connect(&orders.controller().state(), &RobotState::changed, this, [this](const TopicRange &range) {
        if (range.contains(topics::systemInformation))
            update();
    });
    update();
}

void NumberingGuard::update()
{
    const Controller &controller = m_orders.controller();
    m_orders.setNumberingVerified(isNumberingKnown(controller.profile(), controller.state().systemInformation().value));
}

void NumberingGuard::keep(protocol::Numbering numbering, settings::ProfileStore &store)
{
    Controller &controller = m_orders.controller();
    const auto &system = controller.state().systemInformation();
    if (!system.value)
        return;
    const QString software = QString::fromLatin1(system.value->software.bytes());
    controller.setNumbering(numbering, QDateTime::currentDateTimeUtc(), software);
    if (store.find(controller.profile().name))
        store.save(controller.profile());
    update();
}

} // namespace robot
