// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/messages.h"
#include <QTest>

using robot::HoldState;
using robot::HoldWord;
using robot::LinkState;
using ui::LinkView;
using widgets::Severity;

Q_DECLARE_METATYPE(ui::LinkView)

class TestMessages : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void notices_data();
    void notices();
};

void TestMessages::notices_data()
{
    QTest::addColumn<LinkView>("link");
    QTest::addColumn<Severity>("severity");
    QTest::addColumn<QString>("begin");
    QTest::addColumn<QString>("end");
    const QDateTime since(QDate(2026, 11, 10), QTime(12, 3, 4));
    const values::Error silence {values::ErrorKind::NoAnswer, 0, 0, {}};
    const values::Error refusal {values::ErrorKind::Refused, 0x1F, 0x2110, {}};
    const auto row = [](const char *name, const LinkView &link, Severity severity, const char *begin, const char *end) {
        QTest::newRow(name) << link << severity << QString::fromUtf8(begin) << QString::fromUtf8(end);
    };
    row("not connected", {LinkState::Disconnected, since, {}, 0, HoldState {HoldWord::Unconfirmed}}, Severity::Notice,
        "", "");
    row("checking", {LinkState::Checking, since, {}, 0, HoldState {}}, Severity::Notice,
        "Checking 192.168.1.31:", "status.");
    row("no answer", {LinkState::Checking, since, silence, 0, HoldState {}}, Severity::Warning,
        "No contact with 192.168.1.31 yet: the controller did not answer", "Checking goes on by itself.");
    row("live", {LinkState::Monitoring, since, {}, 0, HoldState {}}, Severity::Notice, "", "");
    row("held", {LinkState::Monitoring, since, {}, 0, HoldState {HoldWord::HeldByCommand}}, Severity::Notice, "", "");
    row("lost", {LinkState::Lost, since, {}, 1, HoldState {}}, Severity::Warning,
        "Communication lost at 12:03:04 — showing the last values read.", "Reading resumes by itself.");
    row("again", {LinkState::Monitoring, since, {}, 2, HoldState {}}, Severity::Notice,
        "Communication restored at 12:03:04.", "since connecting.");
    row("asked", {LinkState::Monitoring, since, {}, 0, HoldState {HoldWord::Asked, 1}}, Severity::Notice, "", "");
    row("refused", {LinkState::Monitoring, since, {}, 0, HoldState {HoldWord::Refused, 0, refusal}}, Severity::Alarm,
        "HOLD was refused: 0x2110 ", "Use the pendant.");
    row("unconfirmed", {LinkState::Monitoring, since, {}, 0, HoldState {HoldWord::Unconfirmed}}, Severity::Alarm,
        "HOLD not confirmed: use the pendant.", "pendant.");
    row("unconfirmed and lost", {LinkState::Lost, since, {}, 1, HoldState {HoldWord::Unconfirmed}}, Severity::Alarm,
        "HOLD not confirmed: use the pendant. Communication lost at 12:03:04", "Reading resumes by itself.");
}

void TestMessages::notices()
{
    QFETCH(LinkView, link);
    QFETCH(Severity, severity);
    QFETCH(QString, begin);
    QFETCH(QString, end);
    settings::Profile profile;
    profile.host = QStringLiteral("192.168.1.31");
    const auto message = ui::noticeOf(link, profile).message;
    QCOMPARE(message.text.isEmpty(), begin.isEmpty());
    if (message.text.isEmpty())
        return;
    QVERIFY2(message.text.startsWith(begin) && message.text.endsWith(end), qPrintable(message.text));
    QVERIFY(message.severity == severity);
}

QTEST_GUILESS_MAIN(TestMessages)
#include "tst_messages.moc"
