// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/alldialogs.h"
#include "ui/widgets/dialogsheet.h"
#include "ui/widgets/sheetlayer.h"

#include <QMouseEvent>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>

namespace {

constexpr int motionPage = 6;

/// Two clicks that both wait in the event queue before either is seen, as after a standstill of the program.
void clickTwice(QWidget *button)
{
    const QPointF place = button->rect().center();
    for (int i = 0; i < 2; ++i) {
        for (const auto type : {QEvent::MouseButtonPress, QEvent::MouseButtonRelease})
            QCoreApplication::postEvent(button,
                new QMouseEvent(type, place, button->mapToGlobal(place), Qt::LeftButton,
                    type == QEvent::MouseButtonPress ? Qt::LeftButton : Qt::NoButton, {}));
    }
}

} // namespace

/// What holds for every dialog of ours, whatever it is about.
class TestSheets : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_harness.connectLive());
        m_harness.access().enter(robot::Level::Engineer);
        m_harness.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&m_harness.window));
        m_harness.window.view().openPage(motionPage);
        connect(&m_harness.window.view().orders(), &robot::Orders::recorded, this,
            [this](const journal::OrderRecord &record) {
                if (record.outcome != journal::Outcome::Withheld)
                    m_sent << record.action + u' ' + record.subject + u' ' + record.newValue;
            });
    }
    void cleanup()
    {
        layer()->clear();
        QTRY_VERIFY(!layer()->isVisible());
        m_sent.clear();
    }

    void holdIsInReach_data() { rows(); }
    void holdIsInReach()
    {
        QVERIFY(open());
        QVERIFY(!m_dialog->isModal() && !m_dialog->isWindow());
        const auto *hold = m_harness.window.findChild<QAbstractButton *>(QStringLiteral("holdButton"));
        const QPoint place = hold->mapTo(&m_harness.window, hold->rect().center());
        QCOMPARE(m_harness.window.childAt(place), hold);
        using values::Status;
        Status &status = m_harness.server->memory().status;
        status.data2.setFlag(Status::HeldByCommand, false);
        QTest::mouseClick(m_harness.window.windowHandle(), Qt::LeftButton, {}, place);
        QTRY_VERIFY(status.data2 & Status::HeldByCommand);
        QVERIFY(m_dialog && m_dialog->isVisible());
        status.data2.setFlag(Status::HeldByCommand, false);
    }

    void nothingThatWritesIsPressedByReturn_data() { rows(); }
    void nothingThatWritesIsPressedByReturn()
    {
        QVERIFY(open());
        const auto *focus = qobject_cast<QPushButton *>(QApplication::focusWidget());
        QVERIFY(!focus || !widgets::isWriting(focus));
        for (const QPushButton *button : m_dialog->findChildren<QPushButton *>())
            QVERIFY2(!widgets::isWriting(button) || !(button->isDefault() || button->autoDefault()),
                qPrintable(button->objectName()));
        const qsizetype count = m_dialog->findChildren<QWidget *>().size();
        for (qsizetype i = 0; i < count; ++i) {
            if (!m_dialog || m_dialog->isHidden())
                QVERIFY(open()); // Return has closed it
            const auto inside = m_dialog->findChildren<QWidget *>();
            QWidget *widget = i < inside.size() ? inside[i] : nullptr;
            if (!widget || !widget->isVisible() || !widget->isEnabled() || widget->focusPolicy() == Qt::NoFocus)
                continue;
            widget->setFocus();
            QTest::keyClick(widget, Qt::Key_Return);
        }
        QCoreApplication::processEvents();
        QCOMPARE(m_sent.join(u", "), QString());
    }

    void everyAnswerCountsOnce_data() { rows(); }
    void everyAnswerCountsOnce()
    {
        QVERIFY(open());
        QStringList names;
        for (const QPushButton *button : m_dialog->findChildren<QPushButton *>()) {
            if (button->isVisible() && button->isEnabled() && !button->objectName().isEmpty())
                names << button->objectName();
        }
        for (const QString &name : names) {
            layer()->clear();
            m_sent.clear();
            QVERIFY(open());
            auto *button = m_dialog->findChild<QPushButton *>(name);
            if (!button || !button->isEnabled())
                continue;
            QSignalSpy finished {m_dialog.data(), &QDialog::finished};
            clickTwice(button);
            QCoreApplication::sendPostedEvents();
            QCoreApplication::processEvents();
            QVERIFY2(finished.count() <= 1, qPrintable(name));
            QVERIFY2(layer()->sheets().size() <= 2, qPrintable(name)); // it, or it and what it asks
            QTRY_VERIFY(m_harness.window.view().orders().findChildren<robot::Attempt *>().isEmpty());
            QVERIFY2(
                QSet<QString>(m_sent.begin(), m_sent.end()).size() == m_sent.size(), qPrintable(m_sent.join(u", ")));
        }
    }

    /// The smallest screen it is made for.
    void fitsASmallWindow_data() { rows(); }
    void fitsASmallWindow()
    {
        const QSize before = m_harness.window.size();
        m_harness.window.resize(1024, 768);
        QVERIFY(open());
        const auto *frame = m_harness.window.findChild<QWidget *>(QStringLiteral("sheetFrame"));
        QVERIFY(frame && layer()->rect().contains(frame->geometry()));
        m_harness.window.resize(before);
    }

private:
    [[nodiscard]] widgets::SheetLayer *layer() { return widgets::SheetLayer::of(&m_harness.window); }
    static void rows()
    {
        QTest::addColumn<int>("row");
        for (int row = 0; row < int(allDialogs().size()); ++row)
            QTest::newRow(allDialogs()[row].name) << row;
    }
    [[nodiscard]] bool open()
    {
        QFETCH(int, row);
        const auto create = [&] { return (m_dialog = allDialogs()[row].create(m_harness)) != nullptr; };
        if (!QTest::qWaitFor(create)) // a move wants a position first
            return false;
        m_dialog->show();
        return m_dialog && m_dialog->isVisible();
    }

    Harness m_harness;
    QPointer<QDialog> m_dialog;
    QStringList m_sent; ///< Orders that left.
};

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TestSheets test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_sheets.moc"
