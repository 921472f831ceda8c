// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/variabletransfer.h"

#include "ui/pages/registerspage.h"
#include "ui/pages/sheet.h"
#include <QClipboard>

using VariableKind = variables::Kind;

/// Values in and out of the variables page: clipboard and CSV.
class TestVariableTransfer : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { QLocale::setDefault(QLocale::c()); }
    void pastes();
    void exportsAndImportsFiles();
    void aFileFullOfMistakes();
};

void TestVariableTransfer::pastes()
{
    Sheet room;
    QVERIFY(room.open());
    room.select(10);
    QGuiApplication::clipboard()->setText(QStringLiteral("1\n300\n"));
    QTest::keyClick(room.table(), Qt::Key_V, Qt::ControlModifier);
    QTRY_VERIFY(room.dialog("importDialog"));
    QDialog *dialog = room.dialog("importDialog");
    QVERIFY(!dialog->findChild<QPushButton *>(QStringLiteral("stageButton"))->isEnabled());
    QVERIFY(dialog->findChild<QLabel *>(QStringLiteral("problemSentence")));
    dialog->reject();
    QTRY_VERIFY(!room.dialog("importDialog"));
    room.memory().i[5].value = 41;
    QGuiApplication::clipboard()->setText(QStringLiteral("I005\t-7\nR001\t1,5\n"));
    QTest::keyClick(room.table(), Qt::Key_V, Qt::ControlModifier);
    QTRY_VERIFY(room.dialog("importDialog"));
    dialog = room.dialog("importDialog");
    // Neither stood in view: they were read for the preview.
    const auto *differences = dialog->findChild<widgets::Table *>(QStringLiteral("differenceTable"))->model();
    QCOMPARE(differences->index(0, 2).data().toString(), QStringLiteral("41"));
    QTest::mouseClick(dialog->findChild<QPushButton *>(QStringLiteral("stageButton")), Qt::LeftButton);
    room.tabs()->setCurrentIndex(1);
    QTRY_VERIFY(room.text(5).endsWith(QStringLiteral("→ -7")));
    QVERIFY(room.apply());
    QTRY_COMPARE(room.memory().r[1].value, 1.5F);
    QCOMPARE(room.memory().i[5].value, -7);
}

/// The rows out of view too, and back again.
void TestVariableTransfer::exportsAndImportsFiles()
{
    Sheet room;
    QVERIFY(room.open());
    for (int number = 0; number < 100; ++number)
        room.memory().b[std::size_t(number)].value = quint8(number + 100);
    auto *transfer = room.page->findChild<pages::VariableTransfer *>();
    const auto *sentence = room.find<QLabel>("sentence");
    const QString path = room.harness.folder.filePath(QStringLiteral("b.csv"));
    room.tabs()->setCurrentIndex(1); // nothing that is exported stands in view
    transfer->exportTo(path, pages::allOf(VariableKind::B, room.harness.profile().dialect()));
    QTRY_VERIFY(sentence->text().endsWith(QStringLiteral("was written.")));
    QFile file {path};
    QVERIFY(file.open(QIODevice::ReadOnly));
    const auto lines = file.readAll().split('\n');
    QCOMPARE(lines.size(), 102); // header and the end of the last line
    QCOMPARE(lines[100], QByteArray("B099,,199\r"));
    room.memory().b[50].value = 7;
    QTRY_VERIFY(room.harness.state().freshness({robot::Kind::ByteVariable, 50}) == robot::Freshness::Stale);
    transfer->importFrom(path);
    QTRY_VERIFY(room.dialog("importDialog"));
    const auto *table = room.dialog("importDialog")->findChild<widgets::Table *>(QStringLiteral("differenceTable"));
    QCOMPARE(table->model()->rowCount(), 1);
    QCOMPARE(table->model()->index(0, 2).data().toString(), QStringLiteral("7"));
    QCOMPARE(table->model()->index(0, 3).data().toString(), QStringLiteral("150"));
    room.dialog("importDialog")->reject();
    transfer->importFrom(room.harness.folder.filePath(QStringLiteral("none.csv")));
    QTRY_VERIFY(sentence->text().contains(QStringLiteral("cannot be read")));
}

/// Ten thousand lines open as fast as they are told of, and nothing of them can be staged.
void TestVariableTransfer::aFileFullOfMistakes()
{
    Sheet room;
    QVERIFY(room.open());
    QFile file {room.harness.folder.filePath(QStringLiteral("many.csv"))};
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("variable,value\n");
    for (int number = 0; number < 10'000; ++number)
        file.write("D" + QByteArray::number(number) + ",5\n");
    file.close();
    room.page->findChild<pages::VariableTransfer *>()->importFrom(file.fileName());
    QTRY_VERIFY(room.dialog("importDialog"));
    QDialog *dialog = room.dialog("importDialog");
    QCOMPARE(dialog->findChild<widgets::Table *>(QStringLiteral("problemTable"))->model()->rowCount(), 9'900);
    QVERIFY(!dialog->findChild<QPushButton *>(QStringLiteral("stageButton"))->isEnabled());
    dialog->reject();
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TestVariableTransfer test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_variabletransfer.moc"
