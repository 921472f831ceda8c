// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pagecatalog.h"

#include "ui/pages/alarmspage.h"
#include "ui/pages/jobspage.h"
#include "ui/pages/journalpage.h"
#include "ui/pages/overviewpage.h"
#include "ui/pages/positionpage.h"
#include "ui/pages/trendpage.h"
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
    {"position", TITLE("Position"), "position", "Ctrl+6", create<pages::PositionPage>},
    {"trend", TITLE("Trend"), "trend", "Ctrl+T", create<pages::TrendPage>},
    {"jobs", TITLE("Jobs"), "jobs", "Ctrl+7", create<pages::JobsPage>},
    {"journal", TITLE("Journal"), "journal", "Ctrl+0", create<pages::JournalPage>},
};
#undef TITLE

} // namespace

std::span<const PageRow> pageCatalog() { return rows; }

QString title(const PageRow &row) { return QCoreApplication::translate("Pages", row.title); }

} // namespace ui
