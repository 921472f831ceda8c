// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pagecatalog.h"

#include "ui/pages/alarmspage.h"
#include "ui/pages/backuppage.h"
#include "ui/pages/filespage.h"
#include "ui/pages/fleetpage.h"
#include "ui/pages/iopage.h"
#include "ui/pages/jobspage.h"
#include "ui/pages/journalpage.h"
#include "ui/pages/motionpage.h"
#include "ui/pages/overviewpage.h"
#include "ui/pages/positionpage.h"
#include "ui/pages/registerspage.h"
#include "ui/pages/trendpage.h"
#include "ui/pages/variablespage.h"
#include <QCoreApplication>

namespace ui {

namespace {

template <typename Page> pages::Page *create(const pages::Context &context, QWidget *parent)
{
    return new Page(context, parent);
}

// Sentences for F1: what one sees, what one can do, what its signs mean.
// clang-format off
constexpr const char *overviewHelp[] {
    QT_TRANSLATE_NOOP("Pages", "The state of the robot at a glance: mode, cycle, servo, run, the three causes of a hold, alarm, error and speed limit, the executing job, the position of R1, and how well the link works."),
    QT_TRANSLATE_NOOP("Pages", "“What can I do now?” lists what may be ordered. ✓ may be tried, ✗ may not, with the first reason beside it."),
    QT_TRANSLATE_NOOP("Pages", "Bits that contradict each other, such as TEACH and PLAY, are shown side by side as they were received, under ▲."),
    QT_TRANSLATE_NOOP("Pages", "Copy beside the system information takes model and software to the clipboard. The right mouse button on a number adds it to the trend."),
};
constexpr const char *alarmsHelp[] {
    QT_TRANSLATE_NOOP("Pages", "Up to four active alarms, the newest first, and the past alarms that were read from the controller."),
    QT_TRANSLATE_NOOP("Pages", "Acknowledge is noted on this computer only: the robot does not hear of it."),
    QT_TRANSLATE_NOOP("Pages", "Reset alarm and Cancel error are orders: they need REMOTE and the level Operate, and say before what they clear. After a reset that was accepted an alarm may stay: then its cause is still there."),
    QT_TRANSLATE_NOOP("Pages", "Read now fetches the history and keeps it in the journal, even after the controller has dropped it. Most frequent counts codes."),
    QT_TRANSLATE_NOOP("Pages", "Notes keep what caused a code and what was done, on this computer."),
};
constexpr const char *ioHelp[] {
    QT_TRANSLATE_NOOP("Pages", "All signals of one area, a group of eight in a row. A filled square is 1, a hollow one 0; a frame marks what changed in the last two seconds."),
    QT_TRANSLATE_NOOP("Pages", "Only network inputs can be written over HSES, by an engineer. A write reads the group, changes one bit, shows old and new, and reads back: eight bits travel together."),
    QT_TRANSLATE_NOOP("Pages", "Names come from the controller's IONAME.DAT. The right mouse button names a signal here, or puts it on the tab Watch."),
    QT_TRANSLATE_NOOP("Pages", "Watch counts edges and draws the last minute. It reads four times a second: shorter pulses are not seen."),
    QT_TRANSLATE_NOOP("Pages", "Go to takes #27010 as well as IN#(1)."),
};
constexpr const char *registersHelp[] {
    QT_TRANSLATE_NOOP("Pages", "The registers M000 to M999, as decimal, signed, hexadecimal or binary numbers. Only the rows in view are read."),
    QT_TRANSLATE_NOOP("Pages", "M000 to M559 can be written by an engineer; the others belong to the ladder."),
    QT_TRANSLATE_NOOP("Pages", "Enter in the editor stages a value: it turns amber and nothing is sent. Apply shows old and new of all staged values, writes each once, and reads it back."),
    QT_TRANSLATE_NOOP("Pages", "A value that reads back differently is red and stays. Undo last stages the values from before the last Apply."),
};
constexpr const char *variablesHelp[] {
    QT_TRANSLATE_NOOP("Pages", "The variables B I D R S P BP and EX with their names, their value before, and when they changed. Only the rows in view are read."),
    QT_TRANSLATE_NOOP("Pages", "Enter in the editor stages a value: it turns amber and nothing is sent. Apply shows old and new of all staged values, writes each once, and reads it back."),
    QT_TRANSLATE_NOOP("Pages", "A value that reads back differently is red and stays. Undo last stages the values from before the last Apply."),
    QT_TRANSLATE_NOOP("Pages", "Nothing is written before the numbering was compared with the pendant: Verify… does that, and only reads."),
    QT_TRANSLATE_NOOP("Pages", "Import and Export take CSV files; cells of a spreadsheet can be pasted. Both show first what would differ."),
    QT_TRANSLATE_NOOP("Pages", "A watch page is a list of your own: the right mouse button puts rows of any tab on it."),
};
constexpr const char *positionHelp[] {
    QT_TRANSLATE_NOOP("Pages", "The tool point in the base frame, with form and tool; the axes in pulses with following error, torque and temperature where the model tells them; and the path of the tool point."),
    QT_TRANSLATE_NOOP("Pages", "Degrees of axes stand here only where the profile gives pulses per degree: the controller does not tell them."),
    QT_TRANSLATE_NOOP("Pages", "Torque is shown as the controller sends it: its unit is stated nowhere."),
    QT_TRANSLATE_NOOP("Pages", "Min and max count from the last reset, while this page is read. Copy as text takes the table in view."),
    QT_TRANSLATE_NOOP("Pages", "Control groups that the controller refuses have no tab; the line beside the tabs counts them."),
};
constexpr const char *motionHelp[] {
    QT_TRANSLATE_NOOP("Pages", "Moves the robot by orders, in automatic operation. The pendant's enabling switch does not protect anyone here, and nobody may be inside the fence. It is off in TEACH, always."),
    QT_TRANSLATE_NOOP("Pages", "Arming needs the level Operate, REMOTE and PLAY; moving needs Engineer too. Losing the focus, a minute without a key or the mouse, an alarm or a lost link disarms."),
    QT_TRANSLATE_NOOP("Pages", "Jog sends one bounded step after another while a button is held. Letting go sends no more steps and holds the one that runs; after a lost link the robot still ends its step."),
    QT_TRANSLATE_NOOP("Pages", "Move shows present place, target and change first. Rehearse… opens the sheet on which the move is confirmed."),
    QT_TRANSLATE_NOOP("Pages", "What was sent without an answer is called unknown, never failed: look at the robot."),
};
constexpr const char *trendHelp[] {
    QT_TRANSLATE_NOOP("Pages", "Draws any number over time. Drag it here from a page, choose “Add to trend” in its menu, or use Add signal…."),
    QT_TRANSLATE_NOOP("Pages", "Pause freezes the view; recording goes on. Gaps in a curve are times in which nothing was read."),
    QT_TRANSLATE_NOOP("Pages", "The time box chooses how long a time is in view; under the cursor stand the values of that moment."),
    QT_TRANSLATE_NOOP("Pages", "An incident keeps 60 s before and 20 s after an alarm came up. It can be opened here later."),
    QT_TRANSLATE_NOOP("Pages", "Export CSV… writes what is in view, with times in UTC."),
};
constexpr const char *jobsHelp[] {
    QT_TRANSLATE_NOOP("Pages", "The jobs on the controller and the text of the chosen one, with the line that is executed. A banner says when the text may be old."),
    QT_TRANSLATE_NOOP("Pages", "“Job” is what the controller names: at rest the job that a start would begin, else the one that runs. “Run” says which."),
    QT_TRANSLATE_NOOP("Pages", "Start needs REMOTE, PLAY, servo on, the level Operate and an armed controller. Its sheet names controller, job and line, and the button works after one second. Nothing is ever started twice."),
    QT_TRANSLATE_NOOP("Pages", "Buttons show what was read. “Pending” stands until the status agrees."),
    QT_TRANSLATE_NOOP("Pages", "HOLD from here can be released here. A hold by the pendant is released there."),
    QT_TRANSLATE_NOOP("Pages", "“Why not?” beside a button lists all its conditions."),
};
constexpr const char *filesHelp[] {
    QT_TRANSLATE_NOOP("Pages", "Files of this computer on the left, of the controller on the right, by type."),
    QT_TRANSLATE_NOOP("Pages", "Fetch only reads. Send and Delete are for engineers and need REMOTE on."),
    QT_TRANSLATE_NOOP("Pages", "A file that exists already is asked about: compare it, replace it, or leave it, which is the default. A file cut off half way never replaces a good one."),
    QT_TRANSLATE_NOOP("Pages", "Before a job is sent its text is checked, and afterwards it is read back and compared."),
    QT_TRANSLATE_NOOP("Pages", "Transfers lists every file with its bytes and state. Retry failed sends none that was finished."),
};
constexpr const char *backupHelp[] {
    QT_TRANSLATE_NOOP("Pages", "Backups of this controller, the newest first, with the files that are missing in each. ▲ marks one that is not whole."),
    QT_TRANSLATE_NOOP("Pages", "Back up now reads every file into a new folder with a checksum of each. A file that fails does not stop the rest."),
    QT_TRANSLATE_NOOP("Pages", "Verify reads every byte again. Compare finds what differs from another backup or from the controller now; dates and counters are left out, and the page says which."),
    QT_TRANSLATE_NOOP("Pages", "Restore… plans first, makes a fresh backup, sends what changed, and reads it back. It needs an engineer and REMOTE, and no job may run."),
    QT_TRANSLATE_NOOP("Pages", "Old backups go by number and age as set below the list, never the last good one or a pinned one."),
};
constexpr const char *journalHelp[] {
    QT_TRANSLATE_NOOP("Pages", "Everything that was tried from here: writes, starts, moves, servo, files, and what was refused or withheld, with user, old and new value, and the controller's answer."),
    QT_TRANSLATE_NOOP("Pages", "“Unknown” means that no answer came: it may have happened."),
    QT_TRANSLATE_NOOP("Pages", "Filter by controller, kind, time and outcome, or search in all texts. Older records come when scrolling down."),
    QT_TRANSLATE_NOOP("Pages", "The journal is kept on this computer for all controllers and can be read without a connection. Export writes what the filter shows."),
};
constexpr const char *fleetHelp[] {
    QT_TRANSLATE_NOOP("Pages", "All controllers side by side: those in alarm first, then those without a link and those that are held, then the others in a fixed order."),
    QT_TRANSLATE_NOOP("Pages", "A click opens a controller’s pages. The others stay connected and are read once a second."),
    QT_TRANSLATE_NOOP("Pages", "HOLD ALL orders a software hold at every controller that is not off, asks nothing, and says of each whether it was confirmed. It is no emergency stop."),
    QT_TRANSLATE_NOOP("Pages", "Connect all and Back up all only read. Nothing else goes to several controllers at once."),
};
constexpr PageKey ioKeys[] {
    {"Ctrl+G", QT_TRANSLATE_NOOP("Pages", "Go to a signal")},
    {"Return; Space", QT_TRANSLATE_NOOP("Pages", "Write the signal (network inputs)")},
    {"Del", QT_TRANSLATE_NOOP("Pages", "On the tab Watch: watch the signal no longer")},
};
constexpr PageKey registersKeys[] {
    {"Ctrl+G", QT_TRANSLATE_NOOP("Pages", "Go to a register")},
    {"Return", QT_TRANSLATE_NOOP("Pages", "Open the editor; in it: stage the value")},
    {"Del", QT_TRANSLATE_NOOP("Pages", "Discard the staged value")},
    {"Ctrl+C", QT_TRANSLATE_NOOP("Pages", "Copy the chosen rows")},
    {"Ctrl+V", QT_TRANSLATE_NOOP("Pages", "Paste cells: they are staged after a preview")},
};
constexpr PageKey variablesKeys[] {
    {"Ctrl+G", QT_TRANSLATE_NOOP("Pages", "Go to a variable")},
    {"Return", QT_TRANSLATE_NOOP("Pages", "Open the editor; in it: stage the value")},
    {"Del", QT_TRANSLATE_NOOP("Pages", "Discard the staged value")},
    {"Ctrl+C", QT_TRANSLATE_NOOP("Pages", "Copy the chosen rows")},
    {"Ctrl+V", QT_TRANSLATE_NOOP("Pages", "Paste cells: they are staged after a preview")},
};
constexpr PageKey motionKeys[] {
    {"Ctrl+Space", QT_TRANSLATE_NOOP("Pages", "Held on a jog button: steps, if keyboard jog was switched on")},
    {"F9", QT_TRANSLATE_NOOP("Pages", "In the sheet of the move, after typing its words: move")},
};
constexpr PageKey trendKeys[] {
    {"Left; Right", QT_TRANSLATE_NOOP("Pages", "In the plot: move the cursor")},
    {"Home; End", QT_TRANSLATE_NOOP("Pages", "In the plot: cursor to the oldest or newest time in view")},
    {"Esc", QT_TRANSLATE_NOOP("Pages", "In the plot: take the cursor away")},
    {"Del", QT_TRANSLATE_NOOP("Pages", "In the list of signals: remove it from the trend")},
};
constexpr PageKey jobsKeys[] {
    {"F9", QT_TRANSLATE_NOOP("Pages", "In the start sheet, after typing its words: start")},
};
constexpr PageKey alarmsKeys[] {
    {"Ctrl+C", QT_TRANSLATE_NOOP("Pages", "Copy the chosen rows of the list with the focus")},
};
constexpr PageKey journalKeys[] {
    {"Ctrl+C", QT_TRANSLATE_NOOP("Pages", "Copy the chosen rows")},
};
// clang-format on

constexpr PageRow pageRows[] {
    {"overview", QT_TRANSLATE_NOOP("Pages", "Overview"), "overview", "Ctrl+1", create<pages::OverviewPage>,
        overviewHelp},
    {"alarms", QT_TRANSLATE_NOOP("Pages", "Alarms"), "alarms", "Ctrl+2", create<pages::AlarmsPage>, alarmsHelp,
        alarmsKeys},
    {"io", QT_TRANSLATE_NOOP("Pages", "I/O"), "io", "Ctrl+3", create<pages::IoPage>, ioHelp, ioKeys},
    {"registers", QT_TRANSLATE_NOOP("Pages", "Registers"), "registers", "Ctrl+4", create<pages::RegistersPage>,
        registersHelp, registersKeys},
    {"variables", QT_TRANSLATE_NOOP("Pages", "Variables"), "variables", "Ctrl+5", create<pages::VariablesPage>,
        variablesHelp, variablesKeys},
    {"position", QT_TRANSLATE_NOOP("Pages", "Position"), "position", "Ctrl+6", create<pages::PositionPage>,
        positionHelp},
    {"motion", QT_TRANSLATE_NOOP("Pages", "Jog and move"), "motion", "Ctrl+J", create<pages::MotionPage>, motionHelp,
        motionKeys},
    {"trend", QT_TRANSLATE_NOOP("Pages", "Trend"), "trend", "Ctrl+T", create<pages::TrendPage>, trendHelp, trendKeys},
    {"jobs", QT_TRANSLATE_NOOP("Pages", "Jobs"), "jobs", "Ctrl+7", create<pages::JobsPage>, jobsHelp, jobsKeys},
    {"files", QT_TRANSLATE_NOOP("Pages", "Files"), "files", "Ctrl+8", create<pages::FilesPage>, filesHelp},
    {"backup", QT_TRANSLATE_NOOP("Pages", "Backup"), "backup", "Ctrl+9", create<pages::BackupPage>, backupHelp},
    {"journal", QT_TRANSLATE_NOOP("Pages", "Journal"), "journal", "Ctrl+0", create<pages::JournalPage>, journalHelp,
        journalKeys},
    {"fleet", QT_TRANSLATE_NOOP("Pages", "Fleet"), "overview", "Ctrl+Shift+F", create<pages::FleetPage>, fleetHelp},
};

} // namespace

std::span<const PageRow> pageCatalog() { return pageRows; }

QString title(const PageRow &row) { return QCoreApplication::translate("Pages", row.title); }

QStringList helpOf(const PageRow &row)
{
    QStringList sentences;
    for (const char *sentence : row.help)
        sentences << QCoreApplication::translate("Pages", sentence);
    return sentences;
}

QString text(const PageKey &key) { return QCoreApplication::translate("Pages", key.what); }

} // namespace ui
