// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/harness.h"
#include "ui/pagecatalog.h"
#include "virtualcontroller/alarms.h"
#include <QAbstractItemView>
#include <QLabel>
#include <QMessageBox>
#include <QToolTip>

namespace {

const QByteArray image = "<img src=/dev/zero>";
const QByteArray bold = "<b>BOLD</b>";

/// Markup in everything that a controller tells.
void spoil(virtualcontroller::Memory &memory)
{
    values::AlarmWithTexts alarm;
    alarm.alarm.code = 4107;
    alarm.alarm.name = values::FixedText<32> {image};
    alarm.extra = values::FixedText<16> {bold};
    alarm.subText = values::FixedText<96> {image + bold};
    virtualcontroller::raiseAlarm(memory, alarm, true);
    memory.files["<B>JOB.JBI"] =
        "/JOB\r\n//NAME <B>JOB\r\n//POS\r\n///NPOS 0,0,0,0,0,0\r\n//INST\r\n///DATE 2026/01/12 "
        "08:30\r\n///COMM "
        + bold + "\r\n///ATTR SC,RW\r\nNOP\r\n'" + image + "\r\nEND\r\n";
    for (auto &text : memory.s)
        text = values::StringVariable32 {values::FixedText<32> {image}};
    for (auto &[instance, system] : memory.systemInformation) {
        system.software = decltype(system.software) {bold};
        system.model = decltype(system.model) {bold};
    }
}

/// The label that shows tool tips.
QLabel *tipLabel()
{
    for (QWidget *widget : QApplication::topLevelWidgets()) {
        if (widget->inherits("QTipLabel") && widget->isVisible())
            return qobject_cast<QLabel *>(widget);
    }
    return nullptr;
}

/// Every tool tip of widgets and models with markup in it.
QStringList tipsWithMarkup(const QWidget &window)
{
    QStringList result;
    const auto keep = [&](const QString &tip) {
        if (Qt::mightBeRichText(tip) || tip.contains(u'<'))
            result << tip;
    };
    for (const QWidget *widget : window.findChildren<QWidget *>())
        keep(widget->toolTip());
    for (const auto *view : window.findChildren<QAbstractItemView *>()) {
        const QAbstractItemModel *model = view->model();
        for (int row = 0; model && row < std::min(model->rowCount(), 60); ++row) {
            for (int column = 0; column < model->columnCount(); ++column)
                keep(model->index(row, column).data(Qt::ToolTipRole).toString());
        }
    }
    result.removeDuplicates();
    return result;
}

} // namespace

/// Text from outside is shown as text: it may look like HTML, and then it would load files, or be read for ever.
class PlainTextTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void toolTipsArePlain();
    void messageBoxesArePlain();
    void everyPageIsPlain();
};

void PlainTextTest::toolTipsArePlain()
{
    QWidget window;
    window.show();
    QToolTip::showText({}, QString::fromLatin1(bold), &window);
    QVERIFY(tipLabel());
    QCOMPARE(tipLabel()->textFormat(), Qt::PlainText);
    QCOMPARE(tipLabel()->text(), QString::fromLatin1(bold));
    QToolTip::hideText();
}

void PlainTextTest::messageBoxesArePlain()
{
    QMessageBox box(QMessageBox::NoIcon, QStringLiteral("Box"), QString::fromLatin1(bold));
    box.setInformativeText(QString::fromLatin1(bold));
    box.show();
    int found = 0;
    for (const QLabel *label : box.findChildren<QLabel *>()) {
        if (label->text() != QLatin1String(bold))
            continue;
        QCOMPARE(label->textFormat(), Qt::PlainText);
        ++found;
    }
    QCOMPARE(found, 2);
}

void PlainTextTest::everyPageIsPlain()
{
    Harness harness;
    QVERIFY(harness.startController());
    spoil(harness.server->memory());
    QVERIFY(harness.connectLive());
    QTRY_VERIFY(harness.state().freshness({robot::Kind::Alarm, 1}) == robot::Freshness::Live);
    QStringList tips;
    for (int row = 0; row < int(ui::pageCatalog().size()); ++row) {
        harness.window.view().openPage(row);
        const auto topics = harness.window.view().page(row)->topics();
        QTRY_VERIFY(std::ranges::all_of(topics, [&](const robot::TopicRange &range) {
            return harness.state().freshness({range.kind, range.first}) != robot::Freshness::Unknown;
        }));
        QCoreApplication::sendPostedEvents();
        for (const QLabel *label : harness.window.findChildren<QLabel *>()) {
            if (label->testAttribute(Qt::WA_WState_Polished) && label->isVisible())
                QVERIFY2(label->textFormat() == Qt::PlainText, qPrintable(label->objectName() + label->text()));
        }
        tips << tipsWithMarkup(harness.window);
    }
    QVERIFY(tips.size() >= 2); // the alarm, the strings
    for (const QString &tip : tips) {
        QToolTip::showText({}, tip, &harness.window);
        QVERIFY2(tipLabel() && tipLabel()->textFormat() == Qt::PlainText, qPrintable(tip));
        QToolTip::hideText();
    }
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    PlainTextTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_plaintext.moc"
