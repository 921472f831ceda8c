// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/dialect.h"
#include "values/alarm.h"
#include "values/control.h"
#include "values/managementtime.h"
#include "values/status.h"
#include "values/systeminformation.h"
#include "values/temperature.h"
#include "values/variable.h"
#include "virtualcontroller/motion.h"
#include "virtualcontroller/program.h"
#include "virtualcontroller/transfer.h"
#include <QDateTime>
#include <deque>
#include <map>
#include <memory>

namespace virtualcontroller {

constexpr quint32 lastTool = 63;
constexpr quint32 lastUserFrame = 63;
constexpr qsizetype maxFileSize = 16 << 20; ///< Bytes.

/// How the controller is made: what a real one has as model, parameters and options.
struct Settings {
    protocol::Model model = protocol::Model::YRC1000;
    protocol::Numbering numbering = protocol::Numbering::FromZero; ///< Parameter RS022 (reference §10.1).
    bool usesBareStatuses = false; ///< Answers 0x08, 0x09, 0x28 instead of 0x1F with a code (reference §1.6).
    bool answersWrongIdentifier = false; ///< With 0xE4A6, instead of dropping the datagram (reference §1.7).
    bool refusesElementsOfP = false; ///< 0x0E and 0x10 on P variables end in 0xA002 (reference §12, conflict 47).
    bool hasBatchBackup = false; ///< /SPDRV/CMOSBK.BIN can be saved; else 0xE24F (reference §7.5).
    bool refusesEmptyLists = true; ///< With 0xE2A7; else an empty block is sent (reference §7.4).
    bool mayOverwriteFiles = true; ///< RS029 and RS214 are 1 (reference §10.1).
    quint16 overwriteRefusal = 0xE28C; ///< Or 0x4030 (reference §7.6).
    /// From the order to servo power on, when the order is answered too (reference §0.1 h): well under the 800 ms that
    /// many clients wait.
    Time servoDelay = 600ms;
    Time lineTime = 20ms; ///< What an instruction takes that neither moves nor waits.
    Time transferTimeout = 10s; ///< After which a silent client's transfer is dropped (reference §7.6).
    int blockSize = 479; ///< Bytes in a block that the controller sends; 1 to 479.
};

/// What stands against an order, apart from the status words: reference §10.2.
struct Interlocks {
    bool isSafetyChainClosed = true;
    bool isEditing = false; ///< A person edits at the pendant.
    bool areFilesInUse = false; ///< Another function uses files.
    bool isDataLocked = false;
    bool isPanelLocked = false; ///< Mode and cycle changes are prohibited.
    bool isStartLocked = false;
    bool isHomeConfirmed = true;
    bool isJobSelectPermitted = true; ///< "Job select when remote and play".
    bool isMasterCallPermitted = true;
    bool isMasterCalled = false; ///< A master call is operating.
    bool isTeachLocked = false;
    bool isPendantLocked = false; ///< HLOCK.
};

/// An alarm that has been raised and not been reset.
struct ActiveAlarm {
    values::AlarmWithTexts alarm;
    bool hasCause = false; ///< What raised it is still there: a reset does not clear it.
};

/// A place in a job.
struct Frame {
    std::shared_ptr<const Program> program;
    int line = 0;
};

/// The master task or a sub task. Only the master task executes.
struct Task {
    QByteArray master; ///< Name of the master job, empty without one.
    std::vector<Frame> stack; ///< The executing job is the last one; empty without a job.
    quint32 speedOverride = 10000; ///< In 0.01 %.
    bool isExecuting = false; ///< The line at the top of the stack has been begun.
    Time due {}; ///< When that line is done, or looks again at what it waits for.
    Time begun {}; ///< When that line was begun.
};

/// A running-time counter (reference §3.9).
struct RunningTime {
    QDateTime start;
    Time elapsed {};
};

/// The state of one virtual controller. A plain value: whoever has it may look at and change everything in it. The
/// functions of machine.h keep it consistent.
struct Memory {
    Settings settings;
    protocol::Dialect dialect; ///< Of the settings' model and numbering.
    QDateTime switchedOn = QDateTime::currentDateTime(); ///< The wall clock at time 0.
    Time now {}; ///< How far advanceTo() has come.

    Time silentUntil {}; ///< The server answers nothing until then; the responders do not care.

    values::Status status;
    Interlocks interlocks;
    std::optional<Time> servoOnAt; ///< Servo power is coming.
    bool isJobRunning = false;
    std::vector<Task> tasks; ///< The master task first.
    std::vector<Group> groups;
    values::PendantText pendantText;

    std::deque<ActiveAlarm> alarms; ///< The newest first.
    std::map<values::AlarmHistoryClass, std::deque<values::AlarmWithTexts>> histories; ///< The newest first.

    std::map<quint16, quint8> io; ///< By group of eight signals; 0 where nothing is entered.
    std::vector<values::Register> registers;
    std::vector<values::ByteVariable> b; ///< The variables carry the letters of the pendant.
    std::vector<values::IntegerVariable> i;
    std::vector<values::DoubleVariable> d;
    std::vector<values::RealVariable> r;
    std::vector<values::StringVariable32> s;
    std::vector<std::optional<values::PositionVariable>> p; ///< Empty: never taught.
    std::vector<std::optional<values::BasePosition>> bp;
    std::vector<std::optional<values::ExternalPosition>> ex;

    std::map<quint16, values::SystemInformation> systemInformation; ///< By instance, reference §3.10.
    std::map<quint16, RunningTime> times; ///< By instance, reference §3.9.
    std::map<quint16, values::EncoderTemperatures> encoderTemperatures; ///< By pulse instance of the group.
    std::map<quint16, values::ConverterTemperature> converterTemperatures; ///< By servo board.

    std::map<QByteArray, QByteArray> files; ///< By name with extension.
    std::optional<Transfer> transfer; ///< The one file transfer that may be going on.

    /// Remote, play, one cycle, servo off, at rest, with one six-axis robot and the demo's files and data.
    explicit Memory(const Settings &settings = {});
    /// As a demo shows itself: servo power on and a job running in continuous mode.
    [[nodiscard]] static Memory demo(const Settings &settings = {});

    /// How many variables of each kind there are: B I D R S, and P BP EX. What is beyond goes, what is new is 0 or
    /// was never taught.
    void resizeVariables(int variables, int positionVariables);

    /// The group of a pulse or cartesian instance (reference §2.1); nullptr if it is not configured.
    [[nodiscard]] Group *findGroup(values::ControlGroup group);
    [[nodiscard]] const Group *findGroup(values::ControlGroup group) const;
    /// Where a task stands (reference §3.5).
    [[nodiscard]] values::ExecutingJob executingJob(const Task &task) const;
    /// The job of that name, without extension; nullptr if there is none, or none that can be read.
    [[nodiscard]] std::shared_ptr<const Program> program(const QByteArray &name) const;
    /// A job of that name, without extension, is being executed or called at present.
    [[nodiscard]] bool isJobInUse(const QByteArray &name) const;
    /// The controller's clock as its texts have it: "YYYY/MM/DD hh:mm".
    [[nodiscard]] values::FixedText<16> clockText() const;

    /// Signal number n of an area, counted from 1 as INFORM does: IN#(n), OT#(n). Beyond the area there is none: it is
    /// off, and setting it does nothing.
    [[nodiscard]] bool signal(protocol::IoArea area, int number) const;
    void setSignal(protocol::IoArea area, int number, bool on);
};

} // namespace virtualcontroller
