// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/alldialogs.h"
#include "ui/harness.h"

#include "ui/pagecatalog.h"
#include "ui/pages/page.h"
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAccessible>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLineEdit>
#include <QMetaEnum>
#include <QTabBar>
#include <QTextEdit>

namespace {

bool isInteractive(QAccessible::Role role)
{
    switch (role) {
    case QAccessible::PushButton:
    case QAccessible::ButtonMenu:
    case QAccessible::CheckBox:
    case QAccessible::RadioButton:
    case QAccessible::ComboBox:
    case QAccessible::EditableText:
    case QAccessible::SpinBox:
    case QAccessible::Slider:
    case QAccessible::Table:
    case QAccessible::List:
    case QAccessible::Tree: return true;
    default: return false;
    }
}

QString roleWord(QAccessible::Role role)
{
    return QLatin1String(QMetaEnum::fromType<QAccessible::Role>().valueToKey(role));
}

/// What a screen reader meets, in lines of role, name and value.
class Reader
{
public:
    void read(QAccessibleInterface *node, int depth = 0)
    {
        if (!node || !node->isValid() || node->state().invisible)
            return;
        const QString name = node->text(QAccessible::Name);
        const QString value = node->text(QAccessible::Value);
        if (!name.isEmpty() || !value.isEmpty())
            lines << QStringLiteral("%1%2: %3 = %4").arg(QString(2 * depth, u' '), roleWord(node->role()), name, value);
        if (isInteractive(node->role()) && name.isEmpty() && node->text(QAccessible::Description).isEmpty())
            nameless << describe(node);
        constexpr int cellsEnough = 60; // a table's first cells tell how all of them read
        for (int i = 0; i < std::min(node->childCount(), cellsEnough); ++i)
            read(node->child(i), depth + 1);
    }

    QStringList lines;
    QStringList nameless;

private:
    static QString describe(QAccessibleInterface *node)
    {
        const QObject *object = node->object();
        const QObject *parent = object ? object->parent() : nullptr;
        return QStringLiteral("%1 %2 in %3")
            .arg(roleWord(node->role()), object ? object->objectName() : QString(),
                parent ? parent->objectName() : QString());
    }
};

/// Widgets that take the focus by themselves; parts of Qt's own compound widgets belong to those.
QStringList withoutObjectName(const QWidget &page)
{
    QStringList result;
    for (const QWidget *widget : page.findChildren<QWidget *>()) {
        const bool isPart = widget->window() != page.window() // the list of a combo box
            || qobject_cast<QComboBox *>(widget->parentWidget())
            || qobject_cast<QAbstractSpinBox *>(widget->parentWidget())
            || qobject_cast<QAbstractItemView *>(widget->parentWidget())
            || qobject_cast<QLineEdit *>(widget->parentWidget())
            || widget->parentWidget()->inherits("QComboBoxPrivateContainer")
            || qobject_cast<QTabBar *>(widget->parentWidget());
        const bool isControl = qobject_cast<const QAbstractButton *>(widget)
            || qobject_cast<const QAbstractItemView *>(widget) || qobject_cast<const QLineEdit *>(widget)
            || qobject_cast<const QComboBox *>(widget) || qobject_cast<const QAbstractSpinBox *>(widget)
            || qobject_cast<const QTextEdit *>(widget);
        if (isControl && !isPart && widget->objectName().isEmpty())
            result << QLatin1String(widget->metaObject()->className());
    }
    return result;
}

} // namespace

/// Every page as a screen reader meets it. The whole reading is written beside the pictures, to be read by a person.
class TestAccessibility : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_harness.connectLive());
        m_harness.access().enter(robot::Level::Engineer);
        QVERIFY(QDir().mkpath(QStringLiteral(PENDESK_PICTURES)));
    }

    void everyPageReadsAloud_data()
    {
        QTest::addColumn<int>("row");
        for (int row = 0; row < int(ui::pageCatalog().size()); ++row)
            QTest::newRow(ui::pageCatalog()[row].id) << row;
    }
    void everyPageReadsAloud()
    {
        QFETCH(int, row);
        m_harness.window.view().openPage(row);
        pages::Page *page = m_harness.window.view().page(row);
        QTRY_VERIFY(page->isVisible());
        Reader reader;
        reader.read(QAccessible::queryAccessibleInterface(page));
        QVERIFY(!reader.lines.isEmpty());
        QFile file(QStringLiteral("%1/%2-aloud.txt").arg(QStringLiteral(PENDESK_PICTURES), page->objectName()));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(reader.lines.join(u'\n').toUtf8());
        QCOMPARE((reader.nameless + withoutObjectName(*page)).join(u", "), QString());
    }

    void everyDialogReadsAloud_data()
    {
        QTest::addColumn<int>("row");
        for (int row = 0; row < int(allDialogs().size()); ++row)
            QTest::newRow(allDialogs()[row].name) << row;
    }
    void everyDialogReadsAloud()
    {
        QFETCH(int, row);
        std::unique_ptr<QDialog> dialog;
        QTRY_VERIFY((dialog.reset(allDialogs()[row].create(m_harness)), dialog)); // a move wants a position first
        dialog->setAttribute(Qt::WA_DeleteOnClose, false);
        dialog->show();
        Reader reader;
        reader.read(QAccessible::queryAccessibleInterface(dialog.get()));
        QVERIFY(!dialog->windowTitle().isEmpty());
        QVERIFY(!dialog->objectName().isEmpty());
        QCOMPARE((reader.nameless + withoutObjectName(*dialog)).join(u", "), QString());
    }

    void stripAndRailReadAloud()
    {
        Reader reader;
        reader.read(QAccessible::queryAccessibleInterface(&m_harness.window));
        QVERIFY(!reader.lines.isEmpty());
        QCOMPARE(reader.nameless.join(u", "), QString());
    }

private:
    Harness m_harness;
};

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    QAccessible::setActive(true);
    TestAccessibility test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_accessibility.moc"
