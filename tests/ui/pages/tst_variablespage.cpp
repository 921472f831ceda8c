// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/variablespage.h"

#include "ui/pages/sheet.h"
#include <QComboBox>
#include <QSpinBox>

using robot::LinkState;
using VariableKind = variables::Kind;
using models::VariableModel;

class TestVariablesPage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { QLocale::setDefault(QLocale::c()); }
    void onlyRowsInViewAreRead();
    void editsAreStagedAppliedAndUndone();
    void typingSurvivesThePoll();
    void typingSurvivesAnotherWindow();
    void enterEndsARemark();
    void badTextIsNotTaken();
    void unverifiedNumberingWritesNothing();
    void goesTo();
    void positionsAreEdited();
    void stagedRowsAreReadOutOfView();
    void editsWhileTheLinkIsLost();
    void watchPagesAreKept();
};

void TestVariablesPage::onlyRowsInViewAreRead()
{
    Sheet room;
    QVERIFY(room.open());
    const auto topics = room.page->topics();
    QVERIFY(topics.size() > 5 && topics.size() < 60);
    QVERIFY(topics.first().kind == robot::Kind::ByteVariable);
    room.select(99);
    QVERIFY(room.page->topics().last().last == 99);
    QVERIFY(room.page->topics().first().first > 0);
    room.tabs()->setCurrentIndex(2);
    QVERIFY(room.page->topics().first().kind == robot::Kind::DoubleVariable);
    QTRY_VERIFY(room.text(0) != u"—");
    QCOMPARE(room.harness.server->arrived(0x7C), 0); // plural, not one by one
    QVERIFY(room.harness.server->arrived(0x304) > 0);
}

void TestVariablesPage::editsAreStagedAppliedAndUndone()
{
    Sheet room;
    QVERIFY(room.open());
    room.memory().b[2].value = 2;
    QTRY_COMPARE(room.text(2), QStringLiteral("2"));
    QVERIFY(!room.find<QPushButton>("write-variable")->isEnabled());
    room.type(2, QStringLiteral("5"));
    QCOMPARE(room.text(2), QStringLiteral("2 → 5"));
    QCOMPARE(room.memory().b[2].value, 2); // staged, not sent
    QVERIFY(room.find<QPushButton>("write-variable")->text().contains(u'1'));
    QVERIFY(room.apply());
    QTRY_COMPARE(room.memory().b[2].value, 5);
    QTRY_COMPARE(room.text(2), QStringLiteral("5"));
    room.click("undoButton");
    QTRY_COMPARE(room.text(2), QStringLiteral("5 → 2"));
    QVERIFY(room.apply());
    QTRY_COMPARE(room.memory().b[2].value, 2);
    room.type(3, QStringLiteral("9"));
    QVERIFY(room.text(3).endsWith(QStringLiteral("→ 9")));
    QTRY_VERIFY(room.find<QPushButton>("discardButton")->isEnabled()); // the undone value is read back
    room.click("discardButton");
    QTRY_VERIFY(!room.text(3).contains(u'→'));
}

void TestVariablesPage::typingSurvivesThePoll()
{
    Sheet room;
    QVERIFY(room.open());
    room.select(5);
    QTest::keyClick(room.table(), Qt::Key_Return);
    auto *editor = room.table()->findChild<QLineEdit *>(QStringLiteral("cellEditor"));
    QVERIFY(editor && editor->hasFocus());
    // Ten times a second another value, read over the network.
    QTimer poll;
    connect(&poll, &QTimer::timeout, this, [&room] {
        ++room.memory().b[5].value;
        room.harness.window.controller().poller().readNow({robot::Kind::ByteVariable, 5});
    });
    poll.start(std::chrono::milliseconds {100});
    const auto *live = room.table()->findChild<QLabel *>(QStringLiteral("liveLabel"));
    const auto isChanged = [live] {
        const QString before = live->text();
        return QTest::qWaitFor([&] { return live->text() != before; });
    };
    editor->selectAll();
    const QString typed = QStringLiteral("123");
    for (int i = 0; i < typed.size(); ++i) {
        QTest::keyClick(editor, typed[i].toLatin1());
        QVERIFY(isChanged());
        QCOMPARE(editor->text(), typed.first(i + 1));
        QCOMPARE(editor->cursorPosition(), i + 1);
    }
    QTest::keyClick(editor, Qt::Key_Left);
    QTest::keyClick(editor, Qt::Key_Left, Qt::ShiftModifier);
    for (int i = 0; i < 10; ++i) {
        QVERIFY(isChanged());
        QCOMPARE(editor->text(), typed);
        QCOMPARE(editor->selectedText(), QStringLiteral("2"));
        QCOMPARE(editor->cursorPosition(), 1);
        QVERIFY(editor->hasFocus());
    }
    poll.stop();
    room.memory().b[5].value = 77;
    QTRY_COMPARE(live->text(), QStringLiteral("live: 77"));
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(room.text(5), QStringLiteral("77 → 123"));
}

