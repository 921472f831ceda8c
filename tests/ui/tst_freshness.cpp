// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/harness.h"
#include "ui/pagecatalog.h"
#include "ui/widgets/toolpathview.h"

using robot::Freshness;

/// What is fresh looks fresh: on a page whose values are all live no widget is hatched, however often pages change.
class FreshnessTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void noLivePageIsHatched();
};

namespace {

/// Those that show a value as stale.
QStringList hatchedIn(const QWidget &page)
{
    QStringList result;
    for (const auto *label : page.findChildren<widgets::ValueLabel *>()) {
        if (label->isVisible() && label->shown().freshness == Freshness::Stale)
            result << label->objectName();
    }
    for (const auto *view : page.findChildren<widgets::ToolPathView *>()) {
        if (view->isVisible() && view->isStale())
            result << view->objectName();
    }
    return result;
}

} // namespace

void FreshnessTest::noLivePageIsHatched()
{
    Harness harness;
    QVERIFY(harness.connectLive());
    int looks = 0;
    int hatched = 0;
    for (int round = 0; round < 3; ++round) {
        for (int row = 0; row < int(ui::pageCatalog().size()); ++row) {
            harness.window.view().openPage(row);
            const pages::Page *page = harness.window.view().page(row);
            const auto isEveryTopicLive = [&] {
                for (const robot::TopicRange &range : page->topics()) {
                    for (int number = range.first; number <= range.last; ++number) {
                        const auto freshness = harness.state().freshness({range.kind, quint16(number)});
                        if (freshness != Freshness::Live && freshness != Freshness::Refused)
                            return false;
                    }
                }
                return true;
            };
            QTRY_VERIFY(isEveryTopicLive());
            const QStringList found = hatchedIn(*page);
            QVERIFY2(found.isEmpty(), qPrintable(page->objectName() + QStringLiteral(": ") + found.join(u' ')));
            hatched += int(found.size());
            ++looks;
        }
    }
    qInfo("%d pages with live values looked at, %d values marked stale", looks, hatched);
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    FreshnessTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_freshness.moc"
