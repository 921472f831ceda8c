// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/connectiondialog.h"

#include "ui/harness.h"
#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>

/// Driven by its named widgets.
class TestConnectionDialog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void addsAndSaves();
    void complains_data();
    void complains();
    void nameOfAnotherIsRefused();
    void duplicatesAndRemoves();
    void renames();
    void connects();
    void diagnosisCanBeCopied();
};

namespace {

/// A dialog over the harness's window.
struct Desk : Harness {
    Desk()
    {
        window.show();
        window.actions().action(ui::ActionId::Connect)->trigger();
        dialog = window.findChild<dialogs::ConnectionDialog *>();
    }
    void reopen()
    {
        delete dialog;
        window.actions().action(ui::ActionId::Connect)->trigger();
        dialog = window.findChild<dialogs::ConnectionDialog *>();
    }
    template <typename Widget> [[nodiscard]] Widget *find(const char *name) const
    {
        return dialog->findChild<Widget *>(QLatin1String(name));
    }
    void click(const char *name) const { QTest::mouseClick(find<QPushButton>(name), Qt::LeftButton); }
    void type(const char *name, const QString &text) const
    {
        auto *edit = find<QLineEdit>(name);
        edit->selectAll();
        QTest::keyClicks(edit, text);
    }
    [[nodiscard]] settings::Profile stored(const char *name) const
    {
        settings::Profile profile;
        profile.name = QLatin1String(name);
        profile.host = QStringLiteral("192.168.1.31");
        return profile;
    }

    QPointer<dialogs::ConnectionDialog> dialog;
};

} // namespace

void TestConnectionDialog::addsAndSaves()
{
    Desk desk;
    desk.click("addProfile");
    desk.type("profileName", QStringLiteral("CELL 5"));
    desk.type("profileHost", QStringLiteral("192.168.1.32"));
    desk.find<QSpinBox>("profileWindow")->setValue(4);
    desk.click("saveProfile");
    const auto profile = desk.store.find(QStringLiteral("CELL 5"));
    QVERIFY(profile);
    QCOMPARE(profile->host, QStringLiteral("192.168.1.32"));
    QCOMPARE(profile->window, 4);
    QCOMPARE(desk.find<QListWidget>("profileList")->currentItem()->text(), QStringLiteral("CELL 5"));
}

void TestConnectionDialog::complains_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("host");
    QTest::addColumn<bool>("isGood");
    QTest::newRow("good") << QStringLiteral("A") << QStringLiteral("h") << true;
    QTest::newRow("no name") << QStringLiteral(" ") << QStringLiteral("h") << false;
    QTest::newRow("no host") << QStringLiteral("A") << QStringLiteral(" ") << false;
}

void TestConnectionDialog::complains()
{
    QFETCH(QString, name);
    QFETCH(QString, host);
    QFETCH(bool, isGood);
    Desk desk;
    desk.click("addProfile");
    desk.type("profileName", name);
    desk.type("profileHost", host);
    QCOMPARE(desk.find<QLabel>("complaint")->text().isEmpty(), isGood);
    QCOMPARE(desk.find<QPushButton>("saveProfile")->isEnabled(), isGood);
    QCOMPARE(desk.find<QPushButton>("connectProfile")->isEnabled(), isGood);
}

void TestConnectionDialog::nameOfAnotherIsRefused()
{
    Desk desk;
    desk.store.save(desk.stored("A"));
    desk.store.save(desk.stored("B"));
    desk.reopen();
    desk.type("profileName", QStringLiteral("B"));
    QVERIFY(desk.find<QLabel>("complaint")->text().contains(QStringLiteral("“B”")));
    QVERIFY(!desk.find<QPushButton>("saveProfile")->isEnabled());
}

void TestConnectionDialog::duplicatesAndRemoves()
{
    Desk desk;
    desk.store.save(desk.stored("A"));
    desk.reopen();
    desk.click("duplicateProfile");
    QCOMPARE(desk.store.profiles().size(), 2);
    QCOMPARE(desk.find<QListWidget>("profileList")->currentItem()->text(), QStringLiteral("A (2)"));
    desk.click("removeProfile");
    QCOMPARE(desk.store.profiles().size(), 1);
    QVERIFY(desk.store.find(QStringLiteral("A")));
}

void TestConnectionDialog::renames()
{
    Desk desk;
    desk.store.save(desk.stored("A"));
    desk.reopen();
    desk.type("profileName", QStringLiteral("C"));
    desk.click("saveProfile");
    QVERIFY(desk.store.find(QStringLiteral("C")));
    QVERIFY(!desk.store.find(QStringLiteral("A")));
}

void TestConnectionDialog::connects()
{
    Desk desk;
    QVERIFY(desk.startController());
    desk.store.save(desk.profile());
    desk.reopen();
    desk.click("connectProfile");
    QTRY_VERIFY(desk.isAllLive());
    QTRY_VERIFY(!desk.dialog); // nothing is left to be said
    QCOMPARE(desk.store.lastUsed(), desk.profile().name);
}

void TestConnectionDialog::diagnosisCanBeCopied()
{
    Desk desk;
    QVERIFY(desk.startController());
    desk.window.offer(desk.profile());
    desk.window.actions().action(ui::ActionId::Diagnose)->trigger();
    auto *copy = desk.window.findChild<QPushButton *>(QStringLiteral("copyDiagnosis"));
    QVERIFY(copy);
    QTRY_VERIFY(copy->isEnabled());
    QTest::mouseClick(copy, Qt::LeftButton);
    const QString text = QGuiApplication::clipboard()->text();
    QVERIFY2(text.contains(QStringLiteral("CELL 4 · Weld (127.0.0.1")), qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral("\n✓ ")), qPrintable(text));
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TestConnectionDialog test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_connectiondialog.moc"
