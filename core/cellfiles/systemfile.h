// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "cellfiles/outline.h"
#include "protocol/dialect.h"
#include <QDateTime>
#include <chrono>

namespace cellfiles {

/// A robot, base or station with its axes.
struct Mechanism {
    QString group; ///< "R1", "B1", "S1".
    QString model;
    int axes = 0; ///< Bit 0 is the first axis.

    bool operator==(const Mechanism &) const = default;
};

/// One of the hour counters: noise when two backups are compared, unless it went backwards.
struct HourCounter {
    QString title; ///< "CONTROL POWER"
    QString group; ///< "TOTAL", "R1"
    std::chrono::seconds value {0};

    bool operator==(const HourCounter &) const = default;
};

/// SYSTEM.SYS, and the head of PANELBOX.LOG (controller files reference §9).
struct System {
    int format = 0; ///< The number behind /SYSTEM.
    QDateTime date; ///< By the controller's clock; invalid if not read.
    QString version; ///< "YAS4.50.00A(JP/EN)-00"
    QString parameters;
    QStringList applications; ///< Each once.
    QStringList revisions;
    QList<Mechanism> mechanisms;
    QList<HourCounter> hours;

    /// By the version's prefix; nothing else decides it.
    [[nodiscard]] std::optional<protocol::Model> generation() const;
    [[nodiscard]] std::optional<std::chrono::seconds> hoursOf(QStringView title, QStringView group) const;
};
[[nodiscard]] Parsed<System> systemFrom(QByteArrayView file, const protocol::TextCodec &codec);

/// A switchable function of PANELBOX.LOG.
struct PanelOption {
    int number = 0;
    QString name;
    QString state; ///< "USED", "NOT USED", "DETAIL" or a number.

    bool operator==(const PanelOption &) const = default;
};
/// A block of PANELBOX.LOG: a title and its rows as they are.
struct PanelBlock {
    QString title;
    QStringList rows;
};
struct PanelBox {
    System system;
    QList<PanelBlock> blocks;
    QList<PanelOption> options;
};
[[nodiscard]] Parsed<PanelBox> panelBoxFrom(QByteArrayView file, const protocol::TextCodec &codec);

} // namespace cellfiles
