// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/alldialogs.h"

#include "robot/edits.h"
#include "ui/dialogs/accessdialog.h"
#include "ui/dialogs/applydialog.h"
#include "ui/dialogs/comparedialog.h"
#include "ui/dialogs/connectiondialog.h"
#include "ui/dialogs/diagnosisdialog.h"
#include "ui/dialogs/importdialog.h"
#include "ui/dialogs/iowritedialog.h"
#include "ui/dialogs/jobeditor.h"
#include "ui/dialogs/movesheet.h"
#include "ui/dialogs/numberingdialog.h"
#include "ui/dialogs/overwritedialog.h"
#include "ui/dialogs/positiondialog.h"
#include "ui/dialogs/restoredialog.h"
#include "ui/dialogs/signalpicker.h"
#include "ui/dialogs/startsheet.h"
#include "ui/dialogs/whynotdialog.h"
#include "ui/widgets/question.h"

namespace {

const QByteArray olderJob = "/JOB\r\n//NAME WELD_A12\r\nNOP\r\nMOVJ C00000 VJ=50.00\r\nEND\r\n";
const QByteArray newerJob = "/JOB\r\n//NAME WELD_A12\r\nNOP\r\nMOVJ C00000 VJ=25.00\r\nEND\r\n";

protocol::TextCodec codec() { return protocol::TextCodec {protocol::Encoding::Latin1}; }
values::FileName file(const char *name) { return *values::FileName::create(name); }

QDialog *applyDialog(Harness &harness)
{
    auto *edits = new robot::Edits(harness.window.view().orders(), {}, &harness.window);
    edits->stage({variables::Kind::B, 3}, values::ByteVariable {7});
    return new dialogs::ApplyDialog(*edits, {{variables::Kind::B, 3}}, harness.profile().name, {}, &harness.window);
}

QDialog *importDialog(Harness &harness)
{
    variables::Preview preview;
    preview.unchanged = 3;
    preview.problems << variables::Problem {2, QStringLiteral("…")};
    return new dialogs::ImportDialog(preview, harness.profile().name, {}, &harness.window);
}

QDialog *moveSheet(Harness &harness)
{
    motion::Wish wish;
    wish.how = motion::Wish::How::Increment;
    wish.axes = {0, 0, 5000, 0, 0, 0};
    const auto present = robot::presentOf(harness.state(), wish.group);
    const auto plan = motion::plan(wish, present, {});
    return plan ? new dialogs::MoveSheet(harness.window.view().orders(), *plan, present, {}, &harness.window) : nullptr;
}

QDialog *restoreDialog(Harness &harness)
{
    const QList<files::RestoreItem> plan {{file("WELD_A12.JBI"), files::RestoreStep::Changed, {}},
        {file("PALLET.JBI"), files::RestoreStep::New, {}}, {file("ALL.PRM"), files::RestoreStep::Same, {}}};
    return new dialogs::RestoreDialog(harness.profile(), QDateTime::currentDateTime(), plan, &harness.window);
}

robot::Orders &orders(Harness &harness) { return harness.window.view().orders(); }

const DialogRow rows[] {
    {"passcode",
        [](Harness &harness) -> QDialog * {
            return new dialogs::PasscodeDialog(harness.access(), robot::Level::Engineer, &harness.window);
        }},
    {"access settings",
        [](Harness &harness) -> QDialog * {
            return new dialogs::AccessSettingsDialog(harness.rules, &harness.window);
        }},
    {"apply", applyDialog},
    {"compare",
        [](Harness &harness) -> QDialog * {
            return new dialogs::CompareDialog(
                QStringLiteral("WELD_A12.JBI"), olderJob, newerJob, codec(), QString(), &harness.window);
        }},
    {"connection",
        [](Harness &harness) -> QDialog * {
            return new dialogs::ConnectionDialog(harness.store, {}, &harness.window);
        }},
    {"diagnosis",
        [](Harness &harness) -> QDialog * { return new dialogs::DiagnosisDialog(harness.profile(), &harness.window); }},
    {"import", importDialog},
    {"write io",
        [](Harness &harness) -> QDialog * {
            return new dialogs::IoWriteDialog(orders(harness), names::Signal {2701, 0}, {}, &harness.window);
        }},
    {"job editor",
        [](Harness &harness) -> QDialog * {
            return new dialogs::JobEditor(file("WELD_A12.JBI"), olderJob, codec(), &harness.window);
        }},
    {"move", moveSheet},
    {"numbering",
        [](Harness &harness) -> QDialog * { return new dialogs::NumberingDialog(orders(harness), &harness.window); }},
    {"overwrite",
        [](Harness &harness) -> QDialog * {
            return new dialogs::OverwriteDialog(
                QStringLiteral("WELD_A12.JBI"), harness.profile().name, true, 3, &harness.window);
        }},
    {"position",
        [](Harness &harness) -> QDialog * {
            return new dialogs::PositionDialog(
                orders(harness), {variables::Kind::P, 1}, std::nullopt, {}, &harness.window);
        }},
    {"question",
        [](Harness &harness) -> QDialog * {
            return new widgets::Question("question", QObject::tr("Servo on"), QObject::tr("Servo on"),
                {{"answer", QObject::tr("Servo on"), [] {}}}, &harness.window);
        }},
    {"restore", restoreDialog},
    {"signal picker",
        [](Harness &harness) -> QDialog * {
            return new dialogs::SignalPicker(
                harness.window.view().recorder(), harness.profile().dialect(), &harness.window);
        }},
    {"start", [](Harness &harness) -> QDialog * { return new dialogs::StartSheet(orders(harness), &harness.window); }},
    {"why not",
        [](Harness &harness) -> QDialog * {
            return new dialogs::WhyNotDialog(orders(harness), robot::Act::StartJob, &harness.window);
        }},
};

} // namespace

std::span<const DialogRow> allDialogs() { return rows; }
