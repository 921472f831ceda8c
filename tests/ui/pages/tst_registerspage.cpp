// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/registerspage.h"

#include "ui/pages/sheet.h"
#include <QComboBox>

/// Registers have no numbering, four ways of writing and a part that can only be read.
class TestRegistersPage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { QLocale::setDefault(QLocale::c()); }
    void areWrittenInFourWays();
};

void TestRegistersPage::areWrittenInFourWays()
{
    Sheet room {"registers"};
    QVERIFY(room.open(false)); // registers have no numbering
    room.memory().registers[5].value = 0xFFFE;
    room.find<QComboBox>("base")->setCurrentIndex(2);
    QTRY_COMPARE(room.text(5), QStringLiteral("0xFFFE"));
    room.type(5, QStringLiteral("1F"));
    QCOMPARE(room.text(5), QStringLiteral("0xFFFE → 0x001F"));
    room.click("write-register");
    QDialog *box = room.dialog("applyDialog");
    QVERIFY(box);
    QTest::mouseClick(box->findChild<QPushButton *>(QStringLiteral("applyConfirm")), Qt::LeftButton);
    QTRY_COMPARE(room.memory().registers[5].value, 0x1F);
    room.select(560);
    QTest::keyClick(room.table(), Qt::Key_Return);
    QVERIFY(room.find<QLabel>("sentence")->text().contains(QStringLiteral("M560 can only be read")));
    QVERIFY(room.page->topics().last().last >= 560);
    QTRY_VERIFY(room.isSettled());
    room.picture(QStringLiteral("registers-hex"));
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TestRegistersPage test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_registerspage.moc"
