// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/numberingdialog.h"

#include "ui/pages/sheet.h"
#include <QSpinBox>

/// RS022 is found out with the pendant, and kept.
class TestNumberingDialog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { QLocale::setDefault(QLocale::c()); }
    void comparesWithThePendant();
};

void TestNumberingDialog::comparesWithThePendant()
{
    Sheet room;
    virtualcontroller::Options options;
    options.port = 0;
    options.filePort = 0;
    options.settings.numbering = protocol::Numbering::FromOne;
    room.harness.server = std::make_unique<virtualcontroller::Server>(options);
    QVERIFY(room.harness.server->start());
    room.harness.port = room.harness.server->port();
    room.harness.filePort = room.harness.server->filePort();
    for (int number = 0; number < 100; ++number)
        room.memory().b[std::size_t(number)].value = quint8(number + 100);
    settings::Profile profile = room.harness.profile();
    room.harness.store.save(profile);
    QVERIFY(room.open(profile));
    QTRY_VERIFY(room.dialog("readinessSheet")); // a real controller, for the first time
    room.dialog("readinessSheet")->close();
    room.click("numberingButton");
    QDialog *dialog = room.dialog("numberingDialog");
    QVERIFY(dialog);
    const auto number = [&](const char *name) { return dialog->findChild<QSpinBox *>(QLatin1String(name)); };
    const auto *sentence = dialog->findChild<QLabel *>(QStringLiteral("sentence"));
    QTRY_VERIFY(sentence->text().contains(QStringLiteral("tell")));
    auto *compare = dialog->findChild<QPushButton *>(QStringLiteral("compareButton"));
    auto *keep = dialog->findChild<QPushButton *>(QStringLiteral("keepButton"));
    number("value1")->setValue(3);
    QTest::mouseClick(compare, Qt::LeftButton);
    QTRY_VERIFY(sentence->text().contains(QStringLiteral("Neither")));
    QVERIFY(!keep->isEnabled());
    for (const auto &[numberName, valueName] : {std::pair {"number1", "value1"}, {"number2", "value2"}})
        number(valueName)->setValue(room.memory().b[std::size_t(number(numberName)->value())].value);
    QTest::mouseClick(compare, Qt::LeftButton);
    QTRY_VERIFY(keep->isEnabled());
    QTest::mouseClick(keep, Qt::LeftButton);
    // Kept with date and software, and the values stand at their own numbers now.
    QTRY_VERIFY(room.harness.store.find(profile.name)->numberingVerified.isValid());
    QVERIFY(room.harness.store.find(profile.name)->numbering == protocol::Numbering::FromOne);
    QVERIFY(!room.harness.store.find(profile.name)->numberingSoftware.isEmpty());
    QTRY_COMPARE(room.text(7), QStringLiteral("107"));
    QTRY_VERIFY(room.find<QLabel>("note")->text().startsWith(QStringLiteral("Numbering verified")));
    room.type(7, QStringLiteral("9"));
    QVERIFY(room.apply());
    QTRY_COMPARE(room.memory().b[7].value, 9);
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TestNumberingDialog test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_numberingdialog.moc"
