// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/harness.h"
#include "ui/widgets/orderbutton.h"

#include <QDialog>
#include <QPushButton>
#include <QSignalSpy>

using robot::Act;
using robot::Level;
using robot::Situation;
using widgets::OrderButton;

class TestOrderButton : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void saysWhyNotBeforeItIsTried()
    {
        Harness harness;
        QVERIFY(harness.connectLive());
        OrderButton button {harness.window.view().orders(), Act::ResetAlarm};
        button.show();
        QSignalSpy clicks {&button, &OrderButton::clicked};
        QVERIFY(!button.button()->isEnabled());
        QVERIFY(reason(button)->isVisible());
        QVERIFY(reason(button)->text().startsWith(QStringLiteral("The access level is Monitor")));
        QTest::mouseClick(button.button(), Qt::LeftButton);
        QCOMPARE(clicks.count(), 0);
        harness.access().enter(Level::Operate);
        QVERIFY(button.button()->isEnabled());
        QCOMPARE(reason(button)->text(), QString()); // its room stays
        QTest::mouseClick(button.button(), Qt::LeftButton);
        QCOMPARE(clicks.count(), 1);
        harness.server->memory().status.data1.setFlag(values::Status::Remote, false);
        QTRY_VERIFY(!button.button()->isEnabled());
        QVERIFY(reason(button)->text().startsWith(QStringLiteral("REMOTE is off")));
    }

    void pagesMayObjectToo()
    {
        Harness harness;
        QVERIFY(harness.connectLive());
        harness.access().enter(Level::Engineer);
        OrderButton button {harness.window.view().orders(), Act::WriteRegister};
        button.setComplaint(QStringLiteral("Type a number first."));
        button.show();
        QVERIFY(!button.button()->isEnabled());
        QCOMPARE(reason(button)->text(), QStringLiteral("Type a number first."));
        button.setComplaint({});
        QVERIFY(button.button()->isEnabled());
    }

    void isPendingUntilTheSituationAgrees()
    {
        Harness harness;
        QVERIFY(harness.connectLive());
        harness.access().enter(Level::Operate);
        OrderButton button {harness.window.view().orders(), Act::SelectCycle};
        button.show();
        button.expect([](const Situation &s) { return s.status && s.status->data1.testFlag(values::Status::Step); });
        QVERIFY(button.isPending());
        QVERIFY(!button.button()->isEnabled());
        QCOMPARE(button.button()->toolTip(), QStringLiteral("Pending…"));
        auto &data1 = harness.server->memory().status.data1;
        data1.setFlag(values::Status::Continuous, false);
        data1.setFlag(values::Status::Step);
        QTRY_VERIFY(!button.isPending());
        QVERIFY(button.button()->isEnabled());
        button.expect([](const Situation &) { return false; });
        button.stopExpecting();
        QVERIFY(button.button()->isEnabled());
    }

    /// While it is pending Return and Space go nowhere, and afterwards they are where they were.
    void theFocusStaysInItsPlace()
    {
        Harness harness;
        QVERIFY(harness.connectLive());
        harness.access().enter(Level::Operate);
        OrderButton button {harness.window.view().orders(), Act::SelectCycle};
        button.show();
        button.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&button));
        button.button()->setFocus();
        button.expect([](const Situation &) { return false; });
        QCOMPARE(QApplication::focusWidget(), &button);
        button.stopExpecting();
        QCOMPARE(QApplication::focusWidget(), button.button());
    }

    void stoppingAsksForNothing()
    {
        Harness harness;
        OrderButton button {harness.window.view().orders(), Act::ServoOff};
        button.show();
        QVERIFY(button.button()->isEnabled());
        QVERIFY(!button.findChild<QPushButton *>(QStringLiteral("why-servo-off"))->isVisible());
    }

    void listsItsConditionsLive()
    {
        Harness harness;
        QVERIFY(harness.connectLive());
        OrderButton button {harness.window.view().orders(), Act::StartJob};
        button.show();
        auto *why = button.findChild<QPushButton *>(QStringLiteral("why-start"));
        QCOMPARE(why->text(), QStringLiteral("Why not?"));
        QTest::mouseClick(why, Qt::LeftButton);
        auto *dialog = button.findChild<QDialog *>(QStringLiteral("whyNotDialog"));
        QVERIFY(dialog);
        const auto words = [&](int row) {
            return dialog->findChild<QLabel *>(QStringLiteral("condition%1").arg(row))->text();
        };
        const auto remedy = [&](int row) { return dialog->findChild<QLabel *>(QStringLiteral("remedy%1").arg(row)); };
        QCOMPARE(words(0), QStringLiteral("The link to the controller is up"));
        QCOMPARE(words(1), QStringLiteral("The access level is Monitor"));
        QVERIFY(remedy(1)->isVisible());
        QVERIFY(!remedy(0)->isVisible());
        QVERIFY(words(16).endsWith(QStringLiteral("cannot be read over HSES")));
        harness.access().enter(Level::Engineer);
        QCOMPARE(words(1), QStringLiteral("The access level is Operate or Engineer"));
        QVERIFY(!remedy(1)->isVisible());
    }

private:
    static QLabel *reason(const OrderButton &button)
    {
        for (QLabel *label : button.findChildren<QLabel *>()) {
            if (label->objectName().startsWith(QStringLiteral("reason-")))
                return label;
        }
        return nullptr;
    }
};

QTEST_MAIN(TestOrderButton)
#include "tst_orderbutton.moc"
