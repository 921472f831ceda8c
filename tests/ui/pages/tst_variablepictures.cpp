// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/sheet.h"

using robot::LinkState;

/// The variables page as a person sees it, to be looked at.
class TestVariablePictures : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { QLocale::setDefault(QLocale::c()); }
    void everyTab();
    void positions();
};

void TestVariablePictures::everyTab()
{
    Sheet room;
    QVERIFY(room.open());
    const auto name = [](const char *id) { return QStringLiteral("variables-%1").arg(QLatin1String(id)); };
    room.memory().b[7].value = 40;
    room.memory().b[4].value = 19;
    QTRY_COMPARE(room.text(7), QStringLiteral("40"));
    room.type(2, QStringLiteral("5"));
    room.type(7, QStringLiteral("41"));
    QTRY_VERIFY(room.isSettled());
    room.picture(name("staged"));
    // A job of the controller writes B007 as well.
    auto &orders = room.harness.window.view().orders();
    connect(&orders, &robot::Orders::recorded, this, [&room] { room.memory().b[7].value = 40; });
    QVERIFY(room.apply());
    QTRY_VERIFY2(room.text(7).contains(QStringLiteral("reads 40")), qPrintable(room.text(7)));
    QVERIFY(room.activate());
    room.select(4);
    QTest::keyClick(room.table(), Qt::Key_Return);
    auto *editor = room.table()->findChild<QLineEdit *>(QStringLiteral("cellEditor"));
    QVERIFY(editor);
    editor->setText(QStringLiteral("18"));
    QTRY_VERIFY(room.isSettled());
    room.picture(name("mismatch"));
    QTest::keyClick(editor, Qt::Key_Escape);
    for (int tab = 0; tab < room.tabs()->count(); ++tab) {
        room.tabs()->setCurrentIndex(tab);
        QTRY_VERIFY(room.isSettled());
        room.picture(name(qPrintable(room.tabs()->tabText(tab))));
    }
    room.tabs()->setCurrentIndex(0);
    room.harness.window.resize(1024, 768);
    QTRY_VERIFY(room.isSettled());
    room.picture(name("small"));
    room.harness.window.resize(1440, 900);
    room.harness.stopController();
    QTRY_VERIFY(room.harness.window.controller().linkState() == LinkState::Lost);
    room.picture(name("stale"));
}

/// The editor of a position, one that is staged, and what Apply would do.
void TestVariablePictures::positions()
{
    Sheet room;
    QVERIFY(room.open());
    values::PositionVariable place;
    place.position.type = values::PositionType::Base;
    place.position.axes = {-1085123, -234567, 620123, -1799999, -101234, -1101234, 0, 0};
    room.memory().p[1] = place;
    room.tabs()->setCurrentIndex(5);
    QTRY_VERIFY(room.isSettled());
    room.select(1);
    QTest::keyClick(room.table(), Qt::Key_Return);
    QDialog *dialog = room.dialog("positionDialog");
    QVERIFY(dialog);
    dialog->activateWindow();
    QTRY_VERIFY(dialog->isActiveWindow());
    auto *axis = dialog->findChild<QLineEdit *>(QStringLiteral("axis1"));
    axis->setFocus();
    QVERIFY(axis->hasFocus());
    axis->setText(QStringLiteral("812,5"));
    room.picture(QStringLiteral("variables-position-dialog"), dialog);
    QTest::mouseClick(dialog->findChild<QPushButton *>(QStringLiteral("stageButton")), Qt::LeftButton);
    QVERIFY(room.activate());
    QTRY_VERIFY(room.isSettled());
    room.picture(QStringLiteral("variables-position-staged"));
    room.click("write-variable");
    dialog = room.dialog("applyDialog");
    QVERIFY(dialog);
    room.picture(QStringLiteral("variables-apply-dialog"), dialog);
    dialog->reject();
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TestVariablePictures test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_variablepictures.moc"
