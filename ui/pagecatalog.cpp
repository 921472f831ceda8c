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

constexpr PageRow pageRows[] {
    {"overview", QT_TRANSLATE_NOOP("Pages", "Overview"), "overview", "Ctrl+1", create<pages::OverviewPage>},
    {"alarms", QT_TRANSLATE_NOOP("Pages", "Alarms"), "alarms", "Ctrl+2", create<pages::AlarmsPage>},
    {"io", QT_TRANSLATE_NOOP("Pages", "I/O"), "io", "Ctrl+3", create<pages::IoPage>},
    {"registers", QT_TRANSLATE_NOOP("Pages", "Registers"), "registers", "Ctrl+4", create<pages::RegistersPage>},
    {"variables", QT_TRANSLATE_NOOP("Pages", "Variables"), "variables", "Ctrl+5", create<pages::VariablesPage>},
    {"position", QT_TRANSLATE_NOOP("Pages", "Position"), "position", "Ctrl+6", create<pages::PositionPage>},
    {"motion", QT_TRANSLATE_NOOP("Pages", "Jog and move"), "motion", "Ctrl+J", create<pages::MotionPage>},
    {"trend", QT_TRANSLATE_NOOP("Pages", "Trend"), "trend", "Ctrl+T", create<pages::TrendPage>},
    {"jobs", QT_TRANSLATE_NOOP("Pages", "Jobs"), "jobs", "Ctrl+7", create<pages::JobsPage>},
    {"files", QT_TRANSLATE_NOOP("Pages", "Files"), "files", "Ctrl+8", create<pages::FilesPage>},
    {"backup", QT_TRANSLATE_NOOP("Pages", "Backup"), "backup", "Ctrl+9", create<pages::BackupPage>},
    {"journal", QT_TRANSLATE_NOOP("Pages", "Journal"), "journal", "Ctrl+0", create<pages::JournalPage>},
};

} // namespace

std::span<const PageRow> pageCatalog() { return pageRows; }

QString title(const PageRow &row) { return QCoreApplication::translate("Pages", row.title); }

} // namespace ui
