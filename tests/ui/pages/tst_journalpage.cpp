// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/harness.h"

#include "ui/models/ordermodel.h"
#include "ui/pagecatalog.h"
#include "ui/widgets/table.h"
#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

using models::OrderModel;
using robot::Act;
using robot::Level;

namespace {

int journalRow()
{
    const auto rows = ui::pageCatalog();
    return int(std::ranges::find(rows, QLatin1String("journal"), [](const auto &row) { return QLatin1String(row.id); })
        - rows.begin());
}

struct Desk : Harness {
    [[nodiscard]] bool live(Level level)
    {
        if (!connectLive())
            return false;
        access().enter(level);
        window.view().openPage(journalRow());
        return true;
    }
    template <typename Widget> [[nodiscard]] Widget *find(const char *name) const
    {
        return window.view().findChild<Widget *>(QLatin1String(name));
    }
    [[nodiscard]] QAbstractItemModel *rows() const { return find<widgets::Table>("journalTable")->model(); }
    [[nodiscard]] QString cell(int row, int column) const { return rows()->index(row, column).data().toString(); }
    [[nodiscard]] QString words(const char *label) const { return find<QLabel>(label)->text(); }
    void cycle(values::CycleMode mode, const char *newValue)
    {
        window.view().orders().send(protocol::SelectCycle {mode},
            {Act::SelectCycle, {}, QStringLiteral("continuous"), QString::fromLatin1(newValue)}, &window, {});
    }
};

journal::OrderRecord record(const QString &controller, int daysAgo, journal::Outcome outcome)
{
    journal::OrderRecord order;
    order.at = QDateTime::currentDateTimeUtc().addDays(-daysAgo);
    order.controller = controller;
    order.action = QString::fromLatin1(robot::key(Act::WriteRegister));
    order.subject = QStringLiteral("M%1").arg(daysAgo, 3, 10, QLatin1Char('0'));
    order.oldValue = QStringLiteral("1");
    order.newValue = QStringLiteral("2");
    order.outcome = outcome;
    order.user = QStringLiteral("maria");
    if (outcome == journal::Outcome::Refused)
        order.added = 0x2130, order.status = 0x1F;
    return order;
}

/// Writes the window, light and dark, to the build folder.
void savePictures(QWidget &window, const QString &name)
{
    QVERIFY(QDir().mkpath(QStringLiteral(PENDESK_PICTURES)));
    for (const auto &[scheme, word] : {std::pair {ui::Scheme::Dark, "dark"}, std::pair {ui::Scheme::Light, "light"}}) {
        ui::apply(*qApp, scheme);
        QCoreApplication::sendPostedEvents();
        QVERIFY(window.grab().save(
            QStringLiteral("%1/%2-%3.png").arg(QStringLiteral(PENDESK_PICTURES), name, QLatin1String(word))));
    }
}

} // namespace

