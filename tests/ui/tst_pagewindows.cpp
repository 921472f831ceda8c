// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/harness.h"

#include "ui/pagecatalog.h"
#include "ui/pages/page.h"
#include "ui/pagewindow.h"
#include "ui/widgets/holdbutton.h"

/// A page in a window of its own, as on a second screen.
class TestPageWindows : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aPageMovesAndComesBack();
    void theWindowHasHold();
    void windowsComeBackWithTheNextStart();
    void theMainWindowKeepsAPage();
    void noPageFlashesAWindow();

private:
    static ui::PageWindow *windowOf(const Harness &harness, const char *id)
    {
        return harness.window.view().findChild<ui::PageWindow *>(QLatin1String(id) + QStringLiteral("PageWindow"));
    }
    static QString second() { return QLatin1String(ui::pageCatalog()[1].id); }
};

/// A part that is shown before it has a parent is a window for a moment, and takes the focus with it.
void TestPageWindows::noPageFlashesAWindow()
{
    struct Watcher : QObject {
        bool eventFilter(QObject *watched, QEvent *event) override
        {
            const auto *widget = qobject_cast<QWidget *>(watched);
            if (event->type() == QEvent::Show && widget && widget->isWindow())
                windows << watched->objectName();
            return false;
        }
        QStringList windows;
    };
    Harness harness;
    QVERIFY(harness.connectLive());
    Watcher watcher;
    qApp->installEventFilter(&watcher);
    for (int row = 0; row < int(ui::pageCatalog().size()); ++row)
        harness.window.view().openPage(row);
    QCOMPARE(watcher.windows, QStringList());
}

void TestPageWindows::aPageMovesAndComesBack()
{
    Harness harness;
    QVERIFY(harness.connectLive());
    auto &view = harness.window.view();
    view.openInWindow(second());
    QTRY_VERIFY(view.page(0)->isVisible() && view.page(1)->isVisible());
    QCOMPARE(view.pagesInWindows(), QStringList(second()));
    ui::PageWindow *window = windowOf(harness, ui::pageCatalog()[1].id);
    QVERIFY(window);
    window->close();
    QTRY_VERIFY(!view.page(1)->isVisible());
    QVERIFY(view.pagesInWindows().isEmpty());
    view.openPage(1);
    QTRY_VERIFY(view.page(1)->isVisible());
}

void TestPageWindows::theWindowHasHold()
{
    Harness harness;
    QVERIFY(harness.connectLive());
    harness.window.view().openInWindow(second());
    auto *window = windowOf(harness, ui::pageCatalog()[1].id);
    QVERIFY(window);
    auto *hold = window->findChild<widgets::HoldButton *>();
    QVERIFY(hold);
    QTest::mouseClick(hold, Qt::LeftButton);
    QTRY_VERIFY(harness.window.controller().holdState().word == robot::HoldWord::HeldByCommand);
}

void TestPageWindows::windowsComeBackWithTheNextStart()
{
    Harness harness;
    QVERIFY(harness.connectLive());
    harness.window.view().openInWindow(second());
    harness.connectAnew();
    QCOMPARE(harness.window.view().pagesInWindows(), QStringList(second()));
}

void TestPageWindows::theMainWindowKeepsAPage()
{
    Harness harness;
    QVERIFY(harness.connectLive());
    for (const ui::PageRow &row : ui::pageCatalog())
        harness.window.view().openInWindow(QLatin1String(row.id));
    QCOMPARE(harness.window.view().pagesInWindows().size(), qsizetype(ui::pageCatalog().size()) - 1);
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TestPageWindows test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_pagewindows.moc"
