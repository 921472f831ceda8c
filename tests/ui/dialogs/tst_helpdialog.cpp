// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/harness.h"

#include "ui/dialogs/helpdialog.h"
#include "ui/pagecatalog.h"
#include <QDir>
#include <QLabel>
#include <QLineEdit>

using dialogs::HelpDialog;

namespace {

HelpDialog *help(const Harness &harness) { return harness.window.findChild<HelpDialog *>(); }

bool says(const HelpDialog *dialog, const QString &text)
{
    const auto labels = dialog->findChildren<QLabel *>();
    return std::ranges::any_of(
        labels, [&text](const QLabel *label) { return label->isVisible() && label->text() == text; });
}

} // namespace

/// F1 on every page.
class TestHelpDialog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyPageHasHelp_data() { rows(); }
    void everyPageHasHelp();
    void showsThePageInView_data() { rows(); }
    void showsThePageInView();
    void listsEveryKey();
    void samplesAreTheRealOnes();
    void searches();
    void doesNotBlock();

private:
    static void rows();
};

void TestHelpDialog::rows()
{
    QTest::addColumn<int>("row");
    for (int row = 0; row < int(ui::pageCatalog().size()); ++row)
        QTest::newRow(ui::pageCatalog()[std::size_t(row)].id) << row;
}

void TestHelpDialog::everyPageHasHelp()
{
    QFETCH(int, row);
    const QStringList sentences = ui::helpOf(ui::pageCatalog()[std::size_t(row)]);
    QVERIFY(sentences.size() >= 3 && sentences.size() <= 6);
    for (const QString &sentence : sentences)
        QVERIFY2(sentence.endsWith(u'.'), qPrintable(sentence));
    for (const ui::PageKey &key : ui::pageCatalog()[std::size_t(row)].keys)
        QVERIFY2(!ui::shortcutText(key.keys).isEmpty() && !ui::text(key).isEmpty(), key.keys);
}

void TestHelpDialog::showsThePageInView()
{
    QFETCH(int, row);
    Harness harness;
    harness.window.show();
    QVERIFY(QTest::qWaitForWindowActive(&harness.window));
    harness.window.view().openPage(row);
    QTest::keyClick(&harness.window, Qt::Key_F1);
    QTRY_VERIFY(help(harness) && help(harness)->isVisible());
    const ui::PageRow &page = ui::pageCatalog()[std::size_t(row)];
    QCOMPARE(help(harness)->findChild<QLabel *>(QStringLiteral("helpTitle"))->text(), ui::title(page));
    for (const QString &sentence : ui::helpOf(page))
        QVERIFY2(says(help(harness), sentence), qPrintable(sentence));
}

void TestHelpDialog::listsEveryKey()
{
    HelpDialog dialog(0);
    dialog.setAttribute(Qt::WA_DeleteOnClose, false);
    dialog.show();
    for (const ui::ActionRow &row : ui::actionCatalog()) {
        if (*row.shortcut)
            QVERIFY2(says(&dialog, ui::shortcutText(row.shortcut)) && says(&dialog, ui::text(row)), row.name);
    }
    for (const ui::PageRow &row : ui::pageCatalog())
        QVERIFY2(says(&dialog, ui::shortcutText(row.shortcut)), row.id);
}

void TestHelpDialog::samplesAreTheRealOnes()
{
    using robot::Freshness;
    HelpDialog dialog(0);
    dialog.setAttribute(Qt::WA_DeleteOnClose, false);
    QList<Freshness> found;
    for (const auto *sample : dialog.findChildren<widgets::ValueLabel *>())
        found << sample->shown().freshness;
    for (const Freshness freshness : {Freshness::Live, Freshness::Stale, Freshness::Unknown, Freshness::Refused})
        QVERIFY(found.contains(freshness));
}

void TestHelpDialog::searches()
{
    HelpDialog dialog(4);
    dialog.setAttribute(Qt::WA_DeleteOnClose, false);
    dialog.show();
    auto *search = dialog.findChild<QLineEdit *>(QStringLiteral("helpSearch"));
    const auto *nothing = dialog.findChild<QLabel *>(QStringLiteral("helpNothing"));
    QVERIFY(!nothing->isVisible());
    QTest::keyClicks(search, QStringLiteral("CSV"));
    const QStringList sentences = ui::helpOf(ui::pageCatalog()[4]);
    for (const QString &sentence : sentences)
        QCOMPARE(says(&dialog, sentence), sentence.contains(QStringLiteral("CSV")));
    QTest::keyClicks(search, QStringLiteral(" in the moon"));
    QVERIFY(nothing->isVisible());
    search->clear();
    QVERIFY(says(&dialog, sentences.first()));
}

void TestHelpDialog::doesNotBlock()
{
    Harness harness;
    QVERIFY(harness.connectLive());
    harness.window.view().openPage(4);
    harness.window.actions().action(ui::ActionId::Help)->trigger();
    QVERIFY(QTest::qWaitForWindowActive(help(harness)));
    QVERIFY(!help(harness)->isModal());
    QVERIFY(QDir().mkpath(QStringLiteral(PENDESK_PICTURES)));
    for (const ui::Scheme scheme : {ui::Scheme::Dark, ui::Scheme::Light}) {
        ui::apply(*qApp, scheme);
        QCoreApplication::sendPostedEvents();
        const QString word = scheme == ui::Scheme::Light ? QStringLiteral("light") : QStringLiteral("dark");
        QVERIFY(
            help(harness)->grab().save(QStringLiteral("%1/help-%2.png").arg(QStringLiteral(PENDESK_PICTURES), word)));
        auto *scroll = help(harness)->findChild<QWidget *>(QStringLiteral("helpScroll"));
        const QSize before = help(harness)->size();
        help(harness)->resize(640, 1500);
        QCoreApplication::sendPostedEvents();
        QVERIFY(scroll->grab().save(QStringLiteral("%1/help-all-%2.png").arg(QStringLiteral(PENDESK_PICTURES), word)));
        help(harness)->resize(before);
    }
    QTest::keyClick(help(harness)->findChild<QLineEdit *>(), Qt::Key_Pause);
    QTRY_VERIFY(harness.server->memory().status.data2 & values::Status::HeldByCommand);
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TestHelpDialog test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_helpdialog.moc"
