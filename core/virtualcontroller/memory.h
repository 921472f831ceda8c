// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/dialect.h"
#include "values/job.h"
#include "values/status.h"
#include "values/systeminformation.h"
#include "virtualcontroller/motion.h"
#include "virtualcontroller/program.h"
#include <QDateTime>
#include <map>
#include <memory>

namespace virtualcontroller
{

/// How the controller is made: what a real one has as model, parameters and options.
struct Settings {
    protocol::Model model = protocol::Model::YRC1000;
    int numbering = 0; ///< RS022: a variable's instance is its number plus this, 0 or 1 (reference §10.1).
    bool usesBareStatuses = false; ///< Answers 0x08, 0x09, 0x28 instead of 0x1F with a code (reference §1.6).
    Time servoDelay = 800ms; ///< From the order to servo power on.
    Time lineTime = 20ms; ///< What an instruction takes that neither moves nor waits.
};

/// What stands against an order, apart from the status word: reference §10.2.
struct Interlocks {
    bool isSafetyChainClosed = true;
    bool isEditing = false;
    bool areFilesInUse = false;
    bool isDataLocked = false;
    bool isPanelLocked = false; ///< Mode and cycle changes are prohibited.
    bool isStartLocked = false;
    bool isHomeConfirmed = true;
    bool isMasterCallPermitted = true;
    bool isTeachLocked = false;
    bool isPendantLocked = false; ///< HLOCK.
};

/// A place in a job.
struct Frame {
    std::shared_ptr<const Program> program;
    int line = 0;
};

/// The master task or a sub task.
struct Task {
    QByteArray master; ///< Name of the master job, empty without one.
    std::vector<Frame> stack; ///< The executing job is the last one; empty without a job.
    quint32 speedOverride = 10000; ///< In 0.01 %.
    bool isExecuting = false; ///< The line at the top of the stack has been begun.
    Time due {}; ///< When that line is done, or looks again at what it waits for.
    Time begun {}; ///< When that line was begun.
};

/// The state of one virtual controller. A plain value: whoever has it may look at and change everything in it. The
/// functions of machine.h keep it consistent.
struct Memory {
    Settings settings;
    QDateTime switchedOn = QDateTime::currentDateTime(); ///< The wall clock at time 0.
    Time now {}; ///< How far advance() has come.

    values::Status status;
    Interlocks interlocks;
    std::optional<Time> servoOnAt; ///< Servo power is coming.
    std::vector<Task> tasks; ///< The master task first.
    bool isJobRunning = false;
    std::vector<Group> groups;

    values::FixedText<24> software;
    std::map<quint16, values::SystemInformation> systemInformation; ///< By instance, reference §3.10.
    std::map<quint16, quint8> io; ///< By group of eight signals; 0 where nothing is entered.
    std::map<QByteArray, QByteArray> files; ///< By name with extension.

    std::array<quint8, 100> bytes {};

    /// Remote, play, one cycle, servo off, at rest, with one six-axis robot and the demo jobs.
    explicit Memory(Settings settings = {});
    /// As a demo shows itself: servo power on and the first demo job running in continuous mode.
    [[nodiscard]] static Memory demo(Settings settings = {});

    [[nodiscard]] const protocol::Dialect &dialect() const { return protocol::dialect(settings.model); }
    /// The group of a pulse or cartesian instance (reference §2.1); nullptr if it is not configured.
    [[nodiscard]] Group *findGroup(values::ControlGroup group);
    [[nodiscard]] const Group *findGroup(values::ControlGroup group) const;
    /// Where a task stands (reference §3.5).
    [[nodiscard]] values::ExecutingJob executingJob(const Task &task) const;
    /// The job of that name, without extension; nullptr if there is none, or none that can be read.
    [[nodiscard]] std::shared_ptr<const Program> program(const QByteArray &name) const;
    /// The controller's clock, local time.
    [[nodiscard]] QDateTime clock() const { return switchedOn.addMSecs(now.count()); }

    /// Signal number n of an area, counted from 1 as INFORM does: IN#(n), OT#(n).
    [[nodiscard]] bool signal(protocol::IoArea area, int number) const;
    void setSignal(protocol::IoArea area, int number, bool on);
};

} // namespace virtualcontroller
