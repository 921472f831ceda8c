// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/preflight.h"
#include "virtualcontroller/filestore.h"

#include <QTest>

using namespace files;
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
    QTest::addColumn<QList<int>>("concerns");
    QTest::addColumn<int>("line"); // of the first
    const auto row = [](const char *title, const char *name, const QByteArray &content, const QList<Concern> &concerns,
                         int line = 0) {
        QList<int> numbers;
        for (const Concern concern : concerns)
            numbers << int(concern);
        QTest::newRow(title) << QByteArray(name) << content << numbers << line;
    };
    using enum Concern;
    row("good", "A.JBI", good, {});
    row("empty", "A.JBI", "", {Empty});
    row("another name", "B.JBI", good, {NameDiffers});
    row("no name", "A.JBI", with("//NAME A\r\n", ""), {BadJobName});
    row("bad name", "A.JBI", with("//NAME A", "//NAME A:B"), {BadJobName});
    row("no NOP", "A.JBI", with("NOP\r\n", ""), {NoNop});
    row("no END", "A.JBI", with("END\r\n", ""), {NoEnd});
    row("no instructions", "A.JBI", with("NOP\r\nMOVJ C00000 VJ=5.00\r\nEND\r\n", ""), {NoNop, NoEnd});
    row("no job", "A.JBI", "HELLO\r\n", {NotAJob});
    row("wrong count", "A.JBI", with("NPOS 1", "NPOS 2"), {WrongPositionCount});
    row("running", "RUN.JBI", with("//NAME A", "//NAME RUN"), {Running});
    row("the header names the running job", "A.JBI", with("//NAME A", "//NAME RUN"), {NameDiffers, Running});
    row("LF", "A.JBI", with("\r\n", "\n"), {LineEndings}, 1);
    row("LF in one line", "A.JBI", with("NOP\r\n", "NOP\n"), {LineEndings}, 14);
    row("no final newline", "A.JBI", good.chopped(2), {NoFinalNewline}, 16);
    row("Shift-JIS in the comment", "A.JBI", with("COMM A", "COMM \x83\x65"), {});
    row("Shift-JIS in an instruction", "A.JBI", with("VJ=5.00", "VJ=5.00\x83\x65"), {OtherCharacters}, 15);
    row("long comment", "A.JBI", with("COMM A", "COMM 123456789012345678901234567890123"), {LongComment});
    row("control character", "A.JBI", with("COMM A", "COMM \x07"), {ControlCharacter}, 11);
    row("system file", "SYSTEM.SYS", "//SYSTEM\r\n", {NotLoadable});
    row("no type", "A", "A\r\n", {NotLoadable});
    row("names", "VARNAME.DAT", "//VARNAME\r\n", {ReplacesNames});
    row("data", "VAR.DAT", "//VAR\r\n", {});
}

void TestPreflight::looks()
{
    QFETCH(QByteArray, name);
    QFETCH(QByteArray, content);
    QFETCH(QList<int>, concerns);
    QFETCH(int, line);
    const auto findings = preflight(*FileName::create(name), content, {"RUN"});
    QList<int> found;
    for (const Finding &finding : findings) {
        found << int(finding.concern);
        QVERIFY(!explain(finding).isEmpty());
    }
    QCOMPARE(found, concerns);
    QCOMPARE(findings.value(0, {Concern::Empty}).line, line);
    if (!mayBeSent(findings))
        return;
    virtualcontroller::Memory memory;
    QCOMPARE(virtualcontroller::filestore::load(memory, name, content), quint16(0));
}

QTEST_GUILESS_MAIN(TestPreflight)

#include "tst_preflight.moc"
