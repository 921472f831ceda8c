// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

namespace robot {
class Arming;
}

namespace session {

/// Proof that the robot is armed at this moment. What starts or moves does not compile without one, and nothing but
/// arming hands one out. It is passed by reference through one call and never kept.
class Permit
{
public:
    Permit(const Permit &) = delete;
    Permit &operator=(const Permit &) = delete;

private:
    Permit() = default;
    friend class robot::Arming;
};

} // namespace session
