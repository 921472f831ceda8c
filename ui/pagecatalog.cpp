// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pagecatalog.h"

#include "ui/pages/alarmspage.h"
#include "ui/pages/backuppage.h"
#include "ui/pages/filespage.h"
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

#define TITLE(text) QT_TRANSLATE_NOOP("Pages", text)
constexpr PageRow rows[] {
    {"overview", TITLE("Overview"), "overview", "Ctrl+1", create<pages::OverviewPage>},
    {"alarms", TITLE("Alarms"), "alarms", "Ctrl+2", create<pages::AlarmsPage>},
    {"io", TITLE("I/O"), "io", "Ctrl+3", create<pages::IoPage>},
    {"registers", TITLE("Registers"), "registers", "Ctrl+4", create<pages::RegistersPage>},
    {"variables", TITLE("Variables"), "variables", "Ctrl+5", create<pages::VariablesPage>},
    {"position", TITLE("Position"), "position", "Ctrl+6", create<pages::PositionPage>},
    {"motion", TITLE("Jog and move"), "motion", "Ctrl+J", create<pages::MotionPage>},
    {"trend", TITLE("Trend"), "trend", "Ctrl+T", create<pages::TrendPage>},
    {"jobs", TITLE("Jobs"), "jobs", "Ctrl+7", create<pages::JobsPage>},
    {"files", TITLE("Files"), "files", "Ctrl+8", create<pages::FilesPage>},
    {"backup", TITLE("Backup"), "backup", "Ctrl+9", create<pages::BackupPage>},
    {"journal", TITLE("Journal"), "journal", "Ctrl+0", create<pages::JournalPage>},
};
#undef TITLE

} // namespace

std::span<const PageRow> pageCatalog() { return rows; }

QString title(const PageRow &row) { return QCoreApplication::translate("Pages", row.title); }

} // namespace ui