class TestJournalPage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { QLocale::setDefault(QLocale::c()); }

    void everyTryIsThere()
    {
        Desk desk;
        QVERIFY(desk.live(Level::Monitor));
        QTRY_COMPARE(desk.words("journalState"), QStringLiteral("Nothing was tried that fits this filter."));
        const QAbstractItemModelTester tester {desk.rows()};
        desk.cycle(values::CycleMode::Step, "step"); // withheld
        QTRY_COMPARE(desk.rows()->rowCount(), 1);
        QCOMPARE(desk.cell(0, OrderModel::Outcome), QStringLiteral("□ not sent"));
        QCOMPARE(desk.cell(0, OrderModel::Level), QStringLiteral("Monitor"));
        desk.access().enter(Level::Operate);
        QTRY_VERIFY(!desk.window.view().orders().obstacle(Act::SelectCycle));
        desk.cycle(values::CycleMode::Step, "step");
        QTRY_COMPARE(desk.rows()->rowCount(), 2);
        QCOMPARE(desk.cell(0, OrderModel::Outcome), QStringLiteral("✓ done"));
        QCOMPARE(desk.cell(0, OrderModel::Change), QStringLiteral("continuous → step"));
        QCOMPARE(desk.cell(0, OrderModel::Controller), QStringLiteral("CELL 4 · Weld"));
        QCOMPARE(desk.cell(1, OrderModel::Outcome), QStringLiteral("□ not sent"));
        desk.window.view().hold();
        QTRY_COMPARE(desk.rows()->rowCount(), 3);
        QCOMPARE(desk.words("journalState"), QStringLiteral("3 record(s)"));
    }

    void withoutAConnection()
    {
        Desk desk;
        desk.journal.append(record(QStringLiteral("CELL 5"), 0, journal::Outcome::Done));
        desk.window.show();
        desk.window.view().openPage(journalRow());
        QVERIFY(desk.find<widgets::Table>("journalTable")->isVisible());
        QTRY_COMPARE(desk.rows()->rowCount(), 1);
    }

    void filtered()
    {
        Desk desk;
        using journal::Outcome;
        desk.journal.append(record(QStringLiteral("CELL 5"), 40, Outcome::Done));
        desk.journal.append(record(QStringLiteral("CELL 5"), 3, Outcome::Refused));
        desk.journal.append(record(QStringLiteral("CELL 6"), 0, Outcome::Unknown));
        desk.window.show();
        desk.window.view().openPage(journalRow());
        QTRY_COMPARE(desk.rows()->rowCount(), 3);
        QCOMPARE(desk.cell(0, OrderModel::Subject), QStringLiteral("M000")); // the newest first

        auto *controller = desk.find<QComboBox>("journalController");
        QTRY_COMPARE(controller->count(), 3);
        controller->setCurrentText(QStringLiteral("CELL 5"));
        QTRY_COMPARE(desk.rows()->rowCount(), 2);
        desk.find<QComboBox>("journalPeriod")->setCurrentText(QStringLiteral("Last 7 days"));
        QTRY_COMPARE(desk.rows()->rowCount(), 1);
        QVERIFY(desk.cell(0, OrderModel::Reply).startsWith(u"0x2130"));
        controller->setCurrentIndex(0);
        QTRY_COMPARE(desk.rows()->rowCount(), 2);
        desk.find<QComboBox>("journalOutcome")->setCurrentText(QStringLiteral("▲ unknown"));
        QTRY_COMPARE(desk.rows()->rowCount(), 1);
        QCOMPARE(desk.cell(0, OrderModel::Controller), QStringLiteral("CELL 6"));
        desk.find<QComboBox>("journalOutcome")->setCurrentIndex(0);
        desk.find<QComboBox>("journalPeriod")->setCurrentIndex(0);
        QTest::keyClicks(desk.find<QLineEdit>("journalSearch"), QStringLiteral("m040"));
        QTRY_COMPARE(desk.rows()->rowCount(), 1);
        QTest::keyClicks(desk.find<QLineEdit>("journalSearch"), QStringLiteral("%"));
        QTRY_COMPARE(desk.words("journalState"), QStringLiteral("Nothing was tried that fits this filter."));
    }

    void aRecordInFull()
    {
        Desk desk;
        desk.journal.append(record(QStringLiteral("CELL 5"), 3, journal::Outcome::Refused));
        desk.window.show();
        desk.window.view().openPage(journalRow());
        QTRY_COMPARE(desk.rows()->rowCount(), 1);
        auto *table = desk.find<widgets::Table>("journalTable");
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(desk.rows()->index(0, 0)).center());
        QVERIFY(desk.words("journalDetail").contains(u"CELL 5"));
        QVERIFY(desk.words("journalDetail").contains(u"1 → 2"));
        QVERIFY(desk.words("journalDetail").contains(u"0x2130"));
    }

    void exported()
    {
        Desk desk;
        desk.journal.append(record(QStringLiteral("CELL 5"), 3, journal::Outcome::Refused));
        desk.window.show();
        desk.window.view().openPage(journalRow());
        QTRY_COMPARE(desk.rows()->rowCount(), 1);
        QTest::mouseClick(desk.find<QPushButton>("exportJournal"), Qt::LeftButton);
        auto *dialog = desk.window.findChild<QFileDialog *>(QStringLiteral("exportDialog"));
        QVERIFY(dialog);
        const QString path = desk.folder.filePath(QStringLiteral("out.csv"));
        dialog->findChild<QLineEdit *>(QStringLiteral("fileNameEdit"))->setText(path);
        QMetaObject::invokeMethod(dialog, "accept");
        QTRY_VERIFY(QFileInfo::exists(path));
        QFile file {path};
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("write-register,M003,1,2,refused,31,8496,"));
        QTRY_COMPARE(desk.words("journalState"), QStringLiteral("1 record(s) exported."));
    }

    /// To be looked at, in the build folder.
    void pictures_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("large") << QSize(1440, 900);
        QTest::newRow("small") << QSize(1024, 768);
    }

    void pictures()
    {
        QFETCH(const QSize, size);
        Desk desk;
        for (int i = 0; i < 30; ++i)
            desk.journal.append(record(QStringLiteral("CELL 4 · Weld"), i / 7, journal::Outcome(i % 4)));
        desk.window.resize(size);
        QVERIFY(desk.live(Level::Operate));
        QTRY_COMPARE(desk.rows()->rowCount(), 30);
        desk.find<widgets::Table>("journalTable")->selectRow(2);
        savePictures(desk.window, QStringLiteral("journal-%1").arg(size.width()));
    }

    void manyAreReadAsSomebodyScrolls()
    {
        Desk desk;
        for (int i = 0; i < 1200; ++i)
            desk.journal.append(record(QStringLiteral("CELL 5"), i % 300, journal::Outcome::Done));
        desk.window.show();
        desk.window.view().openPage(journalRow());
        QTRY_COMPARE(desk.rows()->rowCount(), OrderModel::pageSize);
        const QAbstractItemModelTester tester {desk.rows()};
        auto *table = desk.find<widgets::Table>("journalTable");
        table->scrollToBottom();
        QTRY_COMPARE(desk.rows()->rowCount(), 2 * OrderModel::pageSize);
        table->scrollToBottom();
        QTRY_COMPARE(desk.rows()->rowCount(), 1200);
        QCOMPARE(desk.words("journalState"), QStringLiteral("1200 record(s)"));
    }
};

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    TestJournalPage test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_journalpage.moc"
