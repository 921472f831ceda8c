// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/holdkey.h"
#include "ui/theme.h"
#include "ui/widgets/filesheet.h"
#include "ui/widgets/holdbutton.h"
#include "ui/widgets/question.h"
#include "ui/widgets/sheetlayer.h"
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>
#include <QShortcut>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QVBoxLayout>

using namespace widgets;

namespace {

constexpr int strip = 76;

/// A window with HOLD on top and a page with two buttons, as every window of ours.
struct Window : QWidget {
    Window() : hold {new HoldButton(this)}, page {new QPushButton(this)}, other {new QPushButton(this)}
    {
        resize(1024, 768);
        hold->setObjectName(QStringLiteral("holdButton"));
        hold->move(800, 10);
        hold->resize(hold->sizeHint());
        page->setGeometry(0, strip, 1024, 300);
        other->setGeometry(0, 400, 1024, 100);
        layer = new SheetLayer(this, strip);
        show();
        activateWindow();
    }

    [[nodiscard]] bool isReady() { return QTest::qWaitForWindowActive(this); }
    [[nodiscard]] QPoint centre(const QWidget *widget) const { return widget->mapTo(this, widget->rect().center()); }
    /// A click as the desktop delivers it: to whatever lies there.
    void click(const QWidget *widget) const { QTest::mouseClick(windowHandle(), Qt::LeftButton, {}, centre(widget)); }
    [[nodiscard]] DialogSheet *front() const { return layer->isOpen() ? layer->sheets().last() : nullptr; }
    [[nodiscard]] QPushButton *button(const char *name) const { return findChild<QPushButton *>(QLatin1String(name)); }

    HoldButton *hold;
    QPushButton *page;
    QPushButton *other;
    SheetLayer *layer;
};

DialogSheet *tallSheet(Window &window)
{
    auto *sheet = new DialogSheet(&window);
    auto *column = new QVBoxLayout(sheet);
    for (int i = 0; i < 60; ++i)
        column->addWidget(new QPushButton(QString::number(i)));
    sheet->show();
    return sheet;
}

} // namespace

