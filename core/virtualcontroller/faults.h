// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/error.h"
#include "virtualcontroller/time.h"
#include <QByteArray>
#include <QByteArrayView>
#include <QStringView>
#include <array>
#include <optional>
#include <random>
#include <vector>

namespace virtualcontroller {

enum class Direction {
    Request, ///< From the client.
    Reply, ///< To the client.
};

enum class FaultKind {
    Lose, ///< The packet does not arrive.
    Delay, ///< It arrives after FaultRule::time, 100 ms if that is 0.
    Duplicate, ///< It arrives twice, the second time after FaultRule::time.
    Reorder, ///< It is held back until the next packet of its direction has gone, and lost if there is none.
    /// One of its first eight bytes is another: identifier or a size, so that whoever looks notices. A network does not
    /// do that, the checksum of UDP makes a damaged packet a lost one; it stands for a peer that is not HSES.
    Corrupt,
    CorruptAnywhere, ///< Any byte is another: nobody can notice it in a value.
    Truncate, ///< It ends too early.
    WrongId, ///< It carries the next request ID, as a late reply does.
    Refuse, ///< A request is answered with FaultRule::code and not executed.
    Silence, ///< From this packet on nothing comes or goes for FaultRule::time, a second if that is 0.
    Restart, ///< The controller restarts: as Silence, and it forgets all but what it was made with.
};

/// One line of the table.
struct FaultRule {
    std::optional<quint16> command; ///< Empty: all of them. 0 means the file port.
    Direction direction = Direction::Reply;
    FaultKind kind = FaultKind::Lose;
    double probability = 1; ///< 0 to 1.
    int after = 0; ///< So many matching packets are spared first.
    int times = -1; ///< It strikes so often at most; below 0 there is no end.
    Time time {};
    quint16 code = 0xFFF6; ///< An added status.
};

/// What happens to packets on their way. The same seed and the same packets give the same faults.
class Faults
{
public:
    struct Delivery {
        Time delay {};
        QByteArray bytes;

        bool operator==(const Delivery &) const = default;
    };
    struct Plan {
        std::vector<Delivery> deliveries; ///< Empty: the packet is lost.
        std::optional<quint16> refusal; ///< A request is to be refused with this and not to be executed.
        std::optional<Time> silence; ///< The line goes dead for so long, this packet included.
        bool isRestart = false;
    };

    explicit Faults(std::vector<FaultRule> rules = {}, quint32 seed = 1);

    /// "seed=7; 0x86 reply lose times=1; any request delay ms=200 p=0.1; 0x83 request refuse code=0x2080": a seed and
    /// rules of command ("any", "files" or a number), direction, kind and, as they are needed, p, after, times, ms,
    /// code. BadInput says which word is wrong.
    [[nodiscard]] static values::Result<Faults> parse(QStringView text);

    /// What becomes of `packet`, which belongs to `command`.
    [[nodiscard]] Plan plan(Direction direction, quint16 command, QByteArrayView packet);

    [[nodiscard]] const std::vector<FaultRule> &rules() const { return m_rules; }
    [[nodiscard]] quint32 seed() const { return m_seed; }

private:
    [[nodiscard]] bool strikes(std::size_t index, Direction direction, quint16 command);
    void apply(const FaultRule &rule, Direction direction, Plan &plan);
    [[nodiscard]] QByteArray damaged(QByteArray bytes, qsizetype within);

    std::vector<FaultRule> m_rules;
    std::vector<int> m_matched; ///< By rule: how many packets it could have struck.
    std::vector<int> m_struck;
    std::array<std::vector<Delivery>, 2> m_heldBack; ///< By direction.
    quint32 m_seed;
    std::mt19937 m_random;
};

} // namespace virtualcontroller
