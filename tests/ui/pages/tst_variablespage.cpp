// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/variablespage.h"

#include "ui/room.h"
#include "ui/widgets/celleditor.h"
#include <QClipboard>
#include <QComboBox>
#include <QSpinBox>
#include <QTabBar>

using robot::LinkState;
using variables::EditState;
using variables::Reference;
using VariableKind = variables::Kind;
using models::VariableModel;

namespace {

/// The window on its variables page.
struct Sheet : Room {
    explicit Sheet(const char *pageId = "variables") : Room {pageId} { }

    [[nodiscard]] bool isLive() const override { return text(3) != u"—"; }
    [[nodiscard]] widgets::Table *table() const { return find<widgets::Table>("variableTable"); }
    [[nodiscard]] QTabBar *tabs() const { return find<QTabBar>("tabs"); }
    [[nodiscard]] QString text(int row, int column = VariableModel::Value) const
    {
        return table()->model()->index(row, column).data().toString();
    }
    /// Every row in view is live, or was refused.
    [[nodiscard]] bool isSettled() const
    {
        return std::ranges::all_of(page->topics(), [this](const robot::TopicRange &range) {
            const auto freshness = harness.state().freshness({range.kind, range.first});
            return freshness == robot::Freshness::Live || freshness == robot::Freshness::Refused;
        });
    }
    void select(int row) const
    {
        table()->setFocus();
        table()->setCurrentIndex(table()->model()->index(row, VariableModel::Value));
    }
    /// Types a value into a row, and Enter.
    void type(int row, const QString &words) const
    {
        select(row);
        QTest::keyClick(table(), Qt::Key_Return);
        const auto editors = table()->findChildren<QLineEdit *>(QStringLiteral("cellEditor"));
        if (editors.isEmpty())
            return;
        QLineEdit *editor = editors.last(); // the one before may not be gone yet
        editor->selectAll();
        QTest::keyClicks(editor, words);
        QTest::keyClick(editor, Qt::Key_Return);
        QCoreApplication::processEvents(); // the view takes it from the event loop
    }
    [[nodiscard]] bool apply() const
    {
        click("write-variable");
        QDialog *box = dialog("applyDialog");
        if (!box)
            return false;
        QTest::mouseClick(box->findChild<QPushButton *>(QStringLiteral("applyConfirm")), Qt::LeftButton);
        return true;
    }
};

} // namespace

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
    void theNumberingTest();
    void goesTo();
    void pastes();
    void positionsAreEdited();
    void watchPagesAreKept();
    void registers();
    void pictures();
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

void TestVariablesPage::theNumberingTest()
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

void TestVariablesPage::pastes()
{
    Sheet room;
    QVERIFY(room.open());
    room.select(10);
    QGuiApplication::clipboard()->setText(QStringLiteral("1\n300\n"));
    QTest::keyClick(room.table(), Qt::Key_V, Qt::ControlModifier);
    QDialog *dialog = room.dialog("importDialog");
    QVERIFY(dialog);
    QVERIFY(!dialog->findChild<QPushButton *>(QStringLiteral("stageButton"))->isEnabled());
    QVERIFY(dialog->findChild<QLabel *>(QStringLiteral("problemSentence")));
    dialog->reject();
    QTRY_VERIFY(!room.dialog("importDialog"));
    QGuiApplication::clipboard()->setText(QStringLiteral("I005\t-7\nR001\t1,5\n"));
    QTest::keyClick(room.table(), Qt::Key_V, Qt::ControlModifier);
    dialog = room.dialog("importDialog");
    QVERIFY(dialog);
    QTest::mouseClick(dialog->findChild<QPushButton *>(QStringLiteral("stageButton")), Qt::LeftButton);
    room.tabs()->setCurrentIndex(1);
    QTRY_VERIFY(room.text(5).endsWith(QStringLiteral("→ -7")));
    QVERIFY(room.apply());
    QTRY_COMPARE(room.memory().r[1].value, 1.5F);
    QCOMPARE(room.memory().i[5].value, -7);
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
    room.picture(QStringLiteral("variables-position"));
    QVERIFY(dialog->grab().save(QStringLiteral(PENDESK_PICTURES "/variables-position-dialog.png")));
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
    const auto notes = room.harness.store.notes(room.harness.profile().name);
    const QByteArray kept = QJsonDocument {notes.read(QStringLiteral("watchPages"))}.toJson(QJsonDocument::Compact);
    QVERIFY(kept.contains("\"B007\",\"P001\""));
    QVERIFY(room.open(room.harness.profile()));
    QCOMPARE(room.tabs()->count(), 10);
}

void TestVariablesPage::registers()
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
    room.picture(QStringLiteral("registers-hex"));
}

void TestVariablesPage::pictures()
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

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TestVariablesPage test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_variablespage.moc"