class TestSheetLayer : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { m_count = 0; }

    void holdIsLiveAndThePageIsNot()
    {
        Window window;
        QVERIFY(window.isReady());
        QSignalSpy held {window.hold, &HoldButton::holdRequested};
        QSignalSpy pressed {window.page, &QPushButton::clicked};
        ask("question", QStringLiteral("?"), QStringLiteral("?"), {}, window.page);
        QVERIFY(window.front() && !window.front()->isModal() && !window.front()->isWindow());
        window.click(window.page);
        QCOMPARE(pressed.count(), 0);
        window.click(window.hold);
        QCOMPARE(held.count(), 1);
        QVERIFY(window.front()); // and it stays
    }

    void keysStayInside()
    {
        Window window;
        QVERIFY(window.isReady());
        window.page->setFocus();
        QShortcut shortcut {QKeySequence {Qt::Key_F5}, &window};
        QSignalSpy activated {&shortcut, &QShortcut::activated};
        ask("question", QStringLiteral("?"), QStringLiteral("?"), {{"yes", QStringLiteral("Yes"), [] {}}}, &window);
        for (int i = 0; i < 5; ++i) {
            QVERIFY(window.front()->isAncestorOf(QApplication::focusWidget()));
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        }
        window.other->setFocus(); // whoever does that
        QVERIFY(window.front()->isAncestorOf(QApplication::focusWidget()));
        QTest::keyClick(&window, Qt::Key_F5);
        QCOMPARE(activated.count(), 0);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QVERIFY(!window.layer->isOpen());
        QCOMPARE(QApplication::focusWidget(), window.page);
        QTest::keyClick(&window, Qt::Key_F5);
        QCOMPARE(activated.count(), 1);
    }

    void anAnswerIsTakenOnce()
    {
        Window window;
        QVERIFY(window.isReady());
        ask("question", {}, {}, {{"yes", QStringLiteral("Yes"), [this] { ++m_count; }}}, &window);
        auto *yes = window.button("yes");
        for (int i = 0; i < 2; ++i) { // both wait in the queue before either is seen
            const QPointF place = yes->rect().center();
            for (const auto type : {QEvent::MouseButtonPress, QEvent::MouseButtonRelease})
                QCoreApplication::postEvent(yes,
                    new QMouseEvent(type, place, yes->mapToGlobal(place), Qt::LeftButton,
                        type == QEvent::MouseButtonPress ? Qt::LeftButton : Qt::NoButton, {}));
        }
        QCoreApplication::sendPostedEvents();
        QCOMPARE(m_count, 1);
    }

    void aSecondClickReachesNoPage()
    {
        Window window;
        QVERIFY(window.isReady());
        QSignalSpy pressed {window.page, &QPushButton::clicked};
        ask("question", {}, {}, {{"yes", QStringLiteral("Yes"), [this] { ++m_count; }}}, &window);
        const QPoint place = window.centre(window.button("yes"));
        QVERIFY(window.page->geometry().contains(place));
        QTest::mouseClick(window.windowHandle(), Qt::LeftButton, {}, place);
        QTest::mouseClick(window.windowHandle(), Qt::LeftButton, {}, place);
        QCOMPARE(m_count, 1);
        QCOMPARE(pressed.count(), 0);
        QTRY_VERIFY(!window.layer->isVisible());
        window.click(window.page);
        QCOMPARE(pressed.count(), 1);
    }

    void theSameSheetOpensOnce()
    {
        Window window;
        QVERIFY(window.isReady());
        for (int i = 0; i < 2; ++i)
            ask("question", {}, {}, {}, window.page);
        QCOMPARE(window.layer->sheets().size(), 1);
        ask("question", {}, {}, {}, window.other); // of another owner
        QCOMPARE(window.layer->sheets().size(), 2);
    }

    void theNewestIsInFront()
    {
        Window window;
        QVERIFY(window.isReady());
        ask("first", {}, {}, {}, &window);
        DialogSheet *first = window.front();
        ask("second", {}, {}, {}, first);
        QVERIFY(!first->isEnabled());
        QVERIFY(window.front()->isAncestorOf(QApplication::focusWidget()));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QCOMPARE(window.front(), first);
        QVERIFY(first->isEnabled() && first->isAncestorOf(QApplication::focusWidget()));
    }

    void returnPressesNothingThatWrites()
    {
        Window window;
        QVERIFY(window.isReady());
        ask("question", {}, {}, {{"yes", QStringLiteral("Yes"), [this] { ++m_count; }}}, &window);
        QVERIFY(isWriting(window.button("yes")));
        window.button("yes")->setFocus();
        QTest::keyClick(window.button("yes"), Qt::Key_Return);
        QCOMPARE(m_count, 0);
        QVERIFY(!window.front()); // the default is to do nothing
    }

    void goesWithItsOwner()
    {
        Window window;
        QVERIFY(window.isReady());
        auto *owner = new QWidget(&window);
        ask("question", {}, {}, {}, owner);
        QVERIFY(window.layer->isOpen());
        delete owner;
        QVERIFY(!window.layer->isOpen());
    }

    void whatIsTooTallScrolls()
    {
        Window window;
        QVERIFY(window.isReady());
        DialogSheet *sheet = tallSheet(window);
        QVERIFY(sheet->height() > window.height());
        const QWidget *frame = window.findChild<QWidget *>(QStringLiteral("sheetFrame"));
        QVERIFY(window.layer->rect().contains(frame->geometry()));
        auto *last = sheet->findChildren<QPushButton *>().last();
        last->setFocus();
        QVERIFY(!last->visibleRegion().isEmpty());
        window.resize(800, 600);
        QVERIFY(window.layer->rect().contains(frame->geometry()));
    }

    void growsDownwards()
    {
        Window window;
        QVERIFY(window.isReady());
        auto *sheet = new DialogSheet(&window);
        auto *column = new QVBoxLayout(sheet);
        column->addWidget(new QPushButton);
        sheet->show();
        const QPoint before = sheet->mapTo(&window, QPoint());
        column->addWidget(new QPushButton);
        QCoreApplication::sendPostedEvents();
        QCoreApplication::processEvents();
        QCOMPARE(sheet->mapTo(&window, QPoint()).y(), before.y());
    }

    void keyAndClickHold_data()
    {
        QTest::addColumn<int>("key");
        QTest::newRow("pause") << int(Qt::Key_Pause);
        QTest::newRow("click") << 0;
    }
    /// The first click counts while a list or a menu is open, and so does the key.
    void keyAndClickHold()
    {
        QFETCH(int, key);
        for (const bool isMenu : {false, true}) {
            Window window;
            QVERIFY(window.isReady());
            const ui::HoldKey holdKey;
            QSignalSpy held {window.hold, &HoldButton::holdRequested};
            QComboBox box {&window};
            box.addItems({QStringLiteral("1"), QStringLiteral("2")});
            box.move(10, 100);
            box.show();
            QMenu menu;
            menu.addAction(QStringLiteral("1"));
            if (isMenu)
                menu.popup(window.mapToGlobal(QPoint(10, 300)));
            else
                box.showPopup();
            QTRY_VERIFY(QApplication::activePopupWidget());
            QWidget *popup = QApplication::activePopupWidget();
            QVERIFY(QTest::qWaitForWindowExposed(popup));
            if (key)
                QTest::keyClick(popup->windowHandle(), Qt::Key(key));
            else
                window.click(window.hold);
            QCOMPARE(held.count(), 1);
        }
    }

    void theKeyHoldsWhatIsInFront()
    {
        const ui::HoldKey holdKey;
        Window first;
        Window second;
        QVERIFY(second.isReady());
        QSignalSpy one {first.hold, &HoldButton::holdRequested};
        QSignalSpy two {second.hold, &HoldButton::holdRequested};
        QTest::keyClick(&second, Qt::Key_Pause);
        QCOMPARE(two.count(), 1);
        QCOMPARE(one.count(), 0);
        first.activateWindow();
        QVERIFY(first.isReady());
        QTest::keyClick(&first, Qt::Key_H, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(two.count(), 1);
        QCOMPARE(one.count(), 1);
        QDialog foreign; // without a HOLD of its own
        foreign.show();
        foreign.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&foreign));
        QTest::keyClick(&foreign, Qt::Key_Pause);
        QCOMPARE(one.count(), 2); // it was in front before
    }

    void askedBeforeAFileIsReplaced()
    {
        QTemporaryDir folder;
        const QString old = folder.filePath(QStringLiteral("old.csv"));
        QFile file {old};
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.close();
        Window window;
        QVERIFY(window.isReady());
        QStringList chosen;
        const auto open = [&] {
            return askForPath({"dialog", PathKind::NewFile, QStringLiteral("?"), old, {}, QStringLiteral("csv")},
                &window, [&](const QString &path) { chosen << path; });
        };
        QMetaObject::invokeMethod(open(), "accept");
        QVERIFY(chosen.isEmpty() && window.button("confirmReplaceFile"));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape); // the question alone
        QCOMPARE(window.layer->sheets().size(), 1);
        QMetaObject::invokeMethod(window.findChild<QFileDialog *>(), "accept");
        QTest::mouseClick(window.layer->sheets().last()->findChild<QPushButton *>(QStringLiteral("confirmReplaceFile")),
            Qt::LeftButton);
        QCOMPARE(chosen, QStringList {old});
        QVERIFY(!window.layer->isOpen());
    }

    void aPathThatIsNotThereIsSaid()
    {
        QTemporaryDir folder;
        Window window;
        QVERIFY(window.isReady());
        auto *dialog = askForPath({"dialog", PathKind::OldFile, QStringLiteral("?"), folder.path()}, &window,
            [this](const QString &) { ++m_count; });
        dialog->findChild<QLineEdit *>(QStringLiteral("fileNameEdit"))->setText(QStringLiteral("none.csv"));
        QMetaObject::invokeMethod(dialog, "accept");
        QCOMPARE(m_count, 0);
        QCOMPARE(window.front()->objectName(), QStringLiteral("fileMessage"));
        QVERIFY(!QApplication::activeModalWidget());
    }

private:
    int m_count = 0;
};

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TestSheetLayer test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_sheetlayer.moc"