/// Another window in front, and back: what was typed is still being typed.
void TestVariablesPage::typingSurvivesAnotherWindow()
{
    Sheet room;
    QVERIFY(room.open());
    room.select(5);
    QTest::keyClick(room.table(), Qt::Key_Return);
    const QPointer editor = room.table()->findChild<QLineEdit *>(QStringLiteral("cellEditor"));
    QVERIFY(editor && editor->hasFocus());
    editor->selectAll();
    QTest::keyClicks(editor, QStringLiteral("12"));
    QWidget other;
    other.show();
    other.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&other));
    QVERIFY(!room.text(5).contains(u'→'));
    other.close();
    room.harness.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&room.harness.window));
    QTRY_VERIFY(editor && editor->hasFocus());
    QTest::keyClicks(editor, QStringLiteral("3"));
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_VERIFY(room.text(5).endsWith(QStringLiteral("→ 123")));
}

/// Enter in a remark belongs to the remark, not to the value beside it.
void TestVariablesPage::enterEndsARemark()
{
    Sheet room;
    QVERIFY(room.open());
    room.tabs()->setCurrentIndex(5);
    const QModelIndex note = room.table()->model()->index(1, VariableModel::Note);
    room.table()->setFocus();
    room.table()->setCurrentIndex(note);
    QTest::keyClick(room.table(), Qt::Key_F2);
    auto *editor = room.table()->findChild<QLineEdit *>(QStringLiteral("textEditor"));
    QVERIFY(editor && editor->hasFocus());
    QTest::keyClicks(editor, QStringLiteral("above the jig"));
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(note.data().toString(), QStringLiteral("above the jig"));
    QVERIFY(!room.dialog("positionDialog"));
}

void TestVariablesPage::badTextIsNotTaken()
{
    Sheet room;
    QVERIFY(room.open());
    room.type(1, QStringLiteral("256"));
    auto *editor = room.table()->findChild<QLineEdit *>(QStringLiteral("cellEditor"));
    QVERIFY(editor && editor->isVisible()); // Enter is not taken
    const auto *hint = room.table()->findChild<QLabel *>(QStringLiteral("hintLabel"));
    QVERIFY2(hint->text().contains(QStringLiteral("from 0 to 255")), qPrintable(hint->text()));
    QTest::keyClick(editor, Qt::Key_Escape);
    QVERIFY(!room.text(1).contains(u'→'));
    // Left for another control: nothing is staged, and it is said.
    room.type(1, QStringLiteral("nan"));
    room.find<QLineEdit>("goTo")->setFocus();
    const auto *sentence = room.find<QLabel>("sentence");
    QTRY_VERIFY2(
        sentence->text().startsWith(QStringLiteral("B001 stays as it is: “nan”")), qPrintable(sentence->text()));
    QVERIFY(!room.text(1).contains(u'→'));
}

void TestVariablesPage::unverifiedNumberingWritesNothing()
{
    Sheet room;
    QVERIFY(room.open(false));
    QVERIFY(room.find<QLabel>("note")->text().contains(QStringLiteral("not verified")));
    room.type(2, QStringLiteral("5"));
    QVERIFY(room.text(2).endsWith(QStringLiteral("→ 5")));
    const auto *apply = room.find<QPushButton>("write-variable");
    QVERIFY(!apply->isEnabled());
    QVERIFY(!room.find<QLabel>("reason-write-variable")->text().isEmpty());
    QTest::mouseClick(const_cast<QPushButton *>(apply), Qt::LeftButton);
    QVERIFY(!room.dialog("applyDialog"));
    QCOMPARE(room.harness.server->arrived(0x7A), 0);
}

void TestVariablesPage::goesTo()
{
    Sheet room;
    QVERIFY(room.open());
    auto *goTo = room.find<QLineEdit>("goTo");
    QTest::keyClick(room.table(), Qt::Key_G, Qt::ControlModifier);
    QVERIFY(goTo->hasFocus());
    const auto go = [&](const char *words) {
        goTo->setText(QLatin1String(words));
        QTest::keyClick(goTo, Qt::Key_Return);
        const QModelIndex current = room.table()->currentIndex();
        return current.data(VariableModel::ReferenceRole).toString();
    };
    QCOMPARE(go("P012"), QStringLiteral("P012"));
    QCOMPARE(go("b 7"), QStringLiteral("B007"));
    QCOMPARE(go("ex127"), QStringLiteral("EX127"));
    QTRY_COMPARE(go("home base"), QStringLiteral("P001")); // VARNAME.DAT of the demo
    QCOMPARE(go("B100"), QStringLiteral("P001"));
    QVERIFY(room.find<QLabel>("sentence")->text().contains(QStringLiteral("B000 to B099")));
}

