// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/faults.h"

#include "protocol/packet.h"

namespace virtualcontroller {

namespace {

Time orElse(Time time, Time fallback) { return time > 0ms ? time : fallback; }

/// The packet with the next request ID; as it was, if it is none.
QByteArray withNextId(Direction direction, const QByteArray &bytes)
{
    if (direction == Direction::Request) {
        auto packet = protocol::parseClientPacket(bytes);
        if (!packet)
            return bytes;
        ++packet->framing.id;
        return protocol::encode(packet->request(), packet->framing);
    }
    auto reply = protocol::parseReply(bytes);
    if (!reply)
        return bytes;
    ++reply->framing.id;
    return protocol::encode(*reply);
}

} // namespace

Faults::Faults(std::vector<FaultRule> rules, quint32 seed)
    : m_rules {std::move(rules)}, m_matched(m_rules.size()), m_struck(m_rules.size()), m_seed {seed}, m_random {seed}
{
}

bool Faults::strikes(std::size_t index, Direction direction, quint16 command)
{
    const FaultRule &rule = m_rules[index];
    if (rule.direction != direction || rule.command.value_or(command) != command)
        return false;
    // The draw is made in any case, so that a rule with an end does not shift what others do.
    const bool isDrawn = double(m_random()) < rule.probability * 4294967296.0;
    const bool isSpared = m_matched[index]++ < rule.after;
    const bool isOver = rule.times >= 0 && m_struck[index] >= rule.times;
    if (!isDrawn || isSpared || isOver)
        return false;
    ++m_struck[index];
    return true;
}

QByteArray Faults::damaged(QByteArray bytes, qsizetype within)
{
    const qsizetype at = qsizetype(m_random() % quint32(std::max<qsizetype>(1, std::min(bytes.size(), within))));
    if (!bytes.isEmpty())
        bytes[at] = char(quint8(bytes[at]) ^ (1 + m_random() % 255));
    return bytes;
}

void Faults::apply(const FaultRule &rule, Direction direction, Plan &plan)
{
    auto &deliveries = plan.deliveries;
    if (deliveries.empty())
        return;
    QByteArray &bytes = deliveries.front().bytes;
    switch (rule.kind) {
    case FaultKind::Lose: deliveries.clear(); break;
    case FaultKind::Delay: deliveries.front().delay += orElse(rule.time, 100ms); break;
    case FaultKind::Duplicate: deliveries.push_back({deliveries.front().delay + rule.time, bytes}); break;
    case FaultKind::Reorder:
        m_heldBack[std::size_t(direction)].swap(deliveries);
        deliveries.clear();
        break;
    case FaultKind::Corrupt: bytes = damaged(bytes, 8); break;
    case FaultKind::CorruptAnywhere: bytes = damaged(bytes, bytes.size()); break;
    case FaultKind::Truncate:
        bytes.truncate(qsizetype(m_random() % quint32(std::max<qsizetype>(1, bytes.size()))));
        break;
    case FaultKind::WrongId: bytes = withNextId(direction, bytes); break;
    case FaultKind::Refuse: plan.refusal = rule.code; break;
    case FaultKind::Silence: plan.silence = orElse(rule.time, 1s); break;
    case FaultKind::Restart:
        plan.silence = orElse(rule.time, 1s);
        plan.isRestart = true;
        break;
    }
}

Faults::Plan Faults::plan(Direction direction, quint16 command, QByteArrayView packet)
{
    Plan plan {{{0ms, packet.toByteArray()}}, {}, {}, false};
    const auto heldBack = std::exchange(m_heldBack[std::size_t(direction)], {});
    for (std::size_t index = 0; index < m_rules.size(); ++index) {
        if (strikes(index, direction, command))
            apply(m_rules[index], direction, plan);
    }
    plan.deliveries.insert(plan.deliveries.end(), heldBack.begin(), heldBack.end());
    if (plan.silence)
        plan.deliveries.clear();
    return plan;
}

} // namespace virtualcontroller
