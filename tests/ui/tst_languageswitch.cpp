// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/sheet.h"

#include "ui/language.h"
#include <QComboBox>
#include <QDialog>
#include <QSignalSpy>

namespace {

QString entryText(const ui::MainWindow &window)
{
    return window.findChild<QPushButton *>(QStringLiteral("variablesEntry"))->text();
}

/// Chooses in the dialog as a person does.
void choose(ui::MainWindow &window, const QString &language)
{
    window.actions().action(ui::ActionId::Appearance)->trigger();
    auto *dialog = window.findChild<QDialog *>(QStringLiteral("appearanceDialog"));
    QVERIFY(dialog);
    auto *box = dialog->findChild<QComboBox *>(QStringLiteral("language"));
    box->setCurrentIndex(box->findData(language));
    QTest::mouseClick(dialog->findChild<QPushButton *>(QStringLiteral("okButton")), Qt::LeftButton);
}

} // namespace

/// Another language at run time: the words are new, the link and what was read are not.
class TestLanguageSwitch : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { QVERIFY(ui::speak(*qApp, QStringLiteral("en"))); }

    void everyWordIsNewAndTheLinkStays()
    {
        Sheet room {"variables"};
        QVERIFY(room.open());
        ui::MainWindow &window = room.harness.window;
        const auto *controller = &window.controller();
        QSignalSpy links {controller, &robot::Controller::linkStateChanged};
        choose(window, QStringLiteral("de"));
        QTRY_COMPARE(entryText(window), u"Variablen");
        QCOMPARE(&window.controller(), controller);
        QCOMPARE(links.size(), 0);
        QVERIFY(window.controller().linkState() == robot::LinkState::Monitoring);
        QCOMPARE(window.view().page(window.view().openRow())->objectName(), u"variablesPage");
        QCOMPARE(window.actions().action(ui::ActionId::Quit)->text(), u"Beenden");
        QCOMPARE(room.harness.store.appearance().language, u"de");
        QVERIFY(room.harness.value("servo")->shown().freshness == robot::Freshness::Live);
        choose(window, QStringLiteral("ja"));
        QTRY_COMPARE(entryText(window), u"変数");
        QCOMPARE(links.size(), 0);
    }

    void ordersAreWrittenDownOnce()
    {
        Harness harness;
        QVERIFY(harness.connectLive());
        choose(harness.window, QStringLiteral("de"));
        QTRY_COMPARE(entryText(harness.window), u"Variablen");
        QSignalSpy recorded {&harness.window.view().orders(), &robot::Orders::recorded};
        harness.access().enter(robot::Level::Operate);
        harness.window.view().releaseLock([] {});
        QTRY_COMPARE(recorded.size(), 1);
        qsizetype rows = -1;
        harness.journal.orders({}, {}, 100, this, [&](const auto &page) { rows = page ? page->records.size() : -2; });
        QTRY_VERIFY(rows != -1);
        QCOMPARE(rows, 1);
    }

    void stagedEditsAreKept()
    {
        Sheet room {"variables"};
        QVERIFY(room.open());
        ui::MainWindow &window = room.harness.window;
        room.type(0, QStringLiteral("17"));
        QCOMPARE(room.harness.fleet.unfinished().size(), 1);
        choose(window, QStringLiteral("de"));
        QVERIFY(!window.findChild<QDialog *>(QStringLiteral("unfinishedBox")));
        QTRY_COMPARE(entryText(window), u"Variablen");
        QCOMPARE(room.harness.fleet.unfinished().size(), 1);
        QCOMPARE(window.view().station()->edits.staged().edits().size(), 1);
    }

    void closingAsksAboutStagedEdits()
    {
        Sheet room {"variables"};
        QVERIFY(room.open());
        ui::MainWindow &window = room.harness.window;
        room.type(0, QStringLiteral("17"));
        const auto answer = [&](const char *button) {
            auto *box = window.findChild<QDialog *>(QStringLiteral("unfinishedBox"));
            QVERIFY(box);
            QTest::mouseClick(box->findChild<QAbstractButton *>(QLatin1String(button)), Qt::LeftButton);
        };
        QVERIFY(!window.close());
        answer("cancelButton");
        QVERIFY(window.isVisible());
        QTRY_VERIFY(!window.findChild<QDialog *>(QStringLiteral("unfinishedBox")));
        QVERIFY(!window.close());
        answer("loseUnfinished");
        QTRY_VERIFY(!window.isVisible());
    }

    void armingDoesNotSurvive()
    {
        Harness harness;
        QVERIFY(harness.connectLive());
        harness.access().enter(robot::Level::Operate);
        QVERIFY(harness.window.view().orders().arm());
        choose(harness.window, QStringLiteral("de"));
        QTRY_COMPARE(entryText(harness.window), u"Variablen");
        QVERIFY(!harness.window.view().orders().isArmed());
    }

    void lightAndDarkChangeAlone()
    {
        Harness harness;
        QVERIFY(harness.connectLive());
        const auto *view = &harness.window.view();
        harness.window.actions().action(ui::ActionId::Appearance)->trigger();
        auto *dialog = harness.window.findChild<QDialog *>(QStringLiteral("appearanceDialog"));
        auto *box = dialog->findChild<QComboBox *>(QStringLiteral("scheme"));
        box->setCurrentIndex(box->findData(QStringLiteral("dark")));
        QTest::mouseClick(dialog->findChild<QPushButton *>(QStringLiteral("okButton")), Qt::LeftButton);
        QTRY_VERIFY(ui::schemeOf(QApplication::palette()) == ui::Scheme::Dark);
        QCOMPARE(&harness.window.view(), view); // no page was made anew
        QCOMPARE(harness.store.appearance().scheme, u"dark");
        ui::apply(*qApp, ui::Scheme::Light);
    }
};

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TestLanguageSwitch test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_languageswitch.moc"