void TestVariablesPage::positionsAreEdited()
{
    Sheet room;
    QVERIFY(room.open());
    room.tabs()->setCurrentIndex(5);
    room.select(20);
    QTest::keyClick(room.table(), Qt::Key_Return);
    QDialog *dialog = room.dialog("positionDialog");
    QVERIFY(dialog);
    const auto field = [&](const char *name) { return dialog->findChild<QLineEdit *>(QLatin1String(name)); };
    auto *stage = dialog->findChild<QPushButton *>(QStringLiteral("stageButton"));
    dialog->findChild<QComboBox *>(QStringLiteral("type"))->setCurrentIndex(1); // base frame
    field("axis1")->setText(QStringLiteral("812,5"));
    field("axis2")->setText(QStringLiteral("here"));
    QVERIFY(!stage->isEnabled());
    field("axis2")->setText(QStringLiteral("-12.001"));
    QVERIFY(stage->isEnabled());
    dialog->findChild<QSpinBox *>(QStringLiteral("tool"))->setValue(3);
    dialog->findChild<QComboBox *>(QStringLiteral("form2"))->setCurrentIndex(1); // no flip
    QTest::mouseClick(stage, Qt::LeftButton);
    QVERIFY(room.text(20).contains(QStringLiteral("812.500")));
    QVERIFY(room.apply());
    QTRY_VERIFY(room.memory().p[20].has_value());
    const auto &position = room.memory().p[20]->position;
    QCOMPARE(position.axes[0], 812500);
    QCOMPARE(position.axes[1], -12001);
    QCOMPARE(position.tool, 3U);
    QCOMPARE(position.form, 4U);
    // The present position, with its own type.
    room.select(21);
    QTest::keyClick(room.table(), Qt::Key_Return);
    dialog = room.dialog("positionDialog");
    QVERIFY(dialog);
    QTest::mouseClick(dialog->findChild<QPushButton *>(QStringLiteral("takeBase")), Qt::LeftButton);
    QTRY_VERIFY2(dialog->findChild<QComboBox *>(QStringLiteral("type"))->currentData().toUInt() == 16,
        qPrintable(dialog->findChild<QLabel *>(QStringLiteral("sentence"))->text()));
    QTRY_VERIFY(field("axis1")->text() != u"0");
    dialog->reject();
}

/// What is staged is read wherever it stands, so that old and new are true when it is applied.
void TestVariablesPage::stagedRowsAreReadOutOfView()
{
    Sheet room;
    QVERIFY(room.open());
    room.type(2, QStringLiteral("5"));
    room.tabs()->setCurrentIndex(2);
    room.memory().b[2].value = 3;
    QTRY_VERIFY(
        readingOf(room.harness.state(), {VariableKind::B, 2}).value == variables::Value {values::ByteVariable {3}});
    room.click("write-variable");
    const auto *table = room.dialog("applyDialog")->findChild<widgets::Table *>(QStringLiteral("applyTable"));
    QCOMPARE(table->model()->index(0, 1).data().toString(), QStringLiteral("3"));
}

/// While the link is lost values can be staged; they are kept, and nothing is sent before a person applies.
void TestVariablesPage::editsWhileTheLinkIsLost()
{
    Sheet room;
    QVERIFY(room.open());
    room.harness.stopController();
    QTRY_VERIFY(room.harness.window.controller().linkState() == LinkState::Lost);
    room.type(2, QStringLiteral("5"));
    QVERIFY(room.text(2).endsWith(QStringLiteral("→ 5")));
    QVERIFY(!room.find<QPushButton>("write-variable")->isEnabled());
    QVERIFY(room.harness.startController());
    QTRY_VERIFY(room.harness.window.controller().linkState() == LinkState::Monitoring);
    QVERIFY(room.text(2).endsWith(QStringLiteral("→ 5")));
    QCOMPARE(room.harness.server->arrived(0x7A), 0);
    QTRY_VERIFY(room.find<QPushButton>("write-variable")->isEnabled());
    QVERIFY(room.apply());
    QTRY_COMPARE(room.memory().b[2].value, 5);
}

void TestVariablesPage::watchPagesAreKept()
{
    Sheet room;
    QVERIFY(room.open());
    auto *page = qobject_cast<pages::VariablesPage *>(room.page);
    page->addWatchPage(QStringLiteral("shift start"));
    QCOMPARE(room.tabs()->tabText(room.tabs()->count() - 1), QStringLiteral("Watch: shift start"));
    QCOMPARE(room.table()->model()->rowCount(), 0);
    auto *model = qobject_cast<VariableModel *>(room.table()->model());
    model->append({VariableKind::B, 7});
    model->append({VariableKind::P, 1});
    QTRY_VERIFY(room.text(0) != u"—" && room.text(1) != u"—");
    page->addWatchPage(QStringLiteral("second"));
    const auto notes = room.harness.window.view().station()->notes();
    const QByteArray kept = QJsonDocument {notes.read(QStringLiteral("watchPages"))}.toJson(QJsonDocument::Compact);
    QVERIFY(kept.contains("\"B007\",\"P001\""));
    QVERIFY(room.open(room.harness.profile()));
    QCOMPARE(room.tabs()->count(), 10);
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TestVariablesPage test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_variablespage.moc"
