// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

// Every payload of the robot port.
#include "protocol/controlpayloads.h"
#include "protocol/datapayloads.h"
#include "protocol/monitoringpayloads.h"
