// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/preflight.h"
#include "support/jobs.h"
#include "virtualcontroller/filestore.h"

#include <QTest>

using namespace files;
using inform::Fault;
using inform::Finding;
using values::FileName;

namespace {

const QByteArray good =
    "/JOB\r\n//NAME A\r\n//POS\r\n///NPOS 1,0,0,0,0,0\r\n///TOOL 0\r\n///POSTYPE PULSE\r\n///PULSE\r\n"
    "C00000=0,0,0,0,0,0\r\n//INST\r\n///DATE 2026/01/12 08:30\r\n///COMM A\r\n///ATTR SC,RW\r\n"
    "///GROUP1 RB1\r\nNOP\r\nMOVJ C00000 VJ=5.00\r\nEND\r\n";

QByteArray with(const char *before, const char *after) { return QByteArray(good).replace(before, after); }

} // namespace

/// What is found before a file is sent, and that the controller would have refused it.
class TestPreflight : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void looks_data();
    void looks();
};

void TestPreflight::looks_data()
{
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QList<int>>("faults");
    const auto row = [](const char *title, const char *name, const QByteArray &content, const QList<Fault> &faults) {
        QList<int> numbers;
        for (const Fault fault : faults)
            numbers << int(fault);
        QTest::newRow(title) << QByteArray(name) << content << numbers;
    };
    using enum Fault;
    row("good", "A.JBI", good, {});
    row("relative job", "A.JBR", good, {});
    row("empty", "A.JBI", "", {Empty});
    row("another name", "B.JBI", good, {NameDiffers});
    row("no name", "A.JBI", with("//NAME A\r\n", ""), {BadName});
    row("bad name", "A.JBI", with("//NAME A", "//NAME A:B"), {BadName});
    row("no job", "A.JBI", "HELLO\r\n", {NotAJob});
    row("running", "RUN.JBI", with("//NAME A", "//NAME RUN"), {Running});
    row("the header names the running job", "A.JBI", with("//NAME A", "//NAME RUN"), {NameDiffers, Running});
    row("LF", "A.JBI", with("\r\n", "\n"), {LineFeeds});
    row("no final newline", "A.JBI", good.chopped(2), {NoLastLineEnd});
    row("Shift-JIS in the comment", "A.JBI", with("COMM A", "COMM \x83\x65"), {});
    row("long comment", "A.JBI", with("COMM A", "COMM 123456789012345678901234567890123"), {LongJobComment});
    row("Japanese name", "\x83\x8F\x81[\x83N.JBI", testdata::job(QStringLiteral("cases/%83%8F%81[%83N.JBI")), {});
    row("type in small letters", "lower.jbi", testdata::job(QStringLiteral("cases/lower.jbi")), {LowerCaseType});
    row("system file", "SYSTEM.SYS", "//SYSTEM\r\n", {NotLoadable});
    row("no type", "A", "A\r\n", {NotLoadable});
    row("names", "VARNAME.DAT", "//VARNAME\r\n", {ReplacesNames});
    row("data", "VAR.DAT", "//VAR\r\n", {});
    row("data in LF", "VAR.DAT", "//VAR\n", {LineFeedsInData});
    row("control character in data", "VAR.DAT", "//VAR\x07\r\n", {ControlCharacter});
}

void TestPreflight::looks()
{
    QFETCH(QByteArray, name);
    QFETCH(QByteArray, content);
    const auto findings = preflight(*FileName::create(name), content, {"RUN"});
    QList<int> found;
    for (const Finding &finding : findings) {
        found << int(finding.fault);
        QVERIFY(!explain(finding, protocol::TextCodec {}).isEmpty());
    }
    QTEST(found, "faults");
    if (!mayBeSent(findings))
        return;
    virtualcontroller::Memory memory;
    QCOMPARE(virtualcontroller::filestore::load(memory, name, content), quint16(0));
}

QTEST_GUILESS_MAIN(TestPreflight)

#include "tst_preflight.moc"
