// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "virtualcontroller/faults.h"

namespace fuzz {

namespace {

/// What `pendesk-sim --faults` reads, and what the faults do to a packet.
void take(QByteArrayView data)
{
    using namespace virtualcontroller;
    auto faults = Faults::parse(QString::fromUtf8(data));
    if (!faults) {
        require(!faults.error().detail.isEmpty(), "a refusal without a sentence");
        return;
    }
    for (const auto direction : {Direction::Request, Direction::Reply}) {
        for (const auto &delivery : faults->plan(direction, 0x86, "YERC, thirty-two bytes of header").deliveries)
            require(delivery.delay.count() >= 0 && delivery.bytes.size() <= 32, "a packet grew");
    }
}

Seeds seeds()
{
    return {"seed=7; 0x86 reply lose times=1; any request delay ms=200 p=0.1", "0x83 request refuse code=0x2080",
        "files reply corrupt-anywhere after=3; any reply truncate; any reply wrong-id p=nan",
        "any request silence ms=-1"};
}

} // namespace

extern const Target faults;
const Target faults {"faults", take, seeds, 160};

} // namespace fuzz
