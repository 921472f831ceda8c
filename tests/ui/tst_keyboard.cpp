// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/alldialogs.h"
#include "ui/fit.h"
#include "ui/harness.h"

#include "ui/pagecatalog.h"
#include "ui/widgets/dialogsheet.h"
#include "ui/widgets/startbutton.h"
#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QButtonGroup>
#include <QComboBox>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QTabBar>

namespace {

constexpr int mostSteps = 400; ///< A window with more controls than that would be a trap of another kind.

/// What Tab should lead to: visible, enabled, and not a part of another control. Of radio buttons and exclusive
/// buttons one is enough: arrow keys lead to the others.
QList<QWidget *> controls(const QWidget &root)
{
    QList<QWidget *> result;
    for (const QWidget *seen : fit::visibleWidgets(root)) {
        auto *widget = const_cast<QWidget *>(seen);
        const auto *button = qobject_cast<QAbstractButton *>(widget);
        const bool isOther = button && button->autoExclusive() && !button->isChecked();
        const bool isChoice = button && button->group() && button->group()->exclusive() && !button->isChecked();
        if ((widget->focusPolicy() & Qt::TabFocus) && widget->isEnabled() && !widget->focusProxy() && !isOther
            && !isChoice)
            result << widget;
    }
    return result;
}

QWidget *focused() { return QApplication::focusWidget(); }

/// Every control that the key leads to until it comes back to the first.
QList<QWidget *> walk(Qt::Key key)
{
    QList<QWidget *> result;
    while (result.size() < mostSteps && focused() && !result.contains(focused())) {
        result << focused();
        QTest::keyClick(QApplication::focusWidget(), key, key == Qt::Key_Backtab ? Qt::ShiftModifier : Qt::NoModifier);
    }
    return result;
}

/// What Tab does not lead to, or Shift+Tab.
QStringList unreachable(const QWidget &root)
{
    QStringList result;
    for (const Qt::Key key : {Qt::Key_Tab, Qt::Key_Backtab}) {
        const QList<QWidget *> walked = walk(key);
        for (const QWidget *control : controls(root)) {
            if (!walked.contains(control))
                result << (key == Qt::Key_Tab ? QStringLiteral("Tab: ") : QStringLiteral("Shift+Tab: "))
                        + fit::nameOf(*control);
        }
        if (focused() && !walked.isEmpty() && focused() != walked.first())
            result << QStringLiteral("a trap: %1 instead of %2")
                          .arg(fit::nameOf(*focused()), fit::nameOf(*walked.first()));
    }
    return result;
}

bool isInView(const QWidget &widget)
{
    const QRect place(widget.mapTo(widget.window(), QPoint()), widget.size());
    for (const QWidget *parent = widget.parentWidget(); parent; parent = parent->parentWidget()) {
        const QRect room(parent->mapTo(widget.window(), QPoint()), parent->size());
        const bool isSmaller = place.width() <= room.width() && place.height() <= room.height();
        if (isSmaller ? !room.contains(place) : !room.intersects(place))
            return false;
        if (parent->isWindow())
            break;
    }
    return true;
}

/// Controls that are out of view while they have the focus, or look the same with and without it.
QStringList unseen(const QWidget &root)
{
    QStringList result;
    for (QWidget *control : controls(root)) {
        if (!control->isEnabled() || !control->isVisible())
            continue; // by what the focus did
        if (QWidget *before = QApplication::focusWidget())
            before->clearFocus();
        QCoreApplication::sendPostedEvents();
        const QImage without = control->grab().toImage();
        control->setFocus(Qt::TabFocusReason);
        QCoreApplication::sendPostedEvents();
        const QImage with = control->grab().toImage();
        if (!control->visibleRegion().isEmpty() && with == without)
            result << QStringLiteral("focus cannot be seen: ") + fit::nameOf(*control);
    }
    return result;
}

bool isNothing(const QStringList &findings)
{
    for (const QString &finding : findings)
        qWarning().noquote() << finding;
    return findings.isEmpty();
}

} // namespace

/// Whoever has no mouse comes everywhere, sees where he is, and gets out again.
class TestKeyboard : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void pages_data();
    void pages();
    void dialogs_data();
    void dialogs();

private:
    [[nodiscard]] bool activate(QWidget &window)
    {
        window.window()->activateWindow();
        return QTest::qWaitFor([&] { return QApplication::activeWindow() == window.window(); });
    }

    Harness m_harness;
};

void TestKeyboard::initTestCase()
{
    QVERIFY(m_harness.connectLive());
    m_harness.access().enter(robot::Level::Engineer);
    QVERIFY(activate(m_harness.window));
}

void TestKeyboard::pages_data()
{
    QTest::addColumn<int>("row");
    for (int row = 0; row < int(ui::pageCatalog().size()); ++row)
        QTest::newRow(ui::pageCatalog()[row].id) << row;
}

void TestKeyboard::pages()
{
    QFETCH(int, row);
    const ui::PageRow &page = ui::pageCatalog()[row];
    QVERIFY(activate(m_harness.window));
    const QKeyCombination keys = QKeySequence(QLatin1String(page.shortcut))[0];
    QTest::keyClick(&m_harness.window, keys.key(), keys.keyboardModifiers());
    QTRY_VERIFY(m_harness.window.view().page(row)->isVisible());
    auto *entry = m_harness.window.findChild<QWidget *>(QLatin1String(page.id) + QStringLiteral("Entry"));
    entry->setFocus(Qt::TabFocusReason);
    QVERIFY(isNothing(unreachable(m_harness.window)));
    QStringList outside;
    entry->setFocus(Qt::TabFocusReason);
    for (int step = 0; step < int(controls(m_harness.window).size()); ++step) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        if (!isInView(*QApplication::focusWidget()))
            outside << QStringLiteral("out of view: ") + fit::nameOf(*QApplication::focusWidget());
    }
    QVERIFY(isNothing(outside + unseen(m_harness.window)));
}

void TestKeyboard::dialogs_data()
{
    QTest::addColumn<int>("row");
    for (int row = 0; row < int(allDialogs().size()); ++row)
        QTest::newRow(allDialogs()[row].name) << row;
}

void TestKeyboard::dialogs()
{
    QFETCH(int, row);
    m_harness.window.view().openPage(6);
    QPointer<QDialog> dialog;
    QTRY_VERIFY((dialog = allDialogs()[row].create(m_harness)));
    dialog->show();
    QVERIFY(activate(*dialog));
    QStringList findings;
    const auto *first = QApplication::focusWidget();
    if (!first || !dialog->isAncestorOf(first))
        findings << QStringLiteral("nothing has the focus at first");
    for (const QPushButton *button : dialog->findChildren<QPushButton *>()) {
        const bool isDangerous =
            widgets::isWriting(button) || qobject_cast<const widgets::StartButton *>(button) != nullptr;
        if (isDangerous && (button->isDefault() || button->autoDefault() || button->hasFocus()))
            findings << QStringLiteral("Enter would press ") + fit::nameOf(*button);
    }
    findings << unreachable(*dialog) << unseen(*dialog);
    QVERIFY(isNothing(findings));
    QTest::keyClick(dialog.data(), Qt::Key_Escape);
    QTRY_VERIFY(!dialog || !dialog->isVisible());
    delete dialog;
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TestKeyboard test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_keyboard.moc"
